// SPDX-License-Identifier: Apache-2.0
// The scene as written: plain, located description that importers fill and compile/ flattens. No render objects.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/boxed.h"
#include "base/diagnostics.h"
#include "base/irradiance.h"
#include "base/vec.h"
#include "scene/animation.h"
#include "scene/photons.h"
#include "scene/pigment.h"
#include "scene/principled.h"
#include "scene/reflection_model.h"
#include "scene/solid.h"

namespace sundog::scene {

/// const, wave or linear motion of one number: base + amplitude*sin(speed*t) or speed*t. Angles in degrees,
/// speeds in radians per second (wave) or degrees per second (linear), t in seconds.
struct Motion {
    enum class Kind { constant, wave, linear } kind = Kind::constant;
    float base = 0;
    float speed = 0;
    float amplitude = 0;
};

/// The orbit format's camera: Z up, looks along +Y from `origin`, moved `distance` along -Y, then turned by rot_x
/// about the X-parallel through origin, then by rot_z about the Z-parallel through origin. See docs/manual.
struct OrbitCamera {
    SourceLocation where;
    float focus = 12;  ///< Image plane stands focus/12 from the eye; the window on it is 2 high.
    Motion rot_x_deg, rot_z_deg;
    float distance = 0;
    Vec3 origin;
};

/// Focal blur (POV-Ray's reference, section 3.4.2.3).
struct FocalBlur {
    double aperture = 0;  ///< Four times the lens's radius; 0: a pinhole.
    int least_samples = 0, most_samples = 0;
    Vec3d focal_point;
    double confidence = 0.9, variance = 1.0 / 128;  ///< How sure and how exact a pixel is to be.
    std::shared_ptr<const Pigment> bokeh;           ///< How bright the lens is, over the unit square; null: evenly.
};

/// A camera whose rays start on triangles (POV-Ray's reference, section 3.4.2.2.3), along their normals.
struct MeshCamera {
    int rays_per_pixel = 1;
    int distribution = 0;     ///< 0 to 3
    double max_distance = 0;  ///< 0: no end.
    double offset = 0;        ///< How far off the triangle rays start.
    bool reversed = false, smooth = false;
    std::vector<std::shared_ptr<const SolidMesh>> meshes;  ///< In world space.
};

/// A camera of functions of a picture's x and y, each -0.5 to 0.5 (POV-Ray 3.8).
struct FunctionCamera {
    std::shared_ptr<const Function> location, direction;  ///< 3 inputs (x, y, 0), 3 outputs; null: those vectors.
    Affine3d world_from_camera;
};

/// A camera placed by vectors, as POV-Ray describes it (reference, section 3.4.1 "Camera"). look_at, angle and sky are
/// already worked into the vectors. A left- or right-handed system is told by `right`.
struct ProjectionCamera {
    enum class Kind : std::uint8_t {
        perspective,
        orthographic,
        fisheye,
        ultra_wide_angle,
        omnimax,
        panoramic,
        cylinder,
        spherical,
    };
    Kind kind = Kind::perspective;
    SourceLocation where;
    Vec3d location, direction{0, 0, 1}, right{1.33, 0, 0}, up{0, 1, 0};
    double angle_deg = 0;           ///< Fisheye, ultra_wide_angle, panoramic, cylinder, spherical: horizontally.
    double vertical_angle_deg = 0;  ///< spherical
    int cylinder_type = 1;          ///< 1 to 4
    Vec3d sky{0, 1, 0};             ///< Upwards in the scene, whichever way the camera is tilted.
    FocalBlur blur;
    std::shared_ptr<const Normal> normal;            ///< Bends the rays; null: not.
    std::shared_ptr<const MeshCamera> mesh;          ///< Instead of the projection.
    std::shared_ptr<const FunctionCamera> function;  ///< Instead of the projection.
    bool fits_picture = false;   ///< Perspective: as wide as the picture's pixels ask, not as `right` says.
    Boxed<NodeMotion> motion{};  ///< Moves it: the vectors are then in the space of a node.
};

/// A rectangle (or, `circular`, a disc) of lights around a light's place.
struct LightArea {
    Vec3 axis1, axis2;
    int size1 = 1, size2 = 1;
    int adaptive = -1;  ///< Depth of adaptive sampling; under 0: all of them.
    bool jitter = false, circular = false, orient = false;
    bool illuminates = false;  ///< Each of its lights lights; else they only cast shadows, of a light in the middle.
};

/// A light without size, unless it has an `area`. A moving one stands at place + (cos(t*sx)*ax, sin(t*sy)*ay,
/// cos(t*sz)*az).
struct Light {
    enum class Kind { lamp, sun, spotlight, cylinder } kind = Kind::lamp;
    SourceLocation where;
    Vec3 place;           ///< Position. sun: the direction in which its light comes from (towards the sun).
    Vec3 color{1, 1, 1};  ///< Linear RGB radiant intensity (no distance falloff, as in Whitted's and Phong's model).
    bool moving = false;
    Vec3 speed, amplitude;       ///< Used when moving; speed in radians per second.
    Boxed<NodeMotion> motion{};  ///< Moves it instead: place and point_at are then in the space of a node.
    bool shadows = true;
    bool media_attenuation = false;  ///< Fog and the atmosphere's media dim it on its way to what it lights.
    bool media_interaction = true;   ///< Media scatter it.
    bool highlights = true;          ///< A shadowless or fill light of POV-Ray's has none.
    Vec3 point_at;                   ///< spotlight, cylinder
    float radius = 30,
          falloff = 45;   ///< spotlight: half angles of the bright and the outer cone, degrees; cylinder: lengths.
    float tightness = 0;  ///< Exponent of the cosine towards the rim.
    float fade_distance = 0, fade_power = 0;
    std::optional<LightArea> area;
    std::uint32_t group = 0;  ///< Of lights that reach only what some LightSet names them for; 0: of the whole scene.
    LightPhotons photons;
    std::uint32_t projection =
        0;  ///< It shines only through objects with this number of Object::projects; 0: everywhere.
};

/// Which lights reach a surface (POV-Ray's light_group).
struct LightSet {
    bool scene_lights = true;  ///< Those of group 0.
    std::vector<std::uint32_t> groups;
    bool operator==(const LightSet&) const = default;
};

/// Texture pixels, row 0 at the top. 8-bit RGBA; `srgb` says whether RGB is sRGB-encoded (else linear data).
struct Texture {
    std::string name;
    SourceLocation where;
    std::uint32_t width = 0, height = 0;
    std::vector<std::uint32_t> rgba8;  ///< 0xAABBGGRR, width*height entries.
    bool srgb = true;
};

/// Two-colour checker on UVs: cells_u * cells_v squares per unit square; diffuse alternates with `other`.
struct Checker {
    float cells_u = 8, cells_v = 8;
    Vec3 other;
};

/// A surface as MTL describes it (Wavefront 1995 and the PBR extension), kept as written; compile/ maps it to lobes.
struct MtlSurface {
    std::optional<Vec3> ambient;        ///< Ka; where absent, diffuse stands in.
    Vec3 diffuse{0.8F, 0.8F, 0.8F};     ///< Kd
    Vec3 specular{0, 0, 0};             ///< Ks
    Vec3 emission{0, 0, 0};             ///< Ke
    Vec3 transmission_filter{1, 1, 1};  ///< Tf
    float shininess = 0;                ///< Ns
    float ior = 1;                      ///< Ni
    float opacity = 1;                  ///< d (Tr = 1 - d)
    int illum = 2;
    std::optional<float> roughness, metallic, clearcoat;  ///< Pr Pm Pc
    bool phong_highlight = false;  ///< Own MTL key `highlight phong`: Phong's mirrored ray, not Blinn's halfway vector.
    std::optional<ReflectionModel> model;  ///< Own MTL key `bsdf`: paths scatter by it.
    std::optional<Checker> checker;        ///< Own MTL key `checker_Kd u v r g b`.
    TextureUse map_diffuse, map_specular, map_bump, map_normal, map_opacity, map_emission;
};

/// What a surface looks like. A scene may have one for each of a million spheres.
struct Material {
    std::string name;
    SourceLocation where;
    Boxed<MtlSurface> mtl;
    /// A procedural surface, in which case `mtl` doesn't count.
    Boxed<PatternedSurface> patterned;
    /// A physically based surface, in which case neither of the others counts.
    Boxed<PrincipledSurface> principled;
};

/// Triangles with indices into shared vertex arrays. Every index is in range; every number finite.
struct Mesh {
    struct Triangle {
        std::uint32_t position[3];
        std::uint32_t normal[3];    ///< kNone in all three: flat.
        std::uint32_t texcoord[3];  ///< kNone in all three: none.
        Index material;
    };
    /// What few meshes have beside texture coordinates.
    struct Attributes {
        Vec2 second_texcoord;
        Vec3 color{1, 1, 1};   ///< Linear RGB; multiplies a principled surface's base colour,
        float alpha = 1;       ///< and this its alpha.
        Vec3 tangent;          ///< Along a normal map's x; zero: as the texture coordinates say.
        float handedness = 1;  ///< Along its y goes the normal's cross product with the tangent, times this.
    };
    std::vector<Vec3> positions, normals;
    std::vector<Vec2> texcoords;
    std::vector<Attributes> attributes;  ///< As many as texcoords, or none.
    std::vector<Triangle> triangles;
};

struct Sphere {
    Vec3 center;
    float radius = 1;
};
/// All points p with dot(normal, p) = offset, unit normal; infinite.
struct Plane {
    Vec3 normal{0, 0, 1};
    float offset = 0;
};
/// Axis-aligned (in object space).
struct Box {
    Vec3 lower, upper;
};

/// A moving object: turned about the Z-parallel (X-parallel) through `center`, and moved by
/// amplitude*sin(speed*t) per axis.
struct ObjectMotion {
    Vec3 center;
    Motion rot_x_deg, rot_y_deg, rot_z_deg;
    Vec3 move_speed, move_amplitude;
};

struct Deformation;

/// A thing with one bounding box: an OBJ object (mesh), or an analytic shape with one material.
struct Object {
    std::string name;
    SourceLocation where;
    std::variant<Boxed<Mesh>, Sphere, Plane, Box, std::shared_ptr<const Solid>> shape;
    Index material = 0;               ///< For analytic shapes and solids that inherit; a mesh's triangles name theirs.
    Boxed<ObjectMotion> motion;       ///< With none, and no node_motion: it rests.
    bool casts_shadow = true;         ///< no_shadow
    bool seen_by_camera = true;       ///< no_image
    bool seen_in_reflections = true;  ///< no_reflection
    bool seen_by_radiosity = true;    ///< no_radiosity
    Boxed<ObjectPhotons> photons{};   ///< Few objects have any to do with them.
    /// Objects with the same number have their interior from one place, as the parts of a union do that has it; 0: of
    /// its own.
    std::uint32_t interior_owner = 0;
    std::uint32_t projects = 0;       ///< Not seen at all: what some Light::projection shines through; 1 to 24.
    Boxed<NodeMotion> node_motion{};  ///< Instead of `motion`.
    std::shared_ptr<const Deformation> deformation{};  ///< Bends the mesh over time: see deformation.h.
};

/// Settings that a scene file may fix and the command line may overrule.
struct Settings {
    std::optional<int> width, height;
    std::optional<bool> fullscreen;
    std::optional<float> freeze_s;  ///< Show only this moment.
    std::optional<int> max_depth;
    std::optional<bool> shadows;
    std::optional<float> min_weight;  ///< reflThreshold
    std::optional<float> far_z;
    bool cull_backfaces = false;
    /// Exponent from the scene's colours and the radiance computed with them to linear light (POV-Ray's assumed_gamma,
    /// its reference, section 3.4.1.3): a picture's pixels are the computed ones to this power. 0: the colours are
    /// sRGB-encoded, and a picture's pixels are the computed ones decoded.
    float working_gamma = 1;
};

/// Fog of constant density (distance: where it lets 1/e through), or thinning out upwards from `offset` over
/// `altitude`.
struct Fog {
    bool ground = false;
    float distance = 0;
    PigmentColor color;
    float altitude = 0, offset = 0;
    Vec3 up{0, 1, 0};
    Vec3 turbulence{0, 0, 0};  ///< Noise that thins it out is asked at places times this; 0: none.
    float turb_depth = 0.5F;   ///< How much so.
    float lambda = 2, omega = 0.5F;
    int octaves = 6, noise_generator = 2;
};

/// A rainbow (section 3.4.3.5, whose names and defaults these are). Angles in radians.
struct Rainbow {
    SourceLocation where;
    Vec3 direction{0, 0, 0}, up{0, 1, 0};
    float angle = 0, width = 0;
    float distance = 1e7F;
    float jitter = 0;
    std::optional<float> arc_angle, falloff_angle;  ///< None: all around, and in full.
    std::shared_ptr<const Pigment> colors;          ///< Along x from 0, innermost, to 1.
};

/// A pigment on the infinitely far sphere, looked up by direction. Later ones lie over earlier ones.
struct SkySphere {
    std::vector<std::shared_ptr<const Pigment>> pigments;
    Affine3d sky_from_world;
    PigmentColor emission{1, 1, 1, 0, 0};
};

/// Light from infinitely far away: a picture of all directions (latitude and longitude), its top row upwards.
struct Environment {
    std::string name;
    std::uint32_t width = 0, height = 0;
    std::vector<Vec3> radiance;  ///< Linear RGB, width*height, row 0 at the top.
    Vec3 up{0, 0, 1};            ///< Unit.
    Vec3 middle{0, 1, 0};        ///< Where the picture's middle column lies; unit, across up.
    float gain = 1;              ///< Times radiance.
};

/// Light that surfaces send each other (POV-Ray's reference, section 3.4.4.3 "Radiosity", whose names and defaults
/// these are).
struct Radiosity {
    SourceLocation where;
    int count = 35;
    int recursion_limit = 2;
    int nearest_count = 5;
    float error_bound = 1.8F, low_error_factor = 0.5F;
    float minimum_reuse = 0.015F, maximum_reuse = 0.2F;
    float pretrace_start = 0.08F, pretrace_end = 0.04F;
    float gray_threshold = 0, brightness = 1, max_sample = 0, adc_bailout = 0.01F;
    bool normal = false, media = false, always_sample = false;
    bool keeps_ambient = false;                     ///< Scenes from before version 3.7: `ambient` counts all the same.
    std::shared_ptr<const StoredRadiosity> loaded;  ///< Known from the start.
    std::shared_ptr<const RadiosityStore> store;    ///< Where what was gathered is kept; null: nowhere.
};

/// Light that enters a surface and comes out elsewhere (section 3.4.6.3.3.4 "Subsurface Light Transport"): finishes
/// with a translucency have it only where the scene asks for it.
struct Subsurface {
    SourceLocation where;
    int samples = 50;         ///< Of places where light enters,
    int single_samples = 50;  ///< and of points where it is scattered once.
};

/// A whole scene. Value type; importers make it, compile/ reads it.
struct Scene {
    std::string name;
    std::vector<std::string> files;     ///< Every file that was read, for hot reload.
    std::vector<std::string> variants;  ///< Names of other sets of materials that the file has.
    OrbitCamera camera;
    std::optional<ProjectionCamera> projection_camera;  ///< Instead of `camera`.
    std::vector<Light> lights;
    std::vector<LightSet> light_sets;  ///< PatternedSurface::light_set counts them from 1.
    std::vector<Texture> textures;
    std::vector<Material> materials;  ///< Never empty once imported.
    std::vector<Object> objects;
    Vec3 ambient{0.1F, 0.1F, 0.1F};             ///< Linear RGB, multiplies Ka.
    Vec3 irid_wavelength{0.70F, 0.52F, 0.48F};  ///< Of red, green and blue light, as thin films are measured.
    Vec3 sky{0, 0, 0};                          ///< Linear RGB radiance of rays that hit nothing.
    float sky_alpha = 1;                        ///< Opacity of the sky in pictures that have alpha.
    std::vector<Fog> fogs;
    std::vector<Rainbow> rainbows;
    std::vector<Medium> atmosphere;  ///< Media that are everywhere.
    std::vector<SkySphere> sky_spheres;
    std::optional<Environment> environment;  ///< Instead of `sky`.
    std::optional<Radiosity> radiosity;
    std::optional<Photons> photons;
    std::optional<Subsurface> subsurface;
    float mm_per_unit = 10;  ///< What a unit of the scene stands for, in millimetres.
    Settings settings;
};

/// Value of a motion at time_s.
float value_at(const Motion& motion, float time_s);
/// A light where it is at time_s, at rest.
Light placed_at(const Light& light, float time_s);
/// A camera where it is at time_s, at rest.
ProjectionCamera placed_at(const ProjectionCamera& camera, float time_s);
/// True if an object moves, be it only now and then.
bool moves(const Object& object);
/// world_from_object of a moving object at time_s.
Affine3 transform_at(const ObjectMotion& motion, float time_s);
Affine3 transform_at(const Object& object, float time_s);
/// True if anything in the scene depends on time.
bool is_animated(const Scene& scene);

}  // namespace sundog::scene
