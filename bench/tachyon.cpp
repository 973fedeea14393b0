// SPDX-License-Identifier: Apache-2.0
#include "tachyon.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <memory>

#include "base/diagnostics.h"

namespace sundog::bench {

namespace {

using Text = std::back_insert_iterator<std::string>;

float largest(const kernel::vec3& color) { return std::max({color.x, color.y, color.z}); }

std::string point(const kernel::vec3& p) { return fmt::format("{} {} {}", -p.x, p.y, p.z); }

void write_material(Text out, std::size_t index, const kernel::Material& m) {
    const float diffuse = largest(m.diffuse), mirror = largest(m.reflectance), opacity = 1 - largest(m.transmittance);
    const float scale = diffuse > 0 ? 1 / diffuse : 0;
    fmt::format_to(out,
                   "TEXDEF m{} AMBIENT {} DIFFUSE {} SPECULAR {} OPACITY {} PHONG PLASTIC {} PHONG_SIZE {} "
                   "COLOR {} {} {} TEXFUNC 0\n",
                   index, 0.2F * diffuse, diffuse * (1 - mirror), mirror, opacity, largest(m.specular),
                   std::max(m.shininess, 1.0F), m.diffuse.x * scale, m.diffuse.y * scale, m.diffuse.z * scale);
}

void write_camera(Text out, const Frame& frame) {
    const kernel::Camera& camera = frame.params.camera;
    const float to_window = std::hypot(camera.center.x, camera.center.y, camera.center.z);
    const float half_height = std::hypot(camera.up.x, camera.up.y, camera.up.z);
    // At zoom 1 Tachyon's window is 1 high at distance 1.
    fmt::format_to(out,
                   "RESOLUTION {} {}\nCAMERA\n ZOOM {}\n ASPECTRATIO 1.0\n ANTIALIASING 0\n RAYDEPTH {}\n"
                   " CENTER {}\n VIEWDIR {}\n UPDIR {}\nEND_CAMERA\n",
                   frame.params.width, frame.params.height, 0.5F * to_window / half_height, frame.params.max_depth + 1,
                   point(camera.eye), point(camera.center), point(camera.up));
}

void write_light(Text out, const kernel::Light& light) {
    const bool sun = light.kind == kernel::LIGHT_SUN;
    const kernel::vec3 from_sun(-light.place.x, -light.place.y, -light.place.z);
    if (sun) fmt::format_to(out, "DIRECTIONAL_LIGHT DIRECTION {}", point(from_sun));
    else fmt::format_to(out, "LIGHT CENTER {} RAD 0.001", point(light.place));
    fmt::format_to(out, " COLOR {} {} {}\n", light.color.x, light.color.y, light.color.z);
}

void write_triangle(Text out, const RenderScene& scene, std::uint32_t i) {
    const kernel::Triangle& t = scene.triangles[i];
    const bool smooth = (scene.features & kernel::FEATURE_SMOOTH) != 0 && scene.triangle_normals[i].a != kernel::NONE;
    fmt::format_to(out, "{} V0 {} V1 {} V2 {}", smooth ? "STRI" : "TRI", point(scene.positions[t.p0]),
                   point(scene.positions[t.p1]), point(scene.positions[t.p2]));
    if (smooth) {
        const kernel::TriangleCorners& n = scene.triangle_normals[i];
        fmt::format_to(out, " N0 {} N1 {} N2 {}", point(scene.normals[n.a]), point(scene.normals[n.b]),
                       point(scene.normals[n.c]));
    }
    fmt::format_to(out, " m{}\n", t.material);
}

}  // namespace

std::string tachyon_scene(const RenderScene& scene, const Frame& frame) {
    std::string text = "BEGIN_SCENE\n";
    const Text out(text);
    write_camera(out, frame);
    const kernel::vec3& sky = frame.params.sky;
    fmt::format_to(out, "BACKGROUND {} {} {}\n", sky.x, sky.y, sky.z);
    for (std::size_t i = 0; i < scene.materials.size(); ++i) write_material(out, i, scene.materials[i]);
    for (std::uint32_t i = 0; i < frame.params.light_count; ++i) write_light(out, frame.lights[i]);
    for (const kernel::Geometry& geometry : scene.geometries) {
        for (std::uint32_t k = 0; k < geometry.primitive_count; ++k) {
            const std::uint32_t i = geometry.first_primitive + k;
            if (geometry.instance != kernel::NONE) throw DeviceError("the Tachyon export takes no moving objects");
            if (geometry.kind == kernel::GEOMETRY_TRIANGLES) {
                write_triangle(out, scene, i);
            } else if (geometry.kind == kernel::GEOMETRY_SPHERE) {
                const kernel::Sphere& s = scene.spheres[i];
                fmt::format_to(out, "SPHERE CENTER {} RAD {} m{}\n", point(s.center), s.radius, s.material);
            } else {
                throw DeviceError("the Tachyon export takes triangles and spheres only");
            }
        }
    }
    return text + "END_SCENE\n";
}

std::optional<double> tachyon_seconds(std::string_view report) {
    constexpr std::string_view label = "Ray Tracing Time:";
    std::size_t at = report.find(label);
    if (at == std::string_view::npos) return std::nullopt;
    at = report.find_first_not_of(' ', at + label.size());
    if (at == std::string_view::npos) return std::nullopt;
    double seconds = 0;
    const auto [end, error] = std::from_chars(report.data() + at, report.data() + report.size(), seconds);
    return error == std::errc() ? std::optional(seconds) : std::nullopt;
}

std::optional<double> run_tachyon(const std::filesystem::path& scene_file, int width, int height, int threads) {
    std::string quoted = "'";
    for (const char c : scene_file.string()) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    const std::string command =
        fmt::format("tachyon {}' +V -res {} {} -nosave -numthreads {} 2>/dev/null", quoted, width, height, threads);
    struct Close {
        void operator()(std::FILE* pipe) const { pclose(pipe); }
    };
    const std::unique_ptr<std::FILE, Close> pipe(popen(command.c_str(), "r"));
    if (!pipe) return std::nullopt;
    std::string report;
    char buffer[4096];
    for (std::size_t n = 0; (n = std::fread(buffer, 1, sizeof buffer, pipe.get())) > 0;) report.append(buffer, n);
    return tachyon_seconds(report);
}

}  // namespace sundog::bench
