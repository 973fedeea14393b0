// SPDX-License-Identifier: Apache-2.0
// Irradiance that is cached and interpolated against long path tracing. It is biased by design, so parts of pictures
// are held to a share of the reference.
#include <gtest/gtest.h>

#include "base/test_folder.h"
#include "estimate.h"
#include "import/import.h"
#include "scene/indirect_light.h"

namespace sundog {
namespace {

using namespace test;

class CachedRadiosity : public testing::Test {
protected:
    void compare(scene::Scene s, const std::vector<Region>& regions, std::uint32_t samples, float share) const {
        FrameOptions options = size(32, 24);
        options.max_depth = 12;
        s.radiosity.reset();
        const PathMeans reference(*device_, s, options, samples, regions);
        const Film ambient = render_on(*device_, s, options, 16).film;
        s.radiosity = scene::radiosity_for(400);
        reference.expect_near(render_on(*device_, s, options, 16).film, regions, share);
        float off = 0;
        for (std::size_t k = 0; k < regions.size(); ++k)
            off = std::max(off, std::abs(mean_of(ambient, regions[k]).x / reference.mean(k).x - 1));
        EXPECT_GT(off, 3 * share) << "ambient light alone";
    }

    std::unique_ptr<Device> device_ = make_cpu_device({.threads = 2});
};

// The gallery's box: an orbit scene of an OBJ model, with a mirror and a glass ball in it. Catches bounces that are
// lost or counted twice, in mirrors too, and light of the sky or of surfaces that shine that isn't gathered.
TEST_F(CachedRadiosity, CornellBox) {
    const std::vector<Region> regions{{"all", 0, 32, 0, 24},
                                      {"ceiling", 8, 24, 2, 4},
                                      {"floor", 12, 20, 20, 22},
                                      {"red wall", 6, 8, 8, 16},
                                      {"green wall", 24, 26, 8, 16}};
    compare(import::import_scene(std::filesystem::path(SUNDOG_SCENES) / "cornell/cornell.scene", {}), regions, 64,
            0.05F);
}

}  // namespace
}  // namespace sundog
