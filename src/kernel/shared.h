// SPDX-License-Identifier: Apache-2.0
// Structs and constants that the host, the C++ kernel and the GLSL kernel share, byte for byte (scalar layout).
#ifndef SUNDOG_KERNEL_SHARED_H
#define SUNDOG_KERNEL_SHARED_H

#ifdef __cplusplus
#include "kernel/compat/types.h"
namespace sundog::kernel {
#define KERNEL_CONST constexpr
#else
#define KERNEL_CONST const
#endif

/// "No such thing" for any index.
KERNEL_CONST uint NONE = 0xffffffffu;

/// What a Geometry's primitives are.
KERNEL_CONST uint GEOMETRY_TRIANGLES = 0u;
KERNEL_CONST uint GEOMETRY_SPHERE = 1u;
KERNEL_CONST uint GEOMETRY_BOX = 2u;
KERNEL_CONST uint GEOMETRY_PLANE = 3u;
/// Exact shapes and CSG: the device finds them with code of its own; a hit's primitive is its material, u and v are its
/// texture coordinates, its normal is in world space.
KERNEL_CONST uint GEOMETRY_SOLID = 4u;

/// What a ray is for, as bits: a geometry may be hidden from some of them.
KERNEL_CONST uint RAY_CAMERA = 1u;         ///< From the eye, and on through what is transparent.
KERNEL_CONST uint RAY_REFLECTED = 2u;      ///< From a mirror, and all that comes after it.
KERNEL_CONST uint RAY_SHADOW = 4u;         ///< Towards a light.
KERNEL_CONST uint RAY_RADIOSITY = 8u;      ///< From a point whose irradiance is gathered.
KERNEL_CONST uint RAY_PHOTON = 16u;        ///< A photon's from its light, to what it was shot at.
KERNEL_CONST uint RAY_LATER_PHOTON = 32u;  ///< And from there on.
/// Through what lights are projected: the first of 24 such bits, of which each object that lights shine through has
/// one.
KERNEL_CONST uint RAY_PROJECTION = 256u;
KERNEL_CONST uint RAY_ANY_PROJECTION = 0xffffff00u;
KERNEL_CONST uint RAY_ALL = 0xffffffffu;

KERNEL_CONST uint LIGHT_LAMP = 0u;
KERNEL_CONST uint LIGHT_SUN = 1u;
KERNEL_CONST uint LIGHT_SPOT = 2u;      ///< Within a cone around Light::axis.
KERNEL_CONST uint LIGHT_CYLINDER = 3u;  ///< Within a cylinder around Light::axis.

/// Light::flags.
KERNEL_CONST uint LIGHT_SHADOWS = 1u;
KERNEL_CONST uint LIGHT_HIGHLIGHTS = 2u;
KERNEL_CONST uint LIGHT_CIRCULAR = 4u;        ///< An area's grid is bent to a disc.
KERNEL_CONST uint LIGHT_ORIENT = 8u;          ///< An area turns to face the lit point.
KERNEL_CONST uint LIGHT_JITTER = 16u;         ///< An area's lights are moved about within their cells.
KERNEL_CONST uint LIGHT_ILLUMINATES = 32u;    ///< An area lights from all of its lights, not only from its middle.
KERNEL_CONST uint LIGHT_ATTENUATED = 256u;    ///< Fog and the atmosphere's media dim it on its way.
KERNEL_CONST uint LIGHT_PASSES_MEDIA = 512u;  ///< Media don't scatter it: `media_interaction off`, or without shadows.

/// What a light does with photons; see Geometry::photons.
KERNEL_CONST uint LIGHT_PHOTONS_REFRACT = 1024u;
KERNEL_CONST uint LIGHT_PHOTONS_NEVER_REFRACT = 2048u;
KERNEL_CONST uint LIGHT_PHOTONS_REFLECT = 4096u;
KERNEL_CONST uint LIGHT_PHOTONS_NEVER_REFLECT = 8192u;
KERNEL_CONST uint LIGHT_PHOTONS_AREA = 16384u;  ///< An area shoots them from all of its lights.

/// Geometry::photons: what an object does with photons, and which target of theirs it is (or a part of), from 1; 0:
/// none. Photons are refracted where neither object nor light says "never" and one of them says so; so for reflection.
KERNEL_CONST uint PHOTONS_REFRACT = 1u;
KERNEL_CONST uint PHOTONS_NEVER_REFRACT = 2u;
KERNEL_CONST uint PHOTONS_REFLECT = 4u;
KERNEL_CONST uint PHOTONS_NEVER_REFLECT = 8u;
KERNEL_CONST uint PHOTONS_COLLECT = 16u;
KERNEL_CONST uint PHOTONS_TARGET_SHIFT = 8u;

/// PixelSampling::pattern: where a pixel's samples go.
KERNEL_CONST uint SAMPLES_R2 = 0u;  ///< The same places in each pixel, by the R2 sequence; the first is the middle.
KERNEL_CONST uint SAMPLES_REGULAR = 1u;   ///< The middles of a grid's cells.
KERNEL_CONST uint SAMPLES_JITTERED = 2u;  ///< Anywhere in a grid's cells.
KERNEL_CONST uint SAMPLES_SOBOL = 3u;     ///< Sobol's sequence, scrambled by Owen's method for each pixel.

/// PixelSampling::pixel_filter: how they are weighed.
KERNEL_CONST uint FILTER_PIXEL = 0u;  ///< The pixel's own square.
KERNEL_CONST uint FILTER_BOX = 1u;    ///< This and the following reach `radius` to each side of the middle.
KERNEL_CONST uint FILTER_TENT = 2u;
KERNEL_CONST uint FILTER_GAUSSIAN = 3u;  ///< Cut off at three standard deviations.
KERNEL_CONST uint FILTER_MITCHELL = 4u;  ///< Mitchell and Netravali's with B = C = 1/3; weights below 0 sharpen.
KERNEL_CONST uint FILTER_BLACKMAN_HARRIS = 5u;

/// FrameParams::camera_kind. See kernel/cameras/projections.h.
KERNEL_CONST uint CAMERA_PERSPECTIVE = 0u;
KERNEL_CONST uint CAMERA_ORTHOGRAPHIC = 1u;
KERNEL_CONST uint CAMERA_FISHEYE = 2u;
KERNEL_CONST uint CAMERA_ULTRA_WIDE_ANGLE = 3u;
KERNEL_CONST uint CAMERA_OMNIMAX = 4u;
KERNEL_CONST uint CAMERA_PANORAMIC = 5u;
KERNEL_CONST uint CAMERA_CYLINDER = 6u;  ///< 6 to 9: types 1 to 4
KERNEL_CONST uint CAMERA_SPHERICAL = 10u;

/// Where the environment's pixels begin in `tables`.
KERNEL_CONST uint ENVIRONMENT_FIRST = 3392u;

/// FrameParams::integrator.
KERNEL_CONST uint INTEGRATOR_WHITTED = 0u;
KERNEL_CONST uint INTEGRATOR_PATH = 1u;
KERNEL_CONST uint INTEGRATOR_OCCLUSION = 2u;

/// Emitter::kind.
KERNEL_CONST uint EMITTER_TRIANGLE = 0u;
KERNEL_CONST uint EMITTER_SPHERE = 1u;
KERNEL_CONST uint EMITTER_LIGHT = 2u;
KERNEL_CONST uint EMITTER_ENVIRONMENT = 3u;

/// Material::flags.
KERNEL_CONST uint MATERIAL_PHONG = 1u;         ///< Highlight by Phong's mirrored ray; else Blinn's halfway vector.
KERNEL_CONST uint MATERIAL_FRESNEL = 2u;       ///< Dielectric Fresnel splits reflectance and transmittance.
KERNEL_CONST uint MATERIAL_CHECKER = 4u;       ///< Diffuse alternates with checker_other on UVs.
KERNEL_CONST uint MATERIAL_HIGHLIGHT = 8u;     ///< specular is not black.
KERNEL_CONST uint MATERIAL_TEXTURED = 16u;     ///< Any *_texture is set, or checker.
KERNEL_CONST uint MATERIAL_TRANSPARENT = 32u;  ///< transmittance is not black, or an opacity map is set: never culled.

KERNEL_CONST uint MATERIAL_PATTERNED = 64u;  ///< A texture of layers: Material::patterned says which.
KERNEL_CONST uint MATERIAL_BACKLIT = 128u;   ///< Light on its back is seen from the front.

/// If FEATURE_ONE_SIDED: the eye doesn't see triangles of it from behind (glTF's `doubleSided` false).
KERNEL_CONST uint MATERIAL_ONE_SIDED = 256u;
/// If FEATURE_VERTEX_ATTRIBUTES, what vertices' colours multiply beside the matt colour: opacity, by their alpha; the
/// mirror and highlight; what is emitted; what passes through.
KERNEL_CONST uint MATERIAL_VERTEX_ALPHA = 512u;
KERNEL_CONST uint MATERIAL_VERTEX_SPECULAR = 1024u;
KERNEL_CONST uint MATERIAL_VERTEX_EMISSION = 2048u;
KERNEL_CONST uint MATERIAL_VERTEX_PASSES = 4096u;

/// Bsdf::kind (kernel/bsdf).
KERNEL_CONST uint BSDF_PRINCIPLED = 0u;
KERNEL_CONST uint BSDF_OREN_NAYAR = 1u;
KERNEL_CONST uint BSDF_PHONG = 2u;
KERNEL_CONST uint BSDF_BLINN_PHONG = 3u;
KERNEL_CONST uint BSDF_WARD = 4u;
KERNEL_CONST uint BSDF_COOK_TORRANCE = 5u;
KERNEL_CONST uint BSDF_BECKMANN = 6u;   ///< A metal of Beckmann's facets,
KERNEL_CONST uint BSDF_CONDUCTOR = 7u;  ///< and of GGX's.
KERNEL_CONST uint BSDF_DIELECTRIC = 8u;

/// Maps of reflection models: of their colour and opacity, then BSDF_PRINCIPLED's, in the channels that glTF gives
/// them.
KERNEL_CONST uint BSDF_MAP_METALLIC_ROUGHNESS = 0u;
KERNEL_CONST uint BSDF_MAP_SPECULAR = 1u;
KERNEL_CONST uint BSDF_MAP_SPECULAR_COLOR = 2u;
KERNEL_CONST uint BSDF_MAP_TRANSMISSION = 3u;
KERNEL_CONST uint BSDF_MAP_COAT = 4u;
KERNEL_CONST uint BSDF_MAP_COAT_ROUGHNESS = 5u;
KERNEL_CONST uint BSDF_MAP_SHEEN_COLOR = 6u;
KERNEL_CONST uint BSDF_MAP_SHEEN_ROUGHNESS = 7u;
KERNEL_CONST uint BSDF_MAP_FILM = 8u;
KERNEL_CONST uint BSDF_MAP_FILM_THICKNESS = 9u;
KERNEL_CONST uint BSDF_MAP_ANISOTROPY = 10u;
KERNEL_CONST uint BSDF_MAP_COLOR = 11u;
KERNEL_CONST uint BSDF_MAP_OPACITY = 12u;  ///< As MaterialMaps::opacity.
KERNEL_CONST uint BSDF_MAP_COAT_NORMAL = 13u;
KERNEL_CONST uint BSDF_MAP_COUNT = 14u;

/// Where what stands in `tables` behind the values of sRGB: a table's rows are roughnesses, its columns cosines
/// (kernel/bsdf/albedo_tables.h).
KERNEL_CONST uint BSDF_TABLES_FIRST = 256u;
KERNEL_CONST uint BSDF_TABLE_SIDE = 32u;
KERNEL_CONST uint BSDF_TABLE_GGX = 256u;         ///< Two numbers each.
KERNEL_CONST uint BSDF_TABLE_GGX_MEANS = 2304u;  ///< A column of two numbers each.
KERNEL_CONST uint BSDF_TABLE_SHEEN = 2368u;
KERNEL_CONST uint BSDF_TABLE_FLOATS = 3136u;

/// Layer::flags.
KERNEL_CONST uint LAYER_FRESNEL = 1u;          ///< Reflection follows Fresnel's equations by the interior's ior.
KERNEL_CONST uint LAYER_CONSERVE_ENERGY = 2u;  ///< What is reflected doesn't pass through.
KERNEL_CONST uint LAYER_PART = 4u;             ///< The top layer of a part of a patterned texture: see OP_WEIGHT.
KERNEL_CONST uint LAYER_FIRST_PART = 8u;       ///< And that of the first part.
KERNEL_CONST uint LAYER_PARTS_END = 16u;       ///< The lowest layer of the last part.

/// Most layers of a texture.
KERNEL_CONST uint MAX_LAYERS = 8u;

/// Most entries of `interiors`: their numbers have 16 bits.
KERNEL_CONST uint MAX_INTERIORS = 65536u;

/// Units of PathState::depth that a reflection or refraction counts; passing straight through a texture of layers
/// counts one, so it is all but free.
KERNEL_CONST uint DEPTH_UNITS = 256u;

/// Pigment programs: words of the array `code`. An instruction's first word is opcode | target << 8 | source << 16 |
/// source2 << 24; operands follow, floats by their bits. Targets and sources number points, values or colours, of which
/// there are PROGRAM_SLOTS each. Point 0 is where the pigment is asked for; colour 0 is the answer.
KERNEL_CONST uint PROGRAM_SLOTS = 8u;
KERNEL_CONST uint OP_END = 0u;
KERNEL_CONST uint OP_SOLID = 1u;      ///< colour[target] = 5 floats: red, green, blue, filter, transmit.
KERNEL_CONST uint OP_TRANSFORM = 2u;  ///< point[target] = affine map (columns x, y, z, t) of point[source].
/// value[target] = field at point[source]: FIELD_*, 3 floats of parameters, noise generator | octaves << 8.
KERNEL_CONST uint OP_FIELD = 3u;
KERNEL_CONST uint OP_WAVE = 4u;    ///< value[target] = wave form of itself: WAVE_*, frequency, phase, exponent.
KERNEL_CONST uint OP_MAP = 5u;     ///< colour[target] = map at value[source]: count, then position and 5 floats each.
KERNEL_CONST uint OP_CHOICE = 6u;  ///< value[target] = which of a list is at point[source]: CHOICE_* and 4 floats.
KERNEL_CONST uint OP_PICK = 7u;    ///< colour[target] = entry number value[source]: count, then 5 floats each.
KERNEL_CONST uint OP_CLEAR = 8u;   ///< colour[target] = 0.
/// Begin an entry of a list: share[target] of it at value[target]; the entry's own slot is target + 1. Where no lane
/// has a share, the last operand's number of words is skipped: to behind the entry's OP_BLEND.
KERNEL_CONST uint OP_ENTER_MAP = 9u;    ///< A map's: positions of the entry before, this one, and the one after; skip.
KERNEL_CONST uint OP_ENTER_PICK = 10u;  ///< A choice's: its number; skip.
KERNEL_CONST uint OP_IMAGE =
    11u;  ///< colour[target] = picture at point[source]: texture, flags, map type, filter, transmit.
/// point[target] = point[source] stirred: 3 floats of amounts, noise generator | octaves << 8 | STIR_* << 16, lambda,
/// omega.
KERNEL_CONST uint OP_TURBULENCE = 12u;
KERNEL_CONST uint OP_ENTER_SHARE = 13u;  ///< An average's: its share, the same everywhere; 0.
KERNEL_CONST uint OP_BLEND = 14u;        ///< Ends an entry: colour[target] += share[target] * colour[target + 1].
/// value[target] = grey of colour[source]; its alpha if the operand is 1; if it is 2 to 6, red, green, blue, filter or
/// transmit.
KERNEL_CONST uint OP_GRAY = 15u;
/// value[target] = field at point[source] that the host alone computes (see HostFields): its number is the operand,
/// source2 the slot whose lanes ask.
KERNEL_CONST uint OP_HOST_FIELD = 16u;
KERNEL_CONST uint OP_CRACKLE =
    18u;  ///< value[target] = crackle at point[source]: 3 factors of distances, metric, offset, 1 if solid.

KERNEL_CONST uint OP_WEIGHT = 19u;  ///< The program's weight = colour[0].red; where it is 0 in all lanes, it ends.
/// value[target] = itself to the power of the operand, as a function's value: what is above 1 without its whole part, 0
/// where there is none.
KERNEL_CONST uint OP_POWER = 20u;
/// value[target] = tiling at point[source], see kernel/patterns/tiling.h: count of all words that follow, then those of
/// tiling_value().
KERNEL_CONST uint OP_TILING = 21u;
/// value[target] = density file at point[source]; source2 is the slot whose lanes ask: the host's number of the field,
/// four words for density_at() (see kernel/patterns/density_grid.h) and where voxels are, how many words follow: those
/// of the voxels, or 0 where another program holds them.
KERNEL_CONST uint OP_DENSITY = 22u;
// What the host is asked for on the CPU, in double precision, and shaders compute for themselves: the host's number,
// source2 is the slot whose lanes ask; for shaders, FIELD_* (OP_SHARED_FIELD alone), how many words follow, and these.
KERNEL_CONST uint OP_SHARED_FIELD = 23u;  ///< value[target] = field at point[source]; kernel/patterns/shader_fields.h.
/// point[target] = point[source] warped, by repetition, a black hole or a mapping; kernel/patterns/shader_warps.h.
KERNEL_CONST uint OP_REPEAT = 24u;
KERNEL_CONST uint OP_BLACK_HOLE = 25u;
KERNEL_CONST uint OP_MAPPING = 26u;
/// Mappings of OP_MAPPING.
KERNEL_CONST uint MAPPING_PLANAR = 0u;
KERNEL_CONST uint MAPPING_CYLINDRICAL = 1u;
KERNEL_CONST uint MAPPING_SPHERICAL = 2u;
KERNEL_CONST uint MAPPING_TOROIDAL = 3u;
KERNEL_CONST uint MAPPING_CUBIC = 4u;
/// No instruction: what stands among a scene's OP_* where some normal has a program for its pattern's point.
KERNEL_CONST uint OP_POINT = 27u;

/// OP_* that few scenes have, as bits: their shaders are variants of their own. So are those of FIELD_RARE's normals.
KERNEL_CONST uint OP_RARE = 1u << OP_CRACKLE | 1u << OP_SHARED_FIELD | 1u << OP_REPEAT | 1u << OP_BLACK_HOLE |
                            1u << OP_MAPPING | 1u << OP_POINT;

/// Fields of OP_FIELD: a number at each point. See kernel/patterns/fields.h.
KERNEL_CONST uint FIELD_GRADIENT = 0u;
KERNEL_CONST uint FIELD_ONION = 1u;
KERNEL_CONST uint FIELD_SPHERICAL = 2u;
KERNEL_CONST uint FIELD_CYLINDRICAL = 3u;
KERNEL_CONST uint FIELD_PLANAR = 4u;
KERNEL_CONST uint FIELD_BOXED = 5u;
KERNEL_CONST uint FIELD_RADIAL = 6u;
KERNEL_CONST uint FIELD_LEOPARD = 7u;
KERNEL_CONST uint FIELD_WOOD = 8u;
KERNEL_CONST uint FIELD_MARBLE = 9u;
KERNEL_CONST uint FIELD_SPIRAL1 = 10u;
KERNEL_CONST uint FIELD_SPIRAL2 = 11u;
// With noise; the fourth parameter holds the noise generator, 1 to 3, and agate's octaves.
KERNEL_CONST uint FIELD_NOISE = 12u;  ///< bozo, spotted, bumps
KERNEL_CONST uint FIELD_GRANITE = 13u;
KERNEL_CONST uint FIELD_AGATE = 14u;
KERNEL_CONST uint FIELD_WRINKLES = 15u;
KERNEL_CONST uint FIELD_DENTS = 16u;
KERNEL_CONST uint FIELD_CELLS = 17u;
KERNEL_CONST uint FIELD_CRACKLE = 18u;
KERNEL_CONST uint FIELD_RIPPLES = 19u;
KERNEL_CONST uint FIELD_WAVES = 20u;
// Of OP_SHARED_FIELD.
KERNEL_CONST uint FIELD_SLOPE = 21u;
KERNEL_CONST uint FIELD_AOI = 22u;
KERNEL_CONST uint FIELD_QUILTED = 23u;  ///< The normal, too.
KERNEL_CONST uint FIELD_PAVEMENT = 24u;
KERNEL_CONST uint FIELD_FRACTAL = 25u;
KERNEL_CONST uint FIELD_FUNCTION = 26u;
// No fields: what some of them need.
KERNEL_CONST uint FIELD_FACETS = 27u;           ///< The normal.
KERNEL_CONST uint FIELD_FUNCTION_NOISE = 28u;   ///< Functions that ask for noise,
KERNEL_CONST uint FIELD_FUNCTION_ANGLES = 29u;  ///< and those of circles and hyperbolas, powers and logarithms.

KERNEL_CONST uint FIELD_RARE = 1u << FIELD_QUILTED | 1u << FIELD_FACETS;

/// How OP_TURBULENCE moves points. See kernel/patterns/fields.h.
KERNEL_CONST uint STIR_ALL = 0u;    ///< By a vector.
KERNEL_CONST uint STIR_X = 1u;      ///< marble: along x alone, and forwards.
KERNEL_CONST uint STIR_ALL_Z = 2u;  ///< Spirals: by a vector, and along z forwards.
KERNEL_CONST uint STIR_WAVES = 3u;  ///< wood: by waves of their places, along x and y.

/// Lists of OP_CHOICE.
KERNEL_CONST uint CHOICE_CHECKER = 0u;
KERNEL_CONST uint CHOICE_BRICK = 1u;
KERNEL_CONST uint CHOICE_HEXAGON = 2u;
KERNEL_CONST uint CHOICE_SQUARE = 3u;
KERNEL_CONST uint CHOICE_TRIANGULAR = 4u;
KERNEL_CONST uint CHOICE_CUBIC = 5u;

/// Lists of normals in `code`: their count, then NORMAL_WORDS each: weight program (NONE: 1), NORMAL_* kind, amount, 1
/// if scaling leaves depths alone (no_bump_scale), 2 if what is added is in world space, a program or number of the
/// kind's, two floats of the kind's, turbulence's lambda, omega and octaves (0: none), pattern_from_texture (columns x,
/// y, z, t), turbulence's amounts, a program that makes point 1 the pattern's point (with warps; NONE: what precedes
/// says where it is).
KERNEL_CONST uint NORMAL_WORDS = 26u;
KERNEL_CONST uint NORMAL_PATTERN = 0u;  ///< Height program; step of differences.
KERNEL_CONST uint NORMAL_IMAGE = 1u;    ///< Height program; a texel's width and height.
KERNEL_CONST uint NORMAL_BUMPS = 2u;
KERNEL_CONST uint NORMAL_DENTS = 3u;  ///< Noise generator.
KERNEL_CONST uint NORMAL_WRINKLES = 4u;
KERNEL_CONST uint NORMAL_RIPPLES = 5u;  ///< Frequency, phase.
KERNEL_CONST uint NORMAL_WAVES = 6u;    ///< Frequency, phase.
// The host's number, for the CPU asks it; two floats for shaders.
KERNEL_CONST uint NORMAL_QUILTED = 7u;  ///< Control values.
KERNEL_CONST uint NORMAL_FACETS = 8u;   ///< Coords, size.

/// Wave forms of OP_WAVE.
KERNEL_CONST uint WAVE_RAMP = 0u;
KERNEL_CONST uint WAVE_TRIANGLE = 1u;
KERNEL_CONST uint WAVE_SINE = 2u;
KERNEL_CONST uint WAVE_SCALLOP = 3u;
KERNEL_CONST uint WAVE_CUBIC = 4u;
KERNEL_CONST uint WAVE_POLY = 5u;
KERNEL_CONST uint WAVE_NONE = 6u;  ///< The field as it is, clamped to 0..1.

/// OP_IMAGE's flags.
KERNEL_CONST uint IMAGE_ONCE = 1u;
KERNEL_CONST uint IMAGE_SMOOTH = 2u;
KERNEL_CONST uint IMAGE_CLEAR = 4u;  ///< What the answer is outside an image shown once: clear, not black.

/// TextureInfo::flags.
KERNEL_CONST uint TEXTURE_SRGB = 1u;

/// TextureRef::flags: clamp, and the channel of scalar maps in bits 1..3 (0 r, 1 g, 2 b, 3 a, 4 luminance).
KERNEL_CONST uint TEXTURE_CLAMP = 1u;
KERNEL_CONST uint TEXTURE_CHANNEL_SHIFT = 1u;
/// Further bits of TextureRef::flags: how an axis goes on outside of 0..1 where the two differ or turn back, a texel
/// without its neighbours, TextureRef::shear, and a map whose numbers are 0 below TextureRef::strength, else 1.
KERNEL_CONST uint TEXTURE_CLAMP_U = 16u;
KERNEL_CONST uint TEXTURE_CLAMP_V = 32u;
KERNEL_CONST uint TEXTURE_MIRROR_U = 64u;
KERNEL_CONST uint TEXTURE_MIRROR_V = 128u;
KERNEL_CONST uint TEXTURE_NEAREST = 256u;
KERNEL_CONST uint TEXTURE_TURNED = 512u;
KERNEL_CONST uint TEXTURE_CUTOFF = 1024u;
/// If FEATURE_VERTEX_ATTRIBUTES: looked up by the second texture coordinates.
KERNEL_CONST uint TEXTURE_SECOND_UV = 2048u;
/// A normal map that is seen from behind as its own back: what stands out there is a dent.
KERNEL_CONST uint TEXTURE_TURNS_OVER = 4096u;
/// What few textures need: bits that texture_lookup() asks for one by one only where some lane has any.
KERNEL_CONST uint TEXTURE_RARE =
    TEXTURE_CLAMP_U | TEXTURE_CLAMP_V | TEXTURE_MIRROR_U | TEXTURE_MIRROR_V | TEXTURE_NEAREST;

/// FrameParams::features: what this scene and frame need; the rest costs nothing.
KERNEL_CONST uint FEATURE_SMOOTH = 1u;    ///< Some triangle has vertex normals.
KERNEL_CONST uint FEATURE_TEXTURES = 2u;  ///< Some material is textured (uvs are valid).
KERNEL_CONST uint FEATURE_SHADOWS = 4u;
KERNEL_CONST uint FEATURE_MIRRORS = 8u;       ///< Some material reflects.
KERNEL_CONST uint FEATURE_TRANSPARENT = 16u;  ///< Some material transmits.
KERNEL_CONST uint FEATURE_HIGHLIGHTS = 32u;
KERNEL_CONST uint FEATURE_ANALYTIC = 64u;    ///< Some sphere, box or plane.
KERNEL_CONST uint FEATURE_INSTANCES = 128u;  ///< Some geometry moves.
KERNEL_CONST uint FEATURE_CULL = 256u;       ///< Back faces of opaque materials are not there.
KERNEL_CONST uint FEATURE_BUMP = 512u;       ///< Some material has a bump or normal map.

KERNEL_CONST uint FEATURE_PATTERNED = 1024u;     ///< Some material is a texture of layers.
KERNEL_CONST uint FEATURE_ATMOSPHERE = 2048u;    ///< Fog, a rainbow or a sky sphere.
KERNEL_CONST uint FEATURE_LIGHT_SHAPES = 4096u;  ///< Some light is a spot, a cylinder, an area or fades.
KERNEL_CONST uint FEATURE_HIDDEN = 8192u;        ///< Some geometry is hidden from some rays.
KERNEL_CONST uint FEATURE_NORMALS = 16384u;      ///< Some layer's normal is bent by patterns.

KERNEL_CONST uint FEATURE_BACKLIT = 32768u;       ///< Some material is MATERIAL_BACKLIT.
KERNEL_CONST uint FEATURE_LIGHT_GROUPS = 65536u;  ///< Some light doesn't reach everything.
KERNEL_CONST uint FEATURE_DISPERSION = 131072u;   ///< Some interior disperses light (the CPU device's alone).
KERNEL_CONST uint FEATURE_EXPONENTS = 262144u;    ///< Some layer has a reflection_exponent (the CPU device's alone).

KERNEL_CONST uint FEATURE_BSDF = 524288u;        ///< Some material has a Bsdf.
KERNEL_CONST uint FEATURE_RADIOSITY = 1048576u;  ///< Light that surfaces send each other (the CPU device's alone).
KERNEL_CONST uint FEATURE_MEDIA = 2097152u;      ///< Participating media.
KERNEL_CONST uint FEATURE_HOLLOW =
    4194304u;  ///< Media; or fog, and something that isn't hollow: rays keep MediaInsides.
KERNEL_CONST uint FEATURE_PHOTONS = 8388608u;       ///< Caustics by photons (the CPU device's alone).
KERNEL_CONST uint FEATURE_CAUSTICS = 16777216u;     ///< Some interior brightens shadows (POV-Ray's `caustics`).
KERNEL_CONST uint FEATURE_ENVIRONMENT = 33554432u;  ///< FrameParams::environment is what rays see that miss all else.
KERNEL_CONST uint FEATURE_VEILS = 67108864u;        ///< Some material lets light pass that doesn't bend.
/// Some vertex has a colour, a tangent or second texture coordinates: each has VERTEX_UVS entries of `uvs`.
KERNEL_CONST uint FEATURE_VERTEX_ATTRIBUTES = 134217728u;
KERNEL_CONST uint FEATURE_ONE_SIDED = 268435456u;  ///< The eye may see some MATERIAL_ONE_SIDED from behind.
/// Some layer lets light in that comes out elsewhere (the CPU device's alone).
KERNEL_CONST uint FEATURE_SUBSURFACE = 536870912u;
/// Some Material::interior counts: bodies of materials without layers reach into each other, or hold something.
KERNEL_CONST uint FEATURE_BODIES = 1073741824u;

/// With FEATURE_VERTEX_ATTRIBUTES, a vertex's entries of `uvs`: its texture coordinates, the second ones, red and
/// green, blue and alpha, and a tangent's x and y, z and handedness (1 or -1; all 0: it has none).
KERNEL_CONST uint VERTEX_UVS = 6u;
KERNEL_CONST uint VERTEX_SECOND_UV = 1u;
KERNEL_CONST uint VERTEX_COLOR = 2u;
KERNEL_CONST uint VERTEX_TANGENT = 4u;

/// What the plainest scenes need: opaque, untextured, at rest. The CPU device compiles its kernel once more for them
/// alone.
KERNEL_CONST uint FEATURES_PLAIN =
    FEATURE_SMOOTH | FEATURE_SHADOWS | FEATURE_MIRRORS | FEATURE_HIGHLIGHTS | FEATURE_ANALYTIC | FEATURE_ONE_SIDED;
/// The same for its kernel of paths, to which glass is as plain as mirrors are.
KERNEL_CONST uint FEATURES_PLAIN_PATHS = FEATURES_PLAIN | FEATURE_TRANSPARENT;

/// Most surfaces at which a path may both reflect and refract before the weaker branch is dropped.
KERNEL_CONST uint MAX_BRANCHES = 16u;

/// Transparent surfaces that a shadow ray passes at most; what lies behind more of them is in shadow.
KERNEL_CONST uint MAX_SHADOW_SURFACES = 32u;

/// Interiors with media, or solids, that a ray's origin may be inside of at a time; further ones are not noticed.
KERNEL_CONST uint MAX_MEDIA_INSIDES = 4u;
/// PatternedMaterial::interior of all objects that have none of their own.
KERNEL_CONST uint INTERIOR_PLAIN = 1u;
/// PatternedMaterial::medium of what is not hollow.
KERNEL_CONST uint MEDIUM_SOLID = 0xfffffffeu;
/// Lists of media in `code`: their count, medium_from_world (columns x, y, z, t), the most that their extinction (or
/// what they scatter, if that is more) can be anywhere, where their grid is (NONE: they have none), then MEDIUM_WORDS
/// each: absorption, emission, scattering (3 floats each), extinction, eccentricity, scattering type, number of
/// densities, where their programs are listed, samples of an interval, method, aa_level, aa_threshold, intervals,
/// jitter, ratio, 1 if photons are stored there, and for method 1 the least number of samples, the variance that is
/// good enough, and the normal distribution's quantile of how sure that is to be. See kernel/atmosphere/media.h.
KERNEL_CONST uint MEDIA_LIST_MOST = 13u;
KERNEL_CONST uint MEDIA_LIST_GRID = 14u;
KERNEL_CONST uint MEDIA_LIST_WORDS = 15u;
KERNEL_CONST uint MEDIUM_WORDS = 25u;
/// Grids of media in `code`: grid_from_world (columns x, y, z, t; cells are of size 1, the first at the origin),
/// numbers of cells along x, y and z, what share of MEDIA_LIST_MOST the media have outside of them at most, then that
/// of each cell, x running fastest. See kernel/atmosphere/majorants.h.
KERNEL_CONST uint MEDIA_GRID_COUNTS = 12u;
KERNEL_CONST uint MEDIA_GRID_OUTSIDE = 15u;
KERNEL_CONST uint MEDIA_GRID_WORDS = 16u;
/// Rainbows in `code`: their count, then RAINBOW_WORDS each: direction (unit), up (unit, across it), angle, one over
/// the width, distance, jitter, half the arc and half of what of it is there in full (radians), the program of its
/// colours along x. See kernel/atmosphere/rainbow.h.
KERNEL_CONST uint RAINBOW_WORDS = 13u;
/// Most entries of aa_level: how often a step may be halved.
KERNEL_CONST uint MAX_HALVINGS = 8u;

struct Triangle {
    uint p0, p1, p2;  ///< Indices into positions.
    uint material;
};

/// Per-corner indices into normals or uvs; NONE in `a` where the triangle has none.
struct TriangleCorners {
    uint a, b, c;
};

struct Sphere {
    vec3 center;
    float radius;
    uint material;
};

struct Plane {
    vec3 normal;   ///< Unit.
    float offset;  ///< dot(normal, p) = offset.
    uint material;
    uint geometry;  ///< Planes are found by a loop, not by a traversal: their Geometry's index.
};

struct Box {
    vec3 lower;
    vec3 upper;
    uint material;
};

/// One object: a run of primitives of one kind.
struct Geometry {
    uint kind;             ///< GEOMETRY_*
    uint first_primitive;  ///< Into triangles, spheres, boxes or planes.
    uint primitive_count;
    uint instance;       ///< Into instances; NONE where primitives are in world space.
    uint hidden_from;    ///< RAY_* bits of rays that don't see it.
    uint photons;        ///< PHOTONS_* bits and the number of a target.
    uint interior_copy;  ///< What is added to PatternedMaterial::interior (but INTERIOR_PLAIN) on it.
};

/// World placement of a moving geometry in this frame. Columns and translation of affine maps.
struct Instance {
    vec3 world_from_object_x, world_from_object_y, world_from_object_z, world_from_object_t;
    vec3 object_from_world_x, object_from_world_y, object_from_world_z, object_from_world_t;
};

/// A use of a texture: uv' = uv*scale + offset, and where TEXTURE_TURNED is set + (v, u)*shear.
struct TextureRef {
    uint texture;  ///< Into textures, or NONE.
    uint flags;
    vec2 scale;
    vec2 offset;
    vec2 shear;
    float strength;
};

/// Where a texture's texels lie: rgba8 (0xAABBGGRR), row 0 at the top.
struct TextureInfo {
    uint first_texel;
    uint width, height;
    uint flags;
};

/// A surface for Whitted tracing, all colours linear RGB. Weights obey reflectance + transmittance <= 1 per channel.
struct Material {
    vec3 emission;
    vec3 ambient;  ///< Times FrameParams::ambient.
    vec3 diffuse;
    vec3 specular;  ///< Colour of the highlight.
    float shininess;
    vec3 reflectance;    ///< Mirror weight at normal incidence (times Fresnel when MATERIAL_FRESNEL).
    vec3 transmittance;  ///< Weight of the ray that passes through; 0 for opaque.
    float ior;           ///< Inside over outside; 1 passes straight.
    uint flags;
    vec3 checker_other;
    vec2 checker_cells;
    uint maps;       ///< Into `material_maps`.
    uint patterned;  ///< Into `patterned`, if MATERIAL_PATTERNED.
    /// Mean luminance of what it emits, where paths aim at surfaces that shine; 0: they don't at its.
    float emission_power;
    uint bsdf;      ///< Into `bsdfs`, by which paths scatter; NONE: by the above.
    uint interior;  ///< If FEATURE_BODIES: what it encloses, into `interiors`; 0: nothing that bends light.
};

/// A reflection model of a material, for paths (kernel/bsdf). Kinds use what they need.
struct Bsdf {
    uint kind;  ///< BSDF_*
    vec3 color;
    float alpha_x, alpha_y;  ///< As in BsdfPoint.
    vec3 n, k;               ///< A metal's index of refraction.
    float ior;
    // BSDF_PRINCIPLED.
    float metallic, roughness;
    float specular;
    vec3 specular_color;
    float transmission;
    uint thin;         ///< 1: a wall without thickness.
    vec3 attenuation;  ///< Light inside dims by exp(-attenuation * distance).
    float coat, coat_roughness;
    vec3 sheen;
    float sheen_roughness;
    float film, film_ior, film_least_nm, film_most_nm;
    float anisotropy, anisotropy_rotation;
    float dispersion;  ///< Of the index of refraction: from red to violet it grows by (ior - 1) / 20 times this.
    float opacity;
    uint maps;  ///< Into `bsdf_maps`, or NONE.
};

/// The maps of a reflection model (BSDF_MAP_*).
struct BsdfMaps {
    TextureRef map[BSDF_MAP_COUNT];
};

/// The textures of a material. Number 0 has none.
struct MaterialMaps {
    TextureRef diffuse, specular, emission, opacity, bump, normal;
    TextureRef occlusion;  ///< Of ambient light; `strength` is its share.
};

/// A texture of layers where it lies on an object, and what is inside the object. Lanes whose materials have the same
/// `look` are shaded together.
struct PatternedMaterial {
    uint look;  ///< Into `patterned`: the first that has the same place, layers and lighting; itself where none has.
    vec3 color;
    float filtered, transmitted;  ///< With `color`, of the layer whose program is NONE.
    vec3 texture_from_world_x, texture_from_world_y, texture_from_world_z, texture_from_world_t;
    uint first_layer, layer_count;  ///< Into `layers`, the top one first.
    uint interior;                  ///< Into `interiors`; 0: none.
    uint medium;     ///< What is inside: media (a list of them in `code`), MEDIUM_SOLID, or NONE: what is around it.
    uint light_set;  ///< If FEATURE_LIGHT_GROUPS: into `code`, bit k of which tells if light group k reaches it.
    uint double_illuminated;  ///< 1: lit on its back as on its front.
};

/// What is inside an object. Number 0 is the open air.
struct Interior {
    float ior;
    float fade_distance, fade_power;  ///< Light dims on its way; power 0: not at all; 1000 and more: exponentially.
    vec3 fade_color;
    float dispersion;         ///< Index of refraction of violet over that of red light.
    uint dispersion_samples;  ///< Colours that light is split into.
    /// If FEATURE_CAUSTICS: shadow rays are brightened by the cosine at its surfaces to this power; 0: not.
    float caustics;
    vec3 attenuation;  ///< Of bodies (kernel/materials/body.h): light in it dims by exp(-attenuation * distance).
};

/// One layer: a pigment and a finish, with POV-Ray's meaning (reference, section 3.5.4). Colours linear.
struct Layer {
    uint program;  ///< Into `code`; NONE: the colour is the PatternedMaterial's.
    uint flags;    ///< LAYER_*
    uint uses_uv;  ///< 1: the pigment is looked up at (u, v, 0).
    uint normal;   ///< Into `code`: a list of normals; NONE: the surface's own.
    uint normal_uses_uv;
    vec3 ambient;  ///< Times FrameParams::ambient.
    vec3 emission;
    float diffuse, diffuse_back, brilliance;
    float phong, phong_size;
    float specular, specular_exponent;
    float metallic;
    vec3 reflection_min, reflection_max;
    float reflection_falloff;
    float reflection_metallic;
    float reflection_exponent;  ///< If FEATURE_EXPONENTS: one over the exponent of the radiance that is reflected.
    float crand;                ///< Random darkening of matt light, at most.
    float irid, irid_thickness, irid_turbulence;  ///< A thin film; amount 0: none.
    /// If FEATURE_SUBSURFACE: how far light goes below the surface before it is scattered; all 0: it doesn't enter.
    vec3 translucency;
};

struct Light {
    vec3 place;  ///< Position; sun: unit direction towards it.
    vec3 color;
    uint kind;
    uint flags;          ///< LIGHT_*
    vec3 axis;           ///< spot, cylinder: unit direction in which it shines.
    float bright, dark;  ///< spot: cosines of the half angles of the bright and the outer cone; cylinder: radii.
    float tightness;     ///< Exponent towards the rim.
    float fade_distance, fade_power;  ///< Power 0: no falloff with distance.
    vec3 area_u, area_v;              ///< An area's sides; it is centred on place.
    uint area_count_u, area_count_v;  ///< Lights along them; 1 by 1: a point.
    uint area_probes;  ///< Lights a side that are asked first: where they agree, they speak for all. 0: ask all.
    uint group;        ///< Light group; 0: of the whole scene. See PatternedMaterial::light_set.
    uint projection;   ///< RAY_* bit of the object that it shines through alone; 0: none.
};

/// Something that paths aim at for its light, as an entry of an alias table (kernel/lights/emitter.h).
struct Emitter {
    uint kind;      ///< EMITTER_*
    uint index;     ///< Into triangles, spheres or lights.
    uint geometry;  ///< Of the triangle or sphere.
    float keep;     ///< Share of the entry's turns that are its own,
    uint alias;     ///< and whose the others are.
    float probability;
};

/// What is around the scene, infinitely far away: see kernel/atmosphere/environment.h.
struct Environment {
    vec3 up, middle, right;       ///< Unit: the axis, the direction of the picture's middle, and that to its right.
    uint width, height;           ///< Of the picture, in `tables`.
    uint cells_wide, cells_high;  ///< Of the grid by which directions are drawn.
    /// Where its cells begin in `tables`, entries of an alias table: share of an entry's turns that are its own, whose
    /// the others are (the bits of that number), and the density over solid angle of a direction in the cell, times the
    /// sine of its angle to the axis. 0: all is dark.
    uint first_cell;
    float gain;
    float probability;  ///< With which it is drawn among the emitters.
};

/// Pinhole: a ray through image point (x, y) in [0,1]^2 (y down) starts at eye, towards
/// center + right*(2x-1) + up*(1-2y). Other kinds use the same vectors in their own way.
struct Camera {
    vec3 eye;
    vec3 center;  ///< From the eye to the middle of the window.
    vec3 right;   ///< Half the window's width.
    vec3 up;      ///< Half the window's height.
};

/// Fog (POV-Ray's reference, section 3.4.4.2). What is behind it is dimmed to the share 1/e over `distance`.
struct Fog {
    uint ground;  ///< 1: full at the height `offset` and below, thinning out upwards.
    float distance;
    vec3 color;
    float filter_share, transmit_share;  ///< How much of the dimmed light is tinted; how much of it passes at least.
    float altitude, offset;
    vec3 up;           ///< Unit.
    vec3 turbulence;   ///< Noise is asked at places times this …
    float turb_depth;  ///< … and thins the fog out by this times it; 0: none.
    float lambda, omega;
    uint octaves, noise_generator;
};

/// A pigment on the infinitely far sphere: its program is asked at the ray's direction.
struct SkyLayer {
    uint program;
    vec3 sky_from_world_x, sky_from_world_y, sky_from_world_z;
    vec3 emission;
};

/// Where in and around its pixel a sample lies (kernel/cameras/pixel_samples.h).
struct PixelSampling {
    uint pattern;       ///< SAMPLES_*
    uint cells;         ///< Cells on a side of a pixel's grid; for SAMPLES_SOBOL, how many samples go by one scrambling
                        ///< before the next (0: all).
    uint pixel_filter;  ///< FILTER_*
    float radius;       ///< The filter's, in pixels.
};

/// What changes from frame to frame, one per picture.
struct FrameParams {
    Camera camera;
    uint camera_kind;                           ///< CAMERA_*
    float camera_angle, camera_vertical_angle;  ///< Radians, of the whole view; kinds that have one.
    vec3 ambient;
    vec3 sky;
    vec3 irid_wavelength;  ///< Of red, green and blue light, in units of films' thickness.
    uint width, height;
    PixelSampling sampling;
    uint max_depth;    ///< Secondary rays on a path at most; 0: what the eye sees directly.
    float min_weight;  ///< A secondary ray of less weight (its largest channel) is not traced.
    float far_z;       ///< Far clip depth along the view axis; infinite for none.
    uint light_count;
    uint plane_count;
    uint fog_count;
    uint sky_layer_count;
    uint features;        ///< FEATURE_* bits
    uint aovs;            ///< AOV_* bits wanted
    float working_gamma;  ///< The scene's numbers to this power are linear light; 1 for scenes that are linear; 0 for
                          ///< scenes whose numbers are sRGB-encoded.
    uint seed;
    float lens_radius;         ///< Of a thin lens; 0: a pinhole.
    float focus_distance;      ///< Along the view axis, to what is sharp.
    uint lens_blades;          ///< Sides of its aperture; under 3: it is round.
    uint integrator;           ///< INTEGRATOR_*
    float most_radiance;       ///< A path brings no more than this; 0: as much as there is.
    float occlusion_distance;  ///< Of INTEGRATOR_OCCLUSION.
    uint emitter_count;        ///< 0: nothing that paths could aim at.
    /// If FEATURE_SUBSURFACE: places where light may have entered, and points where it may have been scattered once.
    uint subsurface_samples, subsurface_single_samples;
    float
        emitted_power;  ///< What emitters' probabilities are shares of: emission_power times area, for those with one.
    Environment environment;
    uint rainbows;    ///< A list of them in `code`, or NONE.
    uint atmosphere;  ///< Media that are everywhere: a list of them in `code`, or NONE.
    uint
        eye_insides[MAX_MEDIA_INSIDES];  ///< What the eye is inside of: PatternedMaterial::medium, NONE in free places.
    /// Likewise PatternedMaterial::interior, in the form of `Insides` in kernel/materials/interior.h.
    uint eye_interiors_inner, eye_interiors_outer;
};

/// FrameParams::aovs, and Film's planes.
KERNEL_CONST uint AOV_DEPTH = 1u;   ///< Distance along the ray from the eye; infinite on a miss.
KERNEL_CONST uint AOV_NORMAL = 2u;  ///< World-space shading normal, towards the viewer.
KERNEL_CONST uint AOV_ALBEDO = 4u;  ///< Diffuse colour after textures.
KERNEL_CONST uint AOV_OBJECT = 8u;  ///< Geometry index (NONE on a miss), primitive and material.
KERNEL_CONST uint AOV_COST = 16u;   ///< Rays traced for the pixel.
/// Depth, normal and albedo are means over what is seen through surfaces that don't bend light, too (integrators/
/// seen_through.h); at least AOV_FAR deep where there is nothing. Of Whitted's integrator alone.
KERNEL_CONST uint AOV_BEYOND = 32u;
KERNEL_CONST float AOV_FAR = 1.0e30f;

#ifdef __cplusplus
}  // namespace sundog::kernel
#endif
#undef KERNEL_CONST
#endif
