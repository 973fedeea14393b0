// SPDX-License-Identifier: Apache-2.0
// The C++ side of compat.h. SUNDOG_KERNEL_LANES (1, 4, 8, 16; default 1) is fixed per translation unit, and so is
// SUNDOG_KERNEL_FEATURES, the FEATURE_* bits that the unit is compiled for (default: all; what is left out costs
// nothing there), SUNDOG_KERNEL_RECORDS, set where paths remember what they met (RECORDING; see
// integrators/record.h), SUNDOG_KERNEL_PATHS, set for path tracing, and SUNDOG_KERNEL_SHORTCUTS, set where hits and
// shadows may be known before they are traced. Everything that depends on them lives in an inline namespace of its own,
// so units of different kinds can be linked together.
#ifndef SUNDOG_KERNEL_COMPAT_CPP_H
#define SUNDOG_KERNEL_COMPAT_CPP_H

#include <bit>
#include <cmath>
#include <cstddef>

#include "kernel/shared.h"

#ifndef SUNDOG_KERNEL_LANES
#define SUNDOG_KERNEL_LANES 1
#endif

#define SUNDOG_KERNEL_PASTE_(a, b, c) a##b##c
#define SUNDOG_KERNEL_PASTE(a, b, c) SUNDOG_KERNEL_PASTE_(a, b, c)
#ifdef SUNDOG_KERNEL_RECORDS
#define SUNDOG_KERNEL_PURPOSE recording_
#define RECORDING true
#else
#ifdef SUNDOG_KERNEL_PATHS
#define SUNDOG_KERNEL_PURPOSE paths_
#else
#define SUNDOG_KERNEL_PURPOSE
#endif
#define RECORDING false
#endif
#ifdef SUNDOG_KERNEL_FEATURES
#define SUNDOG_KERNEL_SPACE SUNDOG_KERNEL_PASTE(SUNDOG_KERNEL_PURPOSE, plain_lanes, SUNDOG_KERNEL_LANES)
#define FN_RECURSIVE FN
#else
#define SUNDOG_KERNEL_SPACE SUNDOG_KERNEL_PASTE(SUNDOG_KERNEL_PURPOSE, lanes, SUNDOG_KERNEL_LANES)
#define SUNDOG_KERNEL_FEATURES 0xffffffffu
#define FN_RECURSIVE FN_LARGE
#endif
#define KERNEL_BEGIN           \
    namespace sundog::kernel { \
    inline namespace SUNDOG_KERNEL_SPACE {
#define KERNEL_END \
    }              \
    }

#define FN [[gnu::always_inline]] inline
/// For a large function that is called from several places: one copy of it.
#define FN_LARGE [[gnu::noinline]] inline
// FN_RECURSIVE, above: for a large function that calls itself, but never in plain scenes, which its call would slow.
#define OUT(T) T&
#define INOUT(T) T&
/// There is code for media. Shaders have it only where SUNDOG_MEDIA is defined, for it makes them a lot larger.
#define KERNEL_MEDIA
/// And for patterns that few scenes have (OP_RARE): shaders only with SUNDOG_RARE_PATTERNS, for drivers take long for
/// code, even such as they leave out.
#define KERNEL_RARE_PATTERNS
/// Some program has this OP_*, some OP_FIELD this FIELD_*: shaders leave out what none has.
#define PROGRAMS_HAVE(op) true
#define FIELDS_HAVE(kind) true
#define PROGRAMS_HAVE_ANY(a, b, c) (PROGRAMS_HAVE(a) || PROGRAMS_HAVE(b) || PROGRAMS_HAVE(c))
/// FrameParams::integrator is this one.
#define INTEGRATOR_IS(number) (scene.frame.integrator == (number))
/// A parameter that is only read, and too large to be copied.
#define LARGE(T) const T&
#define SCENE const SceneView &scene,
#define SCENE_ scene,
#define FRAME scene.frame
#define FEATURE(bits) ((scene.frame.features & (bits)&SUNDOG_KERNEL_FEATURES) != 0u)
#define WANTS_AOV(bits) ((scene.frame.aovs & (bits)) != 0u)
#define AT(array, i) scene.array[i]
#define FIELD(array, i, field) load(&scene.array[0].field, sizeof(scene.array[0]), i)
#define GET(array, i) load(&scene.array[0], sizeof(scene.array[0]), i)

namespace sundog::kernel {

class HostFields;
class IndirectLight;
class PhotonLight;
struct EyeHits;
struct LightCells;

/// What the kernel sees of a RenderScene and a Frame: plain pointers to every array (kernel/arrays.h).
struct SceneView {
    FrameParams frame;
#define KERNEL_ARRAY(type, name, binding) const type* name;
#include "kernel/arrays.h"
#undef KERNEL_ARRAY
    const void* traversal;                    ///< The device's own; the kernel never looks inside.
    const HostFields* host_fields = nullptr;  ///< Set where some program asks (kernel/patterns/host_fields.h).
    const IndirectLight* indirect = nullptr;  ///< Set where FEATURE_RADIOSITY is (kernel/lights/indirect.h).
    const PhotonLight* photons = nullptr;     ///< Set where FEATURE_PHOTONS is (kernel/lights/photon_light.h).
    const EyeHits* eye_hits = nullptr;        ///< The device's own: what is known of first hits before they are traced.
    const LightCells* light_cells = nullptr;  ///< Likewise: what is known of the shadows of each light.
    uint first_ray_kind = RAY_CAMERA;         ///< RAY_* of the rays that whitted_radiance() starts with.
};

}  // namespace sundog::kernel

#if SUNDOG_KERNEL_LANES == 1
#include "kernel/compat/scalar.h"
#else
#include "kernel/compat/lanes.h"
#endif
#include "kernel/compat/vectors.h"

#endif
