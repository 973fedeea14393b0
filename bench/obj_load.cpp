// SPDX-License-Identifier: Apache-2.0
// How fast an OBJ file loads: `obj_load FILE [TRIANGLES]`. With TRIANGLES it first writes FILE, a sphere with bumps of
// about that many triangles, with vertex normals and without texture coordinates; then it loads FILE with one thread
// and with all, five times each in turn, and prints the best times.
#include <fmt/core.h>
#include <tbb/global_control.h>
#include <tbb/info.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>

#include "import/obj/obj_import.h"

namespace {

using sundog::Vec3;

/// A grid of 2 * rows * rows quads over the sphere, each cut in two.
void write_bumpy_sphere(const char* file, int triangles) {
    const int rows = std::max(2, static_cast<int>(std::sqrt(triangles / 4.0)));
    const int columns = 2 * rows;
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> out(std::fopen(file, "w"), &std::fclose);
    if (!out) throw std::runtime_error(fmt::format("can't write {}", file));
    const auto point = [&](double row, double column) {
        const double latitude = sundog::kPi * row / rows;
        const double longitude = 2 * sundog::kPi * column / columns;
        const double radius = 1 + 0.03 * std::sin(20 * longitude) * std::sin(20 * latitude);
        return std::array<double, 3>{radius * std::sin(latitude) * std::cos(longitude),
                                     radius * std::sin(latitude) * std::sin(longitude), radius * std::cos(latitude)};
    };
    fmt::print(out.get(), "o bumpy_sphere\n");
    for (int row = 0; row <= rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const auto p = point(row, column);
            fmt::print(out.get(), "v {:.6f} {:.6f} {:.6f}\n", p[0], p[1], p[2]);
        }
    }
    for (int row = 0; row <= rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const auto a = point(std::max(row - 0.5, 0.1), column);
            const auto b = point(std::min(row + 0.5, rows - 0.1), column);
            const auto c = point(std::clamp(row + 0.0, 0.1, rows - 0.1), column - 0.5);
            const auto d = point(std::clamp(row + 0.0, 0.1, rows - 0.1), column + 0.5);
            const Vec3 down{float(b[0] - a[0]), float(b[1] - a[1]), float(b[2] - a[2])};
            const Vec3 along{float(d[0] - c[0]), float(d[1] - c[1]), float(d[2] - c[2])};
            const Vec3 n = normalize(cross(down, along));
            fmt::print(out.get(), "vn {:.4f} {:.4f} {:.4f}\n", n.x, n.y, n.z);
        }
    }
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const int next = (column + 1) % columns;
            const int a = row * columns + column + 1, b = row * columns + next + 1;
            const int c = a + columns, d = b + columns;
            fmt::print(out.get(), "f {0}//{0} {1}//{1} {2}//{2}\nf {0}//{0} {2}//{2} {3}//{3}\n", a, c, d, b);
        }
    }
}

double seconds_to_load(const char* file, std::size_t& triangles) {
    const auto start = std::chrono::steady_clock::now();
    sundog::scene::Scene scene;
    sundog::import::import_obj(file, scene, {});
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    triangles = 0;
    for (const sundog::scene::Object& object : scene.objects)
        triangles += std::get<sundog::Boxed<sundog::scene::Mesh>>(object.shape)->triangles.size();
    return taken.count();
}

void run(const char* file) {
    const double megabytes = static_cast<double>(std::filesystem::file_size(file)) * 1e-6;
    const auto all = static_cast<std::size_t>(tbb::info::default_concurrency());
    std::array<double, 2> best = {1e9, 1e9};
    std::size_t triangles = 0;
    for (int round = 0; round < 5; ++round) {
        for (const std::size_t i : {0U, 1U}) {
            const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, i == 0 ? 1 : all);
            best[i] = std::min(best[i], seconds_to_load(file, triangles));
        }
    }
    fmt::print("{}: {:.1f} MB, {} triangles\n", file, megabytes, triangles);
    fmt::print("  1 thread   {:.3f} s  {:.0f} MB/s\n", best[0], megabytes / best[0]);
    fmt::print("  {} threads  {:.3f} s  {:.0f} MB/s\n", all, best[1], megabytes / best[1]);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 2 || argc > 3) {
        fmt::print(stderr, "usage: obj_load FILE [TRIANGLES]\n");
        return 2;
    }
    try {
        if (argc == 3) write_bumpy_sphere(argv[1], std::atoi(argv[2]));
        run(argv[1]);
    } catch (const std::exception& error) {
        fmt::print(stderr, "{}\n", error.what());
        return 1;
    }
    return 0;
}
