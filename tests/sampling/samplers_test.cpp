// SPDX-License-Identifier: Apache-2.0
// Ways to sample whole pictures, on the CPU device.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "compile/compile.h"
#include "device/cpu/cpu_device.h"
#include "import/import.h"
#include "output/compare.h"
#include "output/image.h"
#include "session/session.h"

namespace sundog {
namespace {

constexpr int kWidth = 83, kHeight = 61;  // no multiples of anything

struct Loaded {
    scene::Scene scene;
    std::shared_ptr<const RenderScene> compiled;
    [[nodiscard]] Frame frame(const kernel::PixelSampling& sampling = {}) const {
        FrameOptions options;
        options.width = kWidth;
        options.height = kHeight;
        options.sampling = sampling;
        return make_frame(scene, *compiled, options);
    }
};

Loaded load(const std::filesystem::path& file) {
    Loaded loaded;
    loaded.scene = import::import_scene(file, {});
    loaded.compiled = compile(loaded.scene, {});
    return loaded;
}

Loaded gallery(const std::string& name) {
    return load(std::filesystem::path(SUNDOG_SOURCE_DIR) / "scenes" / name / (name + ".scene"));
}

Session session_with(const Loaded& loaded, int threads = 2) {
    Session session(make_cpu_device({.threads = threads, .lanes = 0}));
    session.load(loaded.compiled);
    return session;
}

output::Image image_of(const Film& film) {
    output::Image image(kWidth, kHeight);
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) image.at(x, y) = film.mean(x, y);
    return image;
}

Film rendered(Session& session, const Loaded& loaded, const kernel::PixelSampling& sampling, std::uint32_t samples) {
    return session.render(loaded.frame(sampling), samples, {}, StopFlag{}).film;
}

// Catches weights that don't cancel (noise where nothing changes), and samples beyond the picture's edge that are lost.
TEST(Sampling, FlatPicturesStayFlat) {
    const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "flat_sky.pov";
    std::ofstream(file) << "#version 3.7; global_settings { assumed_gamma 1 } camera { location -z look_at 0 }"
                           " background { rgb <0.25, 0.5, 0.75> }";
    const Loaded sky = load(file);
    Session session = session_with(sky);
    for (std::uint32_t filter = kernel::FILTER_PIXEL; filter <= kernel::FILTER_BLACKMAN_HARRIS; ++filter)
        for (std::uint32_t pattern = kernel::SAMPLES_R2; pattern <= kernel::SAMPLES_SOBOL; ++pattern) {
            const std::uint32_t cells = pattern == kernel::SAMPLES_SOBOL ? 0 : 4;
            const Film film = rendered(session, sky, {pattern, cells, filter, 2}, 16);
            for (int y = 0; y < kHeight; ++y)
                for (int x = 0; x < kWidth; ++x) {
                    ASSERT_NEAR(film.mean(x, y).x, 0.25F, 1e-5F) << filter << ' ' << pattern;
                    ASSERT_NEAR(film.mean(x, y).z, 0.75F, 1e-5F);
                }
        }
}

// Catches a sampler whose picture isn't the others', and filters that move it: all converge to the same with the same
// filter, and wider filters are blurrier.
TEST(Sampling, AllConvergeToTheSamePicture) {
    const Loaded table = gallery("table");
    Session session = session_with(table);
    const kernel::PixelSampling best{kernel::SAMPLES_SOBOL, 0, kernel::FILTER_PIXEL, 0};
    const output::Image reference = image_of(rendered(session, table, best, 1024));
    double psnr_db[4];
    for (std::uint32_t pattern = kernel::SAMPLES_R2; pattern <= kernel::SAMPLES_SOBOL; ++pattern) {
        const std::uint32_t cells = pattern == kernel::SAMPLES_SOBOL ? 0 : 8;
        psnr_db[pattern] =
            output::compare(image_of(rendered(session, table, {pattern, cells, kernel::FILTER_PIXEL, 0}, 64)),
                            reference)
                .psnr_db;
        EXPECT_GT(psnr_db[pattern], 50) << pattern;
    }
    EXPECT_GT(psnr_db[kernel::SAMPLES_SOBOL], psnr_db[kernel::SAMPLES_R2]);
    double before = 1e9;
    for (const float radius : {1.0F, 2.0F, 4.0F}) {
        const double distance =
            output::compare(
                image_of(rendered(session, table, {kernel::SAMPLES_SOBOL, 0, kernel::FILTER_TENT, radius}, 64)),
                reference)
                .psnr_db;
        EXPECT_LT(distance, before) << radius;
        before = distance;
    }
}

// Catches places that aren't where pixels are, and colours that aren't made linear: an undivided pixel is the mean of
// its corners, and those are what the pixels of a picture see that lies half a pixel beside.
TEST(Sampling, PlacesSeeWhatPixelsSee) {
    const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "gamma_places.pov";
    std::ofstream(file) << "#version 3.6; camera { location <0, 1, -4> look_at 0 } light_source { <2, 4, -3> rgb 1 }"
                           " sphere { 0, 1 pigment { rgb <0.8, 0.3, 0.1> } finish { phong 0.7 reflection 0.2 } }"
                           " plane { y, -1 pigment { checker rgb 0.2 rgb 0.9 } } background { rgb 0.4 }";
    const Loaded scene = load(file);
    Session session = session_with(scene);
    const Frame frame = scene.frame();
    ASSERT_TRUE(session.device().can_trace_places(frame));
    std::vector<PicturePlace> places;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) places.push_back({static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F});
    std::vector<Vec3> radiance(places.size());
    const RenderStats stats = session.device().trace_places(frame, places, radiance, StopFlag{});
    EXPECT_GT(stats.rays, places.size());
    const Film film = rendered(session, scene, {}, 1);
    int different = 0;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const Vec3 place = radiance[film.index(x, y)], pixel = film.mean(x, y);
            // The last bit can hang on which rays share a packet, and edges on that bit.
            if (std::abs(place.x - pixel.x) + std::abs(place.y - pixel.y) + std::abs(place.z - pixel.z) > 1e-4F)
                ++different;
        }
    EXPECT_LE(different, 3);

    const Film divided = session.render_recursive(frame, {.threshold = 0.1, .depth = 4}, {}, StopFlag{}).film;
    const Film reference = rendered(session, scene, {kernel::SAMPLES_SOBOL, 0, kernel::FILTER_PIXEL, 0}, 256);
    EXPECT_GT(output::compare(image_of(divided), image_of(reference)).psnr_db,
              output::compare(image_of(film), image_of(reference)).psnr_db + 6);
}

// Catches samples that are added where none are needed, in preview or not, and edges that stay jagged.
TEST(Sampling, AdaptiveSamplingMendsEdgesAlone) {
    const Loaded table = gallery("table");
    Session session = session_with(table);
    const output::Image reference =
        image_of(rendered(session, table, {kernel::SAMPLES_SOBOL, 0, kernel::FILTER_PIXEL, 0}, 256));
    const output::Image once = image_of(rendered(session, table, {}, 1));
    for (const float preview : {0.0F, 0.05F})
        for (const std::uint32_t samples : {9U, 16U, 12U}) {
            const RenderResult result = session.render_adaptive(
                table.frame(), {.threshold = 0.1, .samples = samples, .preview = preview}, {}, StopFlag{});
            double sum = 0;
            for (const auto& pixel : result.film.radiance) {
                ASSERT_TRUE(pixel[3] == 1 || pixel[3] == static_cast<float>(samples)) << pixel[3];
                sum += pixel[3];
            }
            EXPECT_LT(sum / (kWidth * kHeight), samples / 3.0);
            EXPECT_GT(output::compare(image_of(result.film), reference).psnr_db,
                      output::compare(once, reference).psnr_db + 6);
        }
}

// Catches pictures to a target that depend on threads, and a target that isn't reached.
TEST(Sampling, ErrorsAreWhatWasAskedFor) {
    const Loaded table = gallery("table");
    Session one = session_with(table, 1), two = session_with(table, 2);
    const ErrorTarget target{.error = 0.05, .most_samples = 512};
    const ErrorDrivenResult a = one.render_to_error(table.frame(), target, {}, StopFlag{});
    const ErrorDrivenResult b = two.render_to_error(table.frame(), target, {}, StopFlag{});
    EXPECT_EQ(a.film.radiance, b.film.radiance);
    EXPECT_GT(a.met, 0.99);
    const Film reference = rendered(one, table, {kernel::SAMPLES_SOBOL, 0, kernel::FILTER_PIXEL, 0}, 1024);
    int outside = 0;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const float apart = std::abs(std::sqrt(a.film.mean(x, y).y) - std::sqrt(reference.mean(x, y).y));
            outside += apart > 0.05F ? 1 : 0;
        }
    EXPECT_LT(outside, kWidth * kHeight / 20);
}

// Catches light between surfaces that is gathered anew because samples go elsewhere in their pixels.
TEST(Sampling, RadiosityIsGatheredOnce) {
    const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "radiosity_samples.pov";
    std::ofstream(file) << "#version 3.7; global_settings { assumed_gamma 1 radiosity { count 40 } }"
                           " camera { location <0, 1, -4> look_at 0 } background { rgb 1 }"
                           " sphere { 0, 1 pigment { rgb 0.7 } } plane { y, -1 pigment { rgb 0.5 } }";
    const Loaded scene = load(file);
    Session session = session_with(scene);
    const auto rays_of = [&](std::uint32_t pattern) {
        Film film({0, 0, kWidth, kHeight});
        const Frame frame = scene.frame({pattern, 0, kernel::FILTER_PIXEL, 0});
        return session.render_into(frame, 0, 1, film, StopFlag{}).rays;
    };
    const std::uint64_t first = rays_of(kernel::SAMPLES_R2), again = rays_of(kernel::SAMPLES_R2);
    EXPECT_GT(first, again * 3 / 2) << "the first picture gathers";
    EXPECT_LT(rays_of(kernel::SAMPLES_SOBOL), again * 5 / 4);
}

}  // namespace
}  // namespace sundog
