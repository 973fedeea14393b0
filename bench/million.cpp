// SPDX-License-Identifier: Apache-2.0
#include "million.h"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <iterator>

#include "compile/compile.h"
#include "device/choose/choose.h"
#include "import/import.h"

namespace sundog::bench {

namespace {

constexpr double kPiDouble = 3.14159265358979323846;

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

std::string bumpy_sphere_obj(int rings) {
    const int around = 2 * rings;
    std::string text = "o bumpy_sphere\n";
    auto out = std::back_inserter(text);
    const auto vertex = [&](double polar, double azimuth) {
        const double radius = 1 + 0.03 * std::sin(24 * azimuth) * std::sin(24 * polar) * std::sin(polar);
        fmt::format_to(out, "v {:.6f} {:.6f} {:.6f}\n", radius * std::sin(polar) * std::cos(azimuth),
                       radius * std::sin(polar) * std::sin(azimuth), radius * std::cos(polar));
    };
    vertex(0, 0);
    for (int ring = 1; ring < rings; ++ring)
        for (int i = 0; i < around; ++i) vertex(kPiDouble * ring / rings, 2 * kPiDouble * i / around);
    vertex(kPiDouble, 0);
    const auto index = [&](int ring, int i) { return 2 + (ring - 1) * around + i % around; };
    const int last = 2 + (rings - 1) * around;
    for (int i = 0; i < around; ++i) fmt::format_to(out, "f 1 {} {}\n", index(1, i), index(1, i + 1));
    for (int ring = 1; ring + 1 < rings; ++ring) {
        for (int i = 0; i < around; ++i) {
            const int a = index(ring, i), b = index(ring + 1, i), c = index(ring + 1, i + 1), d = index(ring, i + 1);
            fmt::format_to(out, "f {} {} {}\nf {} {} {}\n", a, b, c, a, c, d);
        }
    }
    for (int i = 0; i < around; ++i)
        fmt::format_to(out, "f {} {} {}\n", index(rings - 1, i), last, index(rings - 1, i + 1));
    return text;
}

LoadTimes time_first_picture(const std::filesystem::path& file, const std::string& device, int threads) {
    LoadTimes times;
    times.file_mib = static_cast<double>(std::filesystem::file_size(file)) / (1024.0 * 1024.0);
    auto start = std::chrono::steady_clock::now();
    const scene::Scene scene = import::import_scene(file, {});
    times.import_s = seconds_since(start);

    start = std::chrono::steady_clock::now();
    const auto compiled = compile(scene, {});
    FrameOptions options;
    options.width = 640;
    options.height = 480;
    const Frame frame = make_frame(scene, *compiled, options);
    times.compile_s = seconds_since(start);
    for (const kernel::Geometry& geometry : compiled->geometries)
        if (geometry.kind == kernel::GEOMETRY_TRIANGLES) times.triangles += geometry.primitive_count;

    start = std::chrono::steady_clock::now();
    const auto opened = open_device(device, threads);
    opened->load(compiled);
    times.load_s = seconds_since(start);

    start = std::chrono::steady_clock::now();
    Film film({0, 0, 640, 480});
    opened->render(frame, {film.bounds, 0, 1}, film, StopFlag());
    times.render_s = seconds_since(start);
    return times;
}

}  // namespace sundog::bench
