// SPDX-License-Identifier: Apache-2.0
#include "bench/refinement.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "compile/compile.h"
#include "device/choose/choose.h"
#include "film_image.h"
#include "gallery.h"
#include "import/import.h"
#include "output/compare.h"
#include "session/session.h"
#include "statistics.h"

namespace sundog::bench {
namespace {

constexpr int kSizes[][2] = {{640, 480}, {1920, 1080}};
constexpr double kSpan_s = 8;

template <class Work>
double seconds_of(const Work& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

void run_refinement(const RefinementOptions& options, const std::function<void(const RefinementTiming&)>& done,
                    const StopFlag& stop) {
    const std::filesystem::path gallery = options.gallery.empty() ? SUNDOG_GALLERY : options.gallery;
    const int threads =
        options.threads > 0 ? options.threads : static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    for (const std::string name : kGalleryScenes) {
        if (!options.scene.empty() && options.scene != name) continue;
        const scene::Scene scene = import::import_scene(gallery / name / (name + ".scene"), {});
        const std::shared_ptr<const RenderScene> compiled = compile(scene, {});
        Session session(open_device("cpu", threads));
        session.load(compiled);
        for (const auto& size : kSizes) {
            if (stop.requested()) return;
            RefinementTiming timing{.scene = name, .width = size[0], .height = size[1]};
            timing.worst_psnr_db = 1e9;
            Film traced({0, 0, size[0], size[1]});
            Film refined = traced;
            std::vector<double> traced_s, refined_s;
            double points = 0, pixels = 0, traced_rays = 0, refined_rays = 0;
            int compared = 0;
            for (int number = -1; number < options.frames && !stop.requested(); ++number) {
                FrameOptions frame_options;
                frame_options.width = size[0];
                frame_options.height = size[1];
                frame_options.time_s = static_cast<float>(kSpan_s * std::max(number, 0) / options.frames);
                RenderStats full, fewer;
                const double full_s = seconds_of([&] {
                    full = session.render_into(make_frame(scene, *compiled, frame_options), 0, 1, traced, stop);
                });
                const double fewer_s = seconds_of([&] {
                    fewer = session.refine_into(make_frame(scene, *compiled, frame_options), options.tolerance, 1,
                                                refined, stop, options.method);
                });
                if (number < 0 || !full.complete || !fewer.complete) continue;  // the first warms caches and threads
                traced_s.push_back(full_s);
                refined_s.push_back(fewer_s);
                points += static_cast<double>(fewer.points);
                pixels += static_cast<double>(traced.radiance.size());
                traced_rays += static_cast<double>(full.rays);
                refined_rays += static_cast<double>(fewer.rays);
                // Comparing takes much longer than rendering.
                if (number % 6 != 0) continue;
                const output::Comparison c = output::compare(image_of(traced), image_of(refined));
                const double psnr_db = std::min(c.psnr_db, 99.0);
                timing.psnr_db += psnr_db;
                timing.worst_psnr_db = std::min(timing.worst_psnr_db, psnr_db);
                timing.ssim += c.ssim;
                timing.flip += c.flip;
                ++compared;
            }
            if (compared == 0) return;
            timing.traced_s = median(traced_s);
            timing.refined_s = median(refined_s);
            timing.pixels_per_point = pixels / points;
            timing.rays_ratio = traced_rays / refined_rays;
            timing.psnr_db /= compared;
            timing.ssim /= compared;
            timing.flip /= compared;
            done(timing);
        }
    }
}

std::string refinement_head() {
    return fmt::format("{:<9} {:>9} | {:>9} {:>9} {:>6} {:>8} | {:>9} {:>6} | {:>7} {:>7} {:>6} {:>6}\n", "scene",
                       "size", "traced ms", "refined", "ratio", "frames/s", "pix/point", "rays", "PSNR dB", "worst",
                       "SSIM", "FLIP");
}

std::string refinement_row(const RefinementTiming& t) {
    return fmt::format(
        "{:<9} {:>9} | {:>9.2f} {:>9.2f} {:>6.2f} {:>8.1f} | {:>9.2f} {:>6.2f} | {:>7.2f} {:>7.2f} {:>6.4f} {:>6.4f}\n",
        t.scene, fmt::format("{}x{}", t.width, t.height), t.traced_s * 1e3, t.refined_s * 1e3, t.traced_s / t.refined_s,
        1 / t.refined_s, t.pixels_per_point, t.rays_ratio, t.psnr_db, t.worst_psnr_db, t.ssim, t.flip);
}

}  // namespace sundog::bench
