// SPDX-License-Identifier: Apache-2.0
// Damaged files: whatever the bytes, an importer either gives a valid scene or raises InputError.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <random>

#include "base/test_folder.h"
#include "import/import.h"
#include "scene/validate.h"

namespace sundog::import {
namespace {

std::string read_gallery(const std::string& name) {
    std::ifstream in(std::filesystem::path(SUNDOG_SOURCE_DIR) / "scenes" / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// A short OBJ file with a bit of everything.
constexpr const char* kObj =
    "# all forms\nmtllib a.mtl\no one\nv 0 0 0\nv 1 0 0 1\nv 1 1 0 0.5 0.5 0.5\nv 0 1 0\nv 0.5 0.5 1e-3\nvt 0 0\nvt 1 "
    "0 0\n"
    "vt 1\nvn 0 0 1\ns 1\nusemtl red\nf 1 2 3\nf 1/1 2/2 3/3\nf 1//1 2//1 3//1\nf -1/-1/-1 -2/-2/-1 -3/-3/-1\n"
    "s off\ng part\\ \nf 1 2 5 3 \\\n 4\no two\nusemtl lost\nf 1 2 3 4\nl 1 2\nbmat u 1 2\n";
constexpr const char* kMtl =
    "newmtl red\nKa 0 0 0\nKd 1 0 0\nKs xyz 0.1 0.2 0.3\nNs 10\nNi 1.5\nd 0.5\nTf 1 1 1\nillum 7\nPr 0.5\n"
    "checker_Kd 4 4 0 0 0\nhighlight phong\nmap_Kd -s 1 2 3 -o 0 -clamp on lost.png\nbump -bm 2 lost.png\n";
constexpr const char* kScene =
    "model = a.obj\nfocus = 24\nrotX = wave 1 2 3\nrotZ = linear 20\ndistance = 8.6\norigin = 0 0 0.5\nsky = 0.1 0.2 "
    "0.3\n"
    "light = lamp wave\nlightPos = 0 0 5\nlightSpeed = 1 1 1\nlightAmplitude = 1 1 1\nmtllib = a.mtl\n"
    "sphere = ball red 0 0 0 1\nbox = crate red 0 0 0 1 1 1\nplane = floor red 0 0 1 0\n"
    "motion = ball move 1 1 1 2 2 2\nmotion = one rotZ linear 9\nwidth = 64\n";

class Noise : public testing::Test {
protected:
    /// Imports `name` with one file's bytes replaced. Anything but a scene or an InputError ends the test.
    void import_with(const std::string& entry, const std::string& damaged, const std::string& bytes) {
        folder_.write(damaged, bytes);
        try {
            scene::validate(import_scene(folder_.path() / entry, {}));
            ++loaded_;
        } catch (const InputError& error) {
            ++refused_;
            EXPECT_FALSE(error.diagnostic().message.empty());
        }
        folder_.write(damaged, damaged == "a.obj" ? kObj : damaged == "a.mtl" ? kMtl : kScene);
    }
    void write_all() const {
        folder_.write("a.obj", kObj);
        folder_.write("a.mtl", kMtl);
        folder_.write("a.scene", kScene);
    }

    TestFolder folder_;
    int loaded_ = 0, refused_ = 0;
};

// Catches reads behind the end of a file that stops in the middle of anything.
TEST_F(Noise, Truncations) {
    write_all();
    for (const auto& [name, bytes] :
         {std::pair<std::string, std::string>{"a.obj", kObj}, {"a.mtl", kMtl}, {"a.scene", kScene}}) {
        for (std::size_t size = 0; size < bytes.size(); ++size) import_with("a.scene", name, bytes.substr(0, size));
    }
    EXPECT_GT(loaded_, 100);
    EXPECT_GT(refused_, 100);
}

// Catches crashes on damaged bytes: flips, losses, doublings and foreign pieces, three thousand of them.
TEST_F(Noise, DamagedBytes) {
    write_all();
    std::mt19937 random(20240229);
    const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random()) % n; };
    const std::vector<std::string> pieces = {"-",
                                             "9999999999",
                                             "1e999",
                                             "nan",
                                             "/",
                                             "\\",
                                             "\n",
                                             "\"",
                                             "#",
                                             "=",
                                             "0 ",
                                             "\r\n",
                                             "-2147483648",
                                             "f 1 2 3\n",
                                             "v 1e30 -1e30 1e30\n",
                                             std::string(5000, '7')};
    for (int i = 0; i < 3000; ++i) {
        const bool obj = i % 3 == 0, mtl = i % 3 == 1;
        std::string bytes = obj ? kObj : mtl ? kMtl : kScene;
        for (std::size_t damage = 1 + below(4); damage > 0; --damage) {
            const std::size_t at = below(bytes.size());
            switch (below(4)) {
                case 0:
                    bytes[at] = static_cast<char>(bytes[at] ^ (1 << below(8)));
                    break;
                case 1:
                    bytes.erase(at, 1 + below(8));
                    break;
                case 2:
                    bytes.insert(at, bytes.substr(below(bytes.size()), below(30)));
                    break;
                default:
                    bytes.insert(at, pieces[below(pieces.size())]);
            }
            if (bytes.empty()) bytes = "\n";
        }
        import_with(i % 2 == 0 ? "a.scene"
                    : obj      ? "a.obj"
                               : "a.scene",
                    obj   ? "a.obj"
                    : mtl ? "a.mtl"
                          : "a.scene",
                    bytes);
    }
    EXPECT_GT(loaded_, 100);
    EXPECT_GT(refused_, 100);
}

// Catches crashes on what is no text at all.
TEST_F(Noise, RandomBytes) {
    std::mt19937 random(99);
    write_all();
    for (int i = 0; i < 1000; ++i) {
        std::string bytes(random() % 300, '\0');
        for (char& c : bytes) c = static_cast<char>(i % 2 == 0 ? random() : 32 + random() % 96);
        import_with("a.scene", i % 3 == 0 ? "a.obj" : i % 3 == 1 ? "a.mtl" : "a.scene", bytes);
    }
    EXPECT_GT(refused_, 100);
}

// Catches damage that only shows in a real model: bytes of the gallery's table flipped.
TEST_F(Noise, DamagedGallery) {
    const std::string obj = read_gallery("table/table.obj");
    ASSERT_FALSE(obj.empty());
    folder_.write("table.mtl", read_gallery("table/table.mtl"));
    std::mt19937 random(4);
    for (int i = 0; i < 100; ++i) {
        std::string bytes = obj;
        for (int flips = 0; flips < 3; ++flips) {
            char& c = bytes[random() % bytes.size()];
            c = static_cast<char>(c ^ (1 << (random() % 8)));
        }
        import_with("table.obj", "table.obj", bytes);
    }
    EXPECT_EQ(refused_ + loaded_, 100);
}

}  // namespace
}  // namespace sundog::import
