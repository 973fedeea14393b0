// SPDX-License-Identifier: Apache-2.0
// Patterns as POV-Ray describes them (its reference, section 3.4.7 "Pattern"): a number, or a choice from a list, for
// every point of space, and the warps that bend space before.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "base/vec3d.h"

namespace sundog::scene {

struct Function;
struct Pigment;

/// Bends space for a pattern (section 3.4.7.5.5 "Warp").
struct Warp {
    enum class Kind : std::uint8_t { turbulence, repeat, black_hole, planar, cylindrical, spherical, toroidal, cubic };
    Kind kind = Kind::turbulence;

    Vec3d turbulence;  ///< Amounts: turbulence; black_hole: how far the repeated holes stray.
    int octaves = 6;
    double lambda = 2, omega = 0.5;

    Vec3d repeat;  ///< repeat: along one axis. black_hole: the size of a block with a hole each; 0: only one.
    Vec3d offset;  ///< repeat: what each copy is moved by.
    Vec3d flip;    ///< repeat: axes that every second copy is mirrored along are not 0.

    Vec3d center;  ///< black_hole, from here on.
    double radius = 1, falloff = 2, strength = 1;
    bool inverse = false;

    Vec3d orientation{0, 0, 1};    ///< planar: the plane's normal; cylindrical, spherical, toroidal: what z becomes.
    double distance = 0;           ///< planar: along the normal.
    double distance_exponent = 0;  ///< cylindrical, spherical, toroidal (dist_exp).
    double major_radius = 1;       ///< toroidal
};

/// One of the warps that a point passes on its way to a pattern.
struct WarpStep {
    Affine3d warp_from_before;  ///< Applied before the warp.
    Warp warp;
};

/// crackle (section 3.4.7.2.3).
struct CrackleForm {
    Vec3d form{-1, 1, 0};  ///< Factors of the distances to the nearest, second and third nearest point.
    double metric = 2, offset = 0;
    bool solid = false;
    friend bool operator==(const CrackleForm&, const CrackleForm&) = default;
};

/// mandel, julia and magnet (section 3.4.7.1.11).
struct FractalForm {
    enum class Formula : std::uint8_t { power, magnet1, magnet2 } formula = Formula::power;
    bool julia = false;
    std::array<double, 2> c{};  ///< julia
    int iterations = 1;
    int exponent = 2;  ///< power
    int exterior_type = 1, interior_type = 0;
    double exterior_factor = 1, interior_factor = 1;
};

/// slope (section 3.4.7.3.2).
struct SlopeForm {
    Vec3d direction{0, 1, 0};
    bool toward_point = false;  ///< `direction` is a point to face.
    double low = 0, high = 1;
    Vec3d altitude;  ///< 0: none.
    double low_altitude = 0, high_altitude = 1;
};

/// The data of a density_file.
struct DensityGrid {
    std::array<std::uint32_t, 3> size{};  ///< Along x, y, z.
    std::vector<float> values;            ///< 0..1, x runs fastest.
};

/// pavement (section 3.4.7.1.18).
struct PavementForm {
    int sides = 4, tiles = 1, pattern = 1;
    int exterior = 0, interior = 0, form = 0;
};

/// What the pattern `object` asks.
class InsideTest {
public:
    InsideTest() = default;
    InsideTest(const InsideTest&) = delete;
    InsideTest& operator=(const InsideTest&) = delete;
    virtual ~InsideTest() = default;
    /// Any number of threads may ask at once.
    [[nodiscard]] virtual bool inside(Vec3d point) const = 0;
};

/// How much of something there is at a point: what textures of an object's parts are blended by.
class ShareOfPoint {
public:
    ShareOfPoint() = default;
    ShareOfPoint(const ShareOfPoint&) = delete;
    ShareOfPoint& operator=(const ShareOfPoint&) = delete;
    virtual ~ShareOfPoint() = default;
    /// 0 to 1. Any number of threads may ask at once.
    [[nodiscard]] virtual double at(Vec3d point) const = 0;
};

/// A scalar field over space, 0..1 after its wave form, or a choice among a few (checker, brick, hexagon, …).
struct Pattern {
    enum class Kind : std::uint8_t {
        // Choices among a list of entries
        checker,     ///< 2
        brick,       ///< 2: mortar, brick
        hexagon,     ///< 3
        square,      ///< 4
        triangular,  ///< 6
        cubic,       ///< 6
        object,      ///< 2: outside, inside of a solid
        material,    ///< As many as `choices`, by the red of `pigment`, which is an image: 255 of it a texel.
        // Fields
        gradient,  ///< Along `axis`.
        agate,
        aoi,
        average,  ///< No field: each entry has its own number as its share.
        boxed,
        bozo,
        bumps,
        cells,
        crackle,
        cylindrical,
        density_file,
        dents,
        facets,
        fractal,
        function,
        granite,
        image,  ///< The grey of `pigment`, which is one.
        leopard,
        marble,
        onion,
        pavement,
        pigment,  ///< The grey of `pigment`.
        planar,
        quilted,
        radial,
        ripples,
        share,
        slope,
        spherical,
        spiral1,
        spiral2,
        spotted,
        tiling,
        waves,
        wood,
        wrinkles,
    };
    enum class Wave : std::uint8_t { standard, ramp, triangle, sine, scallop, cubic, poly };

    Kind kind = Kind::gradient;
    Vec3d axis{1, 0, 0};  ///< gradient
    Vec3d brick_size{8, 3, 4.5};
    double mortar = 0.5;
    int arms = 1;                ///< spiral1, spiral2
    Wave wave = Wave::standard;  ///< `standard` is the pattern's own default.
    double exponent = 1;         ///< poly_wave
    double frequency = 1, phase = 0;
    std::vector<WarpStep> warps;    ///< From the texture on, in the order in which a point passes them.
    Affine3d pattern_from_texture;  ///< Inverse of all transforms between this pattern and the texture it is part of;
                                    ///< where there are warps, from behind the last one on.
    Vec3d turbulence;               ///< After all of these; 0: none.
    double agate_turbulence = 1;    ///< agate_turb
    int noise_generator = 0;        ///< 1 to 3; 0: the scene's.
    int octaves = 6;
    double lambda = 2, omega = 0.5;
    CrackleForm crackle;
    FractalForm fractal;
    SlopeForm slope;
    PavementForm pavement;
    int tiling = 1;
    int choices = 0;                              ///< material
    double control0 = 1, control1 = 1;            ///< quilted
    double facet_coords = 0, facet_size = 0;      ///< facets: one of them is given.
    std::shared_ptr<const DensityGrid> density;   ///< density_file
    int interpolation = 0;                        ///< density_file: 0 none, 1 linear, 2 cubic.
    std::shared_ptr<const Function> function;     ///< function: of x, y, z.
    std::shared_ptr<const Pigment> pigment;       ///< image, pigment
    bool uses_alpha = false;                      ///< image: the value is its alpha.
    std::shared_ptr<const InsideTest> inside_of;  ///< object
    std::shared_ptr<const ShareOfPoint> share;    ///< share

    /// Moves the pattern within its texture.
    void move(const Affine3d& old_from_new) {
        Affine3d& first = warps.empty() ? pattern_from_texture : warps.front().warp_from_before;
        first = first * old_from_new;
    }
    /// Adds a warp that a point passes before all that is there.
    void bend(const Warp& warp) { warps.insert(warps.begin(), WarpStep{{}, warp}); }
};

}  // namespace sundog::scene
