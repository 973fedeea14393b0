// SPDX-License-Identifier: Apache-2.0
#include "import/obj/obj_import.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <random>

#include "base/test_folder.h"
#include "import/obj/obj_build.h"
#include "scene/bounds.h"

namespace sundog::import {
namespace {

using scene::Mesh;

class ObjImport : public testing::Test {
protected:
    scene::Scene import_text(std::string_view text) {
        scene::Scene scene;
        import_obj(folder_.write("model.obj", text), scene, warnings_.sink());
        return scene;
    }
    /// The message that a text raises, with its place: "line:column: message".
    std::string error_of(std::string_view text) {
        try {
            import_text(text);
        } catch (const InputError& error) {
            const Diagnostic& d = error.diagnostic();
            return std::to_string(d.where.line) + ':' + std::to_string(d.where.column) + ": " + d.message;
        }
        return "no error";
    }
    static const Mesh& mesh_of(const scene::Scene& scene, std::size_t object = 0) {
        return *std::get<Boxed<Mesh>>(scene.objects.at(object).shape);
    }
    /// Area of all triangles.
    static float area_of(const Mesh& mesh) {
        float area = 0;
        for (const Mesh::Triangle& t : mesh.triangles) {
            const Vec3 a = mesh.positions.at(t.position[0]);
            area += length(cross(mesh.positions.at(t.position[1]) - a, mesh.positions.at(t.position[2]) - a)) / 2;
        }
        return area;
    }

    TestFolder folder_;
    Warnings warnings_;
};

constexpr std::string_view kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1\nvt 1 1 0\nvt 0 1\nvn 0 0 1\n";

// Catches a corner form whose indices end up in the wrong array.
TEST_F(ObjImport, ReadsAllFaceForms) {
    for (const char* face :
         {"f 1 2 3 4", "f 1/1 2/2 3/3 4/4", "f 1//1 2//1 3//1 4//1", "f 1/1/1 2/2/1 3/3/1 4/4/1",
          "f -4/-4/-1 -3/-3/-1 -2/-2/-1 -1/-1/-1", "fo 1 2 3 4", "f 1 2 \\\n 3 4", "f\t1 2 3 4 \r"}) {
        const scene::Scene scene = import_text(std::string(kSquare) + face + "\n");
        const Mesh& mesh = mesh_of(scene);
        ASSERT_EQ(mesh.triangles.size(), 2U) << face;
        EXPECT_FLOAT_EQ(area_of(mesh), 1) << face;
        const bool has_texcoords = std::string_view(face).find("1/1") != std::string_view::npos || face[2] == '-';
        const bool has_normals = std::string_view(face).find("/1 ") != std::string_view::npos && face[3] == '/' &&
                                 (face[4] == '/' || std::string_view(face).find("1/1/1") != std::string_view::npos);
        EXPECT_EQ(mesh.triangles[0].texcoord[2] != scene::kNone, has_texcoords) << face;
        EXPECT_EQ(mesh.triangles[0].normal[2] != scene::kNone, has_normals || face[2] == '-') << face;
        if (has_texcoords) {
            EXPECT_EQ(mesh.texcoords.at(mesh.triangles[0].texcoord[2]), (Vec2{1, 1})) << face;
        }
    }
    EXPECT_TRUE(warnings_.texts.empty());
}

// Catches negative indices that count from the file's end, or from a chunk's.
TEST_F(ObjImport, NegativeIndicesCountFromWhereTheyStand) {
    const scene::Scene scene =
        import_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 0 0 9\nv 1 0 9\nv 0 1 9\nf -3 -2 -1\n");
    const Mesh& mesh = mesh_of(scene);
    EXPECT_EQ(mesh.positions.at(mesh.triangles.at(0).position[0]), (Vec3{0, 0, 0}));
    EXPECT_EQ(mesh.positions.at(mesh.triangles.at(1).position[0]), (Vec3{0, 0, 9}));
}

// Catches objects that are split by groups, groups that are lost where there is no object, and vertices of one object
// that stretch another's bounds.
TEST_F(ObjImport, ObjectsOrGroupsMakeTheObjects) {
    const std::string square(kSquare);
    const scene::Scene objects =
        import_text(square + "o left\ng a\nf 1 2 3\ng b\nf 1 2 4\no right\nf 2 3 4\no left\nf 1 3 4\n");
    ASSERT_EQ(objects.objects.size(), 2U);
    EXPECT_EQ(objects.objects[0].name, "left");
    EXPECT_EQ(objects.objects[0].where.line, 10U);
    EXPECT_EQ(mesh_of(objects, 0).triangles.size(), 3U);
    EXPECT_EQ(mesh_of(objects, 1).triangles.size(), 1U);
    const scene::Scene groups = import_text(square + "f 1 2 3\ng upper half\nf 1 3 4\nv 9 9 9\n");
    ASSERT_EQ(groups.objects.size(), 2U);
    EXPECT_EQ(groups.objects[0].name, "model");
    EXPECT_EQ(groups.objects[1].name, "upper half");
    EXPECT_EQ(mesh_of(groups, 1).positions.size(), 3U);
    EXPECT_EQ(scene::bounds_of(groups.objects[1]).upper, (Vec3{1, 1, 0}));
}

// Catches smoothing across groups, or none: two squares at a right angle share an edge.
TEST_F(ObjImport, SmoothsWithinSmoothingGroups) {
    const std::string corner = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 1 0 1\nv 1 1 1\n";
    const auto normal_at_edge = [](const scene::Scene& scene) {
        const Mesh& mesh = mesh_of(scene);
        return mesh.normals.at(mesh.triangles.at(0).normal[1]);
    };
    const Vec3 smooth = normal_at_edge(import_text(corner + "s 1\nf 1 2 3 4\nf 2 5 6 3\n"));
    EXPECT_NEAR(smooth.x, -std::sqrt(0.5F), 1e-6F);
    EXPECT_NEAR(smooth.z, std::sqrt(0.5F), 1e-6F);
    EXPECT_EQ(normal_at_edge(import_text(corner + "s 1\nf 1 2 3 4\ns 2\nf 2 5 6 3\n")), (Vec3{0, 0, 1}));
    for (const char* off : {"", "s off\n", "s 0\n"}) {
        const scene::Scene flat = import_text(corner + off + "f 1 2 3 4\nf 2 5 6 3\n");
        EXPECT_EQ(mesh_of(flat).triangles.at(0).normal[0], scene::kNone) << off;
    }
    // The angle counts, not the number of triangles: one square cut in two weighs like the other.
    const Vec3 cut = normal_at_edge(import_text(corner + "s 1\nf 1 2 3\nf 1 3 4\nf 2 5 6 3\n"));
    EXPECT_NEAR(cut.x, -std::sqrt(0.5F), 1e-6F);
}

// Catches materials that leak from one face to another, and a library whose name holds a blank.
TEST_F(ObjImport, FindsMaterialsInSeveralLibraries) {
    folder_.write("first one.mtl", "newmtl red\nKd 1 0 0\nnewmtl both\nKd 1 1 1\n");
    folder_.write("sub/second.mtl", "newmtl blue\nKd 0 0 1\nnewmtl both\nKd 0 0 0\n");
    const scene::Scene scene =
        import_text("mtllib first one.mtl sub\\second.mtl\n" + std::string(kSquare) +
                    "f 1 2 3\nusemtl red\nf 1 2 3\nusemtl blue\nf 1 2 3\nusemtl both\nf 1 2 3\n");
    const auto diffuse = [&](std::size_t triangle) {
        return scene.materials.at(mesh_of(scene).triangles.at(triangle).material).mtl->diffuse;
    };
    EXPECT_EQ(diffuse(0), (Vec3{0.8F, 0.8F, 0.8F}));
    EXPECT_EQ(diffuse(1), (Vec3{1, 0, 0}));
    EXPECT_EQ(diffuse(2), (Vec3{0, 0, 1}));
    EXPECT_EQ(diffuse(3), (Vec3{1, 1, 1})) << "the first library that has a material counts";
    EXPECT_TRUE(warnings_.texts.empty()) << warnings_.texts.front();
    ASSERT_EQ(scene.files.size(), 3U);
}

// Catches silence, or a flood, where something is missing.
TEST_F(ObjImport, MissingThingsAreNamedOnceAndShown) {
    const scene::Scene scene =
        import_text("mtllib lost.mtl\nmtllib lost.mtl\nmtllib model.obj\n" + std::string(kSquare) +
                    "usemtl gone\nf 1 2 3\nusemtl gone\nf 1 2 3\nl 1 2\nl 2 3\np 1\n");
    EXPECT_EQ(scene.materials.at(mesh_of(scene).triangles.at(0).material).mtl->diffuse, (Vec3{1, 0, 1}));
    EXPECT_EQ(warnings_.texts, (std::vector<std::string>{
                                   "17: 'l' statements are not drawn", "19: 'p' statements are not drawn",
                                   "1: missing material library 'lost.mtl'",
                                   "3: the file names itself as its material library", "13: missing material 'gone'"}));
}

// Catches errors that are located in another line or column, or not raised.
TEST_F(ObjImport, LocatesErrors) {
    const std::string square(kSquare);
    EXPECT_EQ(error_of("v 0 0 nan\n"), "1:7: bad number 'nan'");
    EXPECT_EQ(error_of("v 0 0 1e999\n"), "1:7: number out of range: '1e999'");
    EXPECT_EQ(error_of("v 0 0\n"), "1:6: the line ends too early");
    EXPECT_EQ(error_of("v 0 0 0 1 1\n"), "1:9: a vertex of five numbers");
    EXPECT_EQ(error_of("\nv\n"), "2:2: the line ends too early");
    EXPECT_EQ(error_of("vn 1 2 3 4\n"), "1:10: unexpected '4' at the end of the line");
    EXPECT_EQ(error_of(square + "f 1 2\n"), "10:1: a face of 2 corners");
    EXPECT_EQ(error_of(square + "f 0 1 2\n"), "10:3: index 0");
    EXPECT_EQ(error_of(square + "f 1 2 5\n"), "10:7: there is no vertex 5");
    EXPECT_EQ(error_of(square + "f 1/9 2/1 3/1\n"), "10:3: there is no texture vertex 9");
    EXPECT_EQ(error_of(square + "f 1//2 2//1 3//1\n"), "10:3: there is no normal 2");
    EXPECT_EQ(error_of(square + "f -5 -1 -2\n"), "10:3: the negative index of a vertex reaches before the first one");
    EXPECT_EQ(error_of(square + "f 1 \\\n 2 x\n"), "11:4: bad corner 'x'");
    EXPECT_EQ(error_of(square + "f 1/ 2 3\n"), "10:5: bad corner '1/'");
    EXPECT_EQ(error_of(square + "f 4000000000 2 3\n"), "10:3: index out of range: '4000000000'");
    EXPECT_EQ(error_of(square + "s many\n"), "10:3: bad smoothing group 'many'");
    EXPECT_EQ(error_of("<html>\n</html>\n"), "1:1: not an OBJ file: none of its lines is an OBJ statement");
    EXPECT_EQ(error_of(square + "f 1 2 3\nf 1 2 9\nv x\n"), "11:7: there is no vertex 9");
}

/// Triangles and quads in many objects, with materials, smoothing and indices of all kinds.
std::string random_obj(int seed, int statements) {
    std::mt19937 random(static_cast<unsigned>(seed));
    const auto below = [&](unsigned n) { return static_cast<int>(random() % n); };
    std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvt 0 0\nvn 0 0 1\n";
    int vertices = 4;
    for (int i = 0; i < statements; ++i) {
        switch (below(8)) {
            case 0:
                text += "o object" + std::to_string(below(5)) + "\n";
                break;
            case 1:
                text += "usemtl material" + std::to_string(below(3)) + "\n";
                break;
            case 2:
                text += "s " + std::to_string(below(3)) + "\n";
                break;
            case 3:
                text += "# a comment that ends in a backslash \\\n";
                break;
            case 4:
            case 5:
                text += "v " + std::to_string(below(1000)) + ".5 -" + std::to_string(below(1000)) + "e-1 " +
                        std::to_string(below(9)) + "\n";
                ++vertices;
                break;
            default:
                text += "f";
                for (int corner = 3 + below(3); corner > 0; --corner) {
                    const int v = below(static_cast<unsigned>(vertices));
                    text += ' ' + std::to_string(below(2) == 0 ? v + 1 : v - vertices);
                    if (corner == 2 && below(4) == 0) text += " \\\r\n";
                }
                text += '\n';
        }
    }
    return text;
}

bool same(const Mesh& a, const Mesh& b) {
    const auto same_triangle = [](const Mesh::Triangle& s, const Mesh::Triangle& t) {
        return std::equal(s.position, s.position + 3, t.position) && std::equal(s.normal, s.normal + 3, t.normal) &&
               std::equal(s.texcoord, s.texcoord + 3, t.texcoord) && s.material == t.material;
    };
    return a.positions == b.positions && a.normals == b.normals && a.texcoords == b.texcoords &&
           std::equal(a.triangles.begin(), a.triangles.end(), b.triangles.begin(), b.triangles.end(), same_triangle);
}

// Catches state (vertex counts, lines) that gets lost between chunks: any chunk size gives the same numbers.
TEST(ObjScan, ChunksDontShow) {
    for (int seed = 0; seed < 20; ++seed) {
        const SourceText source = text_in_memory("random.obj", random_obj(seed, 200));
        const ObjFile whole = scan_obj_file(source, std::size_t{1} << 30U);
        ASSERT_EQ(whole.chunks.size(), 1U);
        for (const std::size_t chunk_bytes : {1U, 7U, 100U, 1000U}) {
            const ObjFile cut = scan_obj_file(source, chunk_bytes);
            std::vector<ObjCorner> corners;
            for (const ObjChunk& chunk : cut.chunks)
                corners.insert(corners.end(), chunk.corners.begin(), chunk.corners.end());
            const auto same_corner = [](const ObjCorner& a, const ObjCorner& b) { return a.position == b.position; };
            EXPECT_TRUE(std::equal(corners.begin(), corners.end(), whole.chunks[0].corners.begin(),
                                   whole.chunks[0].corners.end(), same_corner));
            EXPECT_EQ(cut.starts.back().line, whole.starts.back().line);
        }
    }
}

// Catches an error message that depends on the chunk that comes first: always the first bad line of the file.
TEST(ObjScan, TheFirstBadLineIsReported) {
    for (int seed = 0; seed < 40; ++seed) {
        std::string text = random_obj(seed, 100);
        std::vector<std::string> lines;
        std::mt19937 random(static_cast<unsigned>(seed));
        std::size_t at = text.size() / 3;
        for (const char* bad : {"f 1 2 77777\n", "v 1 2 three\n", "f 0 1 2\n"}) {
            // Not behind a backslash, where it would continue a line.
            do at = text.find('\n', at + random() % 200) + 1;
            while (at >= 2 && at < text.size() && (text[at - 2] == '\\' || text[at - 2] == '\r'));
            if (at == 0) break;
            text.insert(at, bad);
        }
        const SourceText source = text_in_memory("random.obj", text);
        const auto message = [&](std::size_t chunk_bytes) -> std::string {
            try {
                scan_obj_file(source, chunk_bytes);
            } catch (const InputError& error) {
                return error.what();
            }
            return "no error";
        };
        const std::string expected = message(std::size_t{1} << 30U);
        EXPECT_NE(expected, "no error");
        for (const std::size_t chunk_bytes : {1U, 50U, 300U}) EXPECT_EQ(message(chunk_bytes), expected);
    }
}

// Catches results that depend on the number of threads.
TEST_F(ObjImport, ThreadsDontShow) {
    std::string text = random_obj(1, 200000);
    std::vector<scene::Scene> scenes;
    for (const std::size_t threads : {1U, 4U}) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        scenes.push_back(import_text(text));
    }
    ASSERT_EQ(scenes[0].objects.size(), scenes[1].objects.size());
    for (std::size_t i = 0; i < scenes[0].objects.size(); ++i) {
        EXPECT_EQ(scenes[0].objects[i].name, scenes[1].objects[i].name);
        EXPECT_TRUE(same(mesh_of(scenes[0], i), mesh_of(scenes[1], i)));
    }
}

}  // namespace
}  // namespace sundog::import
