// SPDX-License-Identifier: Apache-2.0
// Cameras, lights, shapes, groups and settings.
#include "import/pov/build_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "import/pov/build_test_scene.h"

namespace sundog::pov {
namespace {

using scene::Solid;

void expect_near(Vec3d actual, Vec3d expected, double error = 1e-9) {
    EXPECT_NEAR(actual.x, expected.x, error);
    EXPECT_NEAR(actual.y, expected.y, error);
    EXPECT_NEAR(actual.z, expected.z, error);
}
void expect_near(Vec3 actual, Vec3d expected) { expect_near(to_double(actual), expected, 1e-6); }

scene::ProjectionCamera camera(std::string_view text) {
    return *build("camera { " + std::string(text) + " }").scene.projection_camera;
}

const Solid& solid(const BuiltScene& built, std::size_t i = 0) {
    return *std::get<std::shared_ptr<const Solid>>(built.scene.objects.at(i).shape);
}

// A camera that turns but doesn't keep the lengths of its vectors: wrong field of view.
TEST(BuildCamera, LooksAtAPointAndKeepsItsLengths) {
    const auto c = camera("location <0, 0, -5> look_at <5, 0, 0> right 2*x up 3*y direction 4*z");
    const double s = std::sqrt(0.5);
    expect_near(c.direction, {4 * s, 0, 4 * s});
    expect_near(c.right, {2 * s, 0, -2 * s});
    expect_near(c.up, {0, 3, 0});
}

// A right-handed camera (negative right) that look_at turns into a left-handed one: mirrored pictures.
TEST(BuildCamera, KeepsItsHand) {
    const auto c = camera("location <0, 0, 10> right -1.5*x look_at 0");
    expect_near(c.right, {1.5, 0, 0});
    expect_near(c.up, {0, 1, 0});
}

// angle taken for the half angle, or for the vertical one.
TEST(BuildCamera, AngleIsTheWholeHorizontalOne) {
    const auto c = camera("right 2*x angle 90");
    EXPECT_NEAR(length(c.direction), 1, 1e-12);
}

// Items worked in as they come: POV-Ray 3.7 orders them itself, only transformations come last.
TEST(BuildCamera, OrderOfItemsDoesNotMatter) {
    const auto a = camera("look_at <1, 2, 3> angle 40 sky <0.2, 1, 0> right 1.6*x location <0, 1, -5>");
    const auto b = camera("location <0, 1, -5> right 1.6*x sky <0.2, 1, 0> angle 40 look_at <1, 2, 3>");
    expect_near(a.direction, b.direction);
    expect_near(a.right, b.right);
    expect_near(a.up, b.up);
}

// Looking along the sky vector must not give vectors without direction.
TEST(BuildCamera, LooksStraightDown) {
    const auto c = camera("location <0, 5, 0> look_at 0");
    expect_near(c.right, {1.33, 0, 0});
    expect_near(c.up, {0, 0, 1});
}

// An orthographic camera without a size sees what a perspective one does in the plane of look_at.
TEST(BuildCamera, OrthographicTakesItsSizeFromTheDistance) {
    const auto c = camera("orthographic location <0, 0, -6> look_at 0");
    EXPECT_NEAR(length(c.up), 6, 1e-12);
    EXPECT_NEAR(length(camera("orthographic location <0, 0, -6> right 4*x up 3*y look_at 0").up), 3, 1e-12);
}

TEST(BuildCamera, MovesAsAWhole) {
    const auto c = camera("direction z rotate 90*y translate <1, 2, 3>");
    expect_near(c.location, {1, 2, 3});
    expect_near(c.direction, {1, 0, 0});
    expect_near(c.right, {0, 0, -1.33});
}

// Scenes without a camera still show something.
TEST(BuildScene, HasACameraAndAMaterialInAnyCase) {
    const BuiltScene built = build("");
    expect_near(built.scene.projection_camera->direction, {0, 0, 1});
    EXPECT_EQ(built.scene.materials.size(), 1U);
}

// Parallel light that comes from its place to the origin instead of to point_at; lights of a union left behind.
TEST(BuildLight, ParallelLightShinesFromPlaceToPointAt) {
    const BuiltScene built =
        build("union { light_source { <0, 10, 0> rgb <1, 2, 3> parallel point_at <0, 10, 5> } translate x*7 }");
    const scene::Light& light = built.scene.lights.at(0);
    EXPECT_EQ(light.kind, scene::Light::Kind::sun);
    expect_near(light.place, {0, 0, -1});
    expect_near(light.color, {1, 2, 3});
}

TEST(BuildLight, AreaAndSpotMoveWithTheLight) {
    const BuiltScene built = build(
        "light_source { <1, 0, 0> rgb 1 spotlight radius 10 falloff 20 point_at <2, 0, 0>"
        " area_light x, y, 3, 4 adaptive 1 jitter rotate 90*z }");
    const scene::Light& light = built.scene.lights.at(0);
    expect_near(light.place, {0, 1, 0});
    expect_near(light.point_at, {0, 2, 0});
    expect_near(light.area->axis1, {0, 1, 0});
    EXPECT_EQ(light.area->size2, 4);
    EXPECT_EQ(light.area->adaptive, 1);
    EXPECT_TRUE(light.area->jitter);
    EXPECT_FLOAT_EQ(light.falloff, 20);
}

// Areas that turn to what they light: povray makes them round and square, and says so. Catches sides that stay as they
// are written, and words about lights that need none.
TEST(BuildLight, AreasThatTurnAreRoundAndAsHighAsWide) {
    const BuiltScene built = build("light_source { y, rgb 1 area_light 3*x, 0.5*z, 3, 3 orient }");
    EXPECT_EQ(built.warnings.size(), 2U);
    const scene::LightArea& area = *built.scene.lights.at(0).area;
    EXPECT_TRUE(area.circular);
    EXPECT_FLOAT_EQ(length(area.axis1), 3);
    EXPECT_FLOAT_EQ(length(area.axis2), 3);
    EXPECT_TRUE(build("light_source { y, rgb 1 area_light 3*x, 3*z, 3, 3 circular orient }").warnings.empty());
}

/// Which of the scene's lights reach an object.
std::vector<bool> lights_of(const scene::Scene& scene, std::size_t object) {
    const std::uint32_t number = scene.materials.at(scene.objects.at(object).material).patterned->light_set;
    const scene::LightSet set = number == 0 ? scene::LightSet{} : scene.light_sets.at(number - 1);
    std::vector<bool> reached;
    for (const scene::Light& light : scene.lights) {
        const bool named = std::find(set.groups.begin(), set.groups.end(), light.group) != set.groups.end();
        reached.push_back(light.group == 0 ? set.scene_lights : named);
    }
    return reached;
}

// Lights that shine out of their group, or objects that keep the scene's lights though their group says otherwise.
TEST(BuildLight, GroupsKeepTheirLightsToThemselves) {
    const BuiltScene built = build(
        "light_source { y, rgb 1 } sphere { 0, 1 }"
        "light_group { light_source { x, rgb 1 } sphere { 0, 1 } }"
        "light_group { sphere { 0, 1 } light_source { z, rgb 1 } global_lights on }");
    EXPECT_EQ(lights_of(built.scene, 0), (std::vector<bool>{true, false, false}));
    EXPECT_EQ(lights_of(built.scene, 1), (std::vector<bool>{false, true, false}));
    EXPECT_EQ(lights_of(built.scene, 2), (std::vector<bool>{true, false, true}));
}

// Nested groups as povray has them: a declared one gets the outer one's lights, one that is written out doesn't; and
// copies of one declared group that share their lights.
TEST(BuildLight, DeclaredGroupsInheritLights) {
    const BuiltScene built = build(
        "#declare Inner = light_group { light_source { x, rgb 1 } sphere { 0, 1 } }"
        "light_group { light_group { Inner } light_group { Inner } light_source { y, rgb 1 } global_lights on }"
        "light_group { light_group { light_source { x, rgb 1 } sphere { 0, 1 } global_lights on } light_source { z, "
        "rgb "
        "1 } }");
    ASSERT_EQ(built.scene.lights.size(), 5U);
    EXPECT_EQ(lights_of(built.scene, 0), (std::vector<bool>{true, false, true, false, false}));
    EXPECT_EQ(lights_of(built.scene, 1), (std::vector<bool>{false, true, true, false, false}));
    EXPECT_EQ(lights_of(built.scene, 2), (std::vector<bool>{false, false, false, true, false}));
}

// What a light is projected through, drawn like any other object, or left where it was when the light moved.
TEST(BuildLight, ProjectorsAreSeenByTheirLightAlone) {
    const BuiltScene built = build(
        "#declare Window = sphere { 0, 1 }"
        "light_source { y, rgb 1 projected_through { Window translate x } translate 2*y } light_source { y, rgb 1 }");
    ASSERT_EQ(built.scene.objects.size(), 1U);
    EXPECT_EQ(built.scene.objects[0].projects, 1U);
    EXPECT_EQ(built.scene.lights[0].projection, 1U);
    EXPECT_EQ(built.scene.lights[1].projection, 0U);
    expect_near(std::get<scene::Sphere>(built.scene.objects[0].shape).center, {1, 2, 0});
}

// looks_like that stays at the origin, or that shadows its own light.
TEST(BuildLight, LooksLikeStandsAtTheLightWithoutShadow) {
    const BuiltScene built = build("light_source { <1, 2, 3> rgb 1 looks_like { sphere { 0, 0.5 } } translate x }");
    ASSERT_EQ(built.scene.objects.size(), 1U);
    expect_near(std::get<scene::Sphere>(built.scene.objects[0].shape).center, {2, 2, 3});
    EXPECT_FALSE(built.scene.objects[0].casts_shadow);
}

// Spheres and boxes stay what they are under transformations that allow it (they trace fastest), and only then.
TEST(BuildShape, StaysSimpleWhereItCan) {
    const BuiltScene built = build(
        "sphere { <1, 0, 0>, 2 scale 3 rotate 90*z }"
        "sphere { 0, 1 scale <1, 2, 1> }"
        "box { <0, 0, 0>, <1, 2, 3> rotate 90*x translate y }"
        "box { 0, 1 rotate 45*x }"
        "plane { 2*y, 1 translate 3*y }");
    const auto& sphere = std::get<scene::Sphere>(built.scene.objects.at(0).shape);
    expect_near(sphere.center, {0, 3, 0});
    EXPECT_FLOAT_EQ(sphere.radius, 6);
    EXPECT_NO_THROW(solid(built, 1));
    const auto& box = std::get<scene::Box>(built.scene.objects.at(2).shape);
    expect_near(box.lower, {0, -2, 0});
    expect_near(box.upper, {1, 1, 2});
    EXPECT_NO_THROW(solid(built, 3));
    EXPECT_FLOAT_EQ(std::get<scene::Plane>(built.scene.objects.at(4).shape).offset, 4);
}

// rotate x before y before z, the matrix's rows read as columns, translate before scale.
TEST(BuildShape, TransformationsApplyInTheirOrder) {
    const BuiltScene built = build(
        "sphere { <1, 0, 0>, 1 translate <1, 0, 0> scale 2 rotate <0, 90, 90> }"
        "sphere { <1, 2, 3>, 1 matrix <0, 1, 0, 0, 0, 1, 1, 0, 0, 10, 20, 30> }"
        "sphere { <1, 2, 3>, 1 transform { translate x rotate 90*z inverse } }");
    expect_near(std::get<scene::Sphere>(built.scene.objects.at(0).shape).center, {0, 0, -4});
    expect_near(std::get<scene::Sphere>(built.scene.objects.at(1).shape).center, {13, 21, 32});
    expect_near(std::get<scene::Sphere>(built.scene.objects.at(2).shape).center, {1, -1, 3});
}

TEST(BuildGroup, UnionsBecomeSeparateObjects) {
    const BuiltScene built = build("union { sphere { 0, 1 } union { sphere { x, 1 } box { 0, 1 } } no_shadow }");
    ASSERT_EQ(built.scene.objects.size(), 3U);
    for (const scene::Object& object : built.scene.objects) EXPECT_FALSE(object.casts_shadow);
}

TEST(BuildGroup, DifferenceIsAnIntersectionWithInverses) {
    const BuiltScene built = build("difference { box { -1, 1 } sphere { 0, 1 } sphere { x, 1 inverse } translate y }");
    const auto& group = std::get<scene::SolidGroup>(solid(built).shape);
    EXPECT_EQ(group.kind, scene::SolidGroup::Kind::common);
    ASSERT_EQ(group.children.size(), 3U);
    EXPECT_FALSE(group.children[0]->inverted);
    EXPECT_TRUE(group.children[1]->inverted);
    EXPECT_FALSE(group.children[2]->inverted);
    expect_near(solid(built).parent_from_shape.t, {0, 1, 0});
}

// clipped_by { bounded_by } takes the bounds; bounds alone never clip; the clip moves with what follows it only.
TEST(BuildGroup, ClipsMoveWithWhatFollowsThem) {
    const BuiltScene built = build(
        "sphere { 0, 1 translate 5*x clipped_by { box { 0, 1 } } translate y }"
        "sphere { 0, 1 bounded_by { box { 0, 1 } } clipped_by { bounded_by } }"
        "sphere { 0, 1 bounded_by { box { 0, 1 } } }"
        "quadric { <1, 0, 1>, <0, 0, 0>, <0, 0, 0>, -1 bounded_by { sphere { 0, 1 } } translate z }");
    ASSERT_EQ(solid(built, 0).clipped_by.size(), 1U);
    expect_near(solid(built, 0).clipped_by[0]->parent_from_shape.t, {0, 1, 0});
    expect_near(solid(built, 0).parent_from_shape.t, {5, 1, 0});
    EXPECT_EQ(solid(built, 1).clipped_by.size(), 1U);
    EXPECT_TRUE(std::holds_alternative<scene::Sphere>(built.scene.objects.at(2).shape));
    ASSERT_EQ(solid(built, 3).bounded_by.size(), 1U);
    expect_near(solid(built, 3).bounded_by[0]->parent_from_shape.t, {0, 0, 1});
}

TEST(BuildMesh, Mesh2KeepsIndicesNormalsAndTextures) {
    const BuiltScene built = build(
        "mesh2 { vertex_vectors { 4, <0,0,0>, <1,0,0>, <0,1,0>, <1,1,0> }"
        " normal_vectors { 4, <0,0,1>, <0,0,1>, <0,0,1>, <0,0,1> }"
        " texture_list { 2, texture { pigment { rgb x } } texture { pigment { rgb y } } }"
        " face_indices { 2, <0,1,2>, 0, <1,3,2>, 1 } translate z }");
    const auto& mesh = *std::get<Boxed<scene::Mesh>>(built.scene.objects.at(0).shape);
    ASSERT_EQ(mesh.triangles.size(), 2U);
    EXPECT_EQ(mesh.triangles[1].position[1], 3U);
    EXPECT_EQ(mesh.triangles[1].normal[1], 3U);
    expect_near(mesh.positions[3], {1, 1, 1});
    const auto color = [&](std::size_t i) {
        return built.scene.materials.at(mesh.triangles[i].material).patterned->color.value();
    };
    EXPECT_EQ(color(0).r, 1);
    EXPECT_EQ(color(1).g, 1);
}

// An index that points outside the list would read foreign memory.
TEST(BuildMesh, IndicesOutOfRangeAreErrors) {
    EXPECT_NE(error_of("mesh2 { vertex_vectors { 3, 0, x, y } face_indices { 1, <0, 1, 3> } }")
                  .find("an index out of range: 3"),
              std::string::npos);
    EXPECT_NE(error_of("mesh2 { vertex_vectors { 3, 0, x, y } face_indices { 1, <0, 1, -1> } }")
                  .find("an index out of range: -1"),
              std::string::npos);
    EXPECT_NE(error_of("mesh2 { vertex_vectors { 4, 0, x, y } face_indices { 1, <0, 1, 2> } }")
                  .find("a list of 4 entries that has 3"),
              std::string::npos);
}

// What POV-Ray leaves out with a warning must not end the program, nor stay as a shape without size.
TEST(BuildShape, DegenerateShapesAreLeftOut) {
    const BuiltScene built =
        build("sphere { 0, 0 } cylinder { x, x, 1 } plane { 0, 1 } torus { 1, 0 } union { sphere { 0, 0 } }");
    EXPECT_TRUE(built.scene.objects.empty());
    EXPECT_EQ(built.warnings.size(), 6U);
}

// Coefficients in another order than POV-Ray's.
TEST(BuildShape, PolynomialsCountDownX_Y_Z) {
    const BuiltScene built =
        build("poly { 2, <1, 2, 3, 4, 5, 6, 7, 8, 9, 10> } quadric { <1,2,3>, <4,5,6>, <7,8,9>, 10 }");
    const auto coefficient = [&](std::size_t object, int x, int y, int z) {
        for (const auto& term : std::get<scene::Polynomial>(solid(built, object).shape).terms)
            if (term.x == x && term.y == y && term.z == z) return term.coefficient;
        return 0.0;
    };
    EXPECT_EQ(coefficient(0, 2, 0, 0), 1);
    EXPECT_EQ(coefficient(0, 1, 1, 0), 2);
    EXPECT_EQ(coefficient(0, 1, 0, 0), 4);
    EXPECT_EQ(coefficient(0, 0, 1, 1), 6);
    EXPECT_EQ(coefficient(0, 0, 0, 0), 10);
    EXPECT_EQ(coefficient(1, 0, 2, 0), 2);
    EXPECT_EQ(coefficient(1, 1, 0, 1), 5);
    EXPECT_EQ(coefficient(1, 0, 0, 1), 9);
}

// Transforms named without braces, and `default` without its '#', as old scenes have them.
TEST(BuildSettings, OldFormsOfStatements) {
    const BuiltScene built = build(
        "#declare T = transform { translate 2*x } sphere { 0, 1 transform T }"
        "camera { location <0, 0, -5> transform T } default { finish { ambient 0.5 } } box { -1, 1 }");
    EXPECT_FLOAT_EQ(std::get<scene::Sphere>(built.scene.objects[0].shape).center.x, 2);
    EXPECT_EQ(built.scene.projection_camera->location.x, 2);
    const scene::Material& box = built.scene.materials.at(built.scene.objects[1].material);
    EXPECT_FLOAT_EQ(box.patterned->texture->layers[0].finish.ambient.x, 0.5F);
}

// Pictures of old scenes too dark or too bright.
TEST(BuildSettings, GammaDependsOnTheVersion) {
    EXPECT_FLOAT_EQ(build("#version 3.7; sphere { 0, 1 }").scene.settings.working_gamma, 1);
    EXPECT_FLOAT_EQ(build("#version 3.5; sphere { 0, 1 }").scene.settings.working_gamma, 0);
    EXPECT_FLOAT_EQ(
        build("#version 3.5; global_settings { assumed_gamma 1.8 } sphere { 0, 1 }").scene.settings.working_gamma,
        1.8F);
}

TEST(BuildSettings, SurroundingsArriveInTheScene) {
    const BuiltScene built = build(
        "global_settings { max_trace_level 12 adc_bailout 0.02 ambient_light rgb <1, 2, 3> radiosity { count 3 } }"
        "background { rgb <0.1, 0.2, 0.3> } fog { fog_type 2 distance 10 rgb 0.5 fog_alt 2 fog_offset 1 }"
        "sky_sphere { pigment { gradient y } rotate 90*x }");
    EXPECT_EQ(built.scene.settings.max_depth, 11);
    EXPECT_FLOAT_EQ(*built.scene.settings.min_weight, 0.02F);
    expect_near(built.scene.ambient, {1, 2, 3});
    expect_near(built.scene.sky, {0.1, 0.2, 0.3});
    ASSERT_EQ(built.scene.fogs.size(), 1U);
    EXPECT_TRUE(built.scene.fogs[0].ground);
    EXPECT_FLOAT_EQ(built.scene.fogs[0].altitude, 2);
    ASSERT_EQ(built.scene.sky_spheres.size(), 1U);
    EXPECT_TRUE(built.warnings.empty());
    ASSERT_TRUE(built.scene.radiosity);
    EXPECT_EQ(built.scene.radiosity->count, 3);
}

// A setting read into another one, a default that isn't povray's, ambient light kept or dropped in the wrong version,
// reuse limits that cross.
TEST(BuildSettings, RadiosityIsRead) {
    const BuiltScene built = build(R"(
        #version 3.7;
        global_settings { radiosity {
            count 12, 100 nearest_count 7, 3 recursion_limit 4 error_bound 0.3 low_error_factor 0.7 minimum_reuse 0.2
            pretrace_start 0.5 pretrace_end 0.25 gray_threshold 0.1 brightness 2 max_sample 9 adc_bailout 0.5 normal on
            media on always_sample on } }
        #default { radiosity { importance 0.5 } }
        sphere { 0, 1 no_radiosity } sphere { 0, 1 radiosity { importance 0.25 } })");
    ASSERT_TRUE(built.scene.radiosity);
    const scene::Radiosity& r = *built.scene.radiosity;
    EXPECT_EQ(r.count, 12);
    EXPECT_EQ(r.nearest_count, 7);
    EXPECT_EQ(r.recursion_limit, 4);
    EXPECT_FLOAT_EQ(r.error_bound, 0.3F);
    EXPECT_FLOAT_EQ(r.low_error_factor, 0.7F);
    EXPECT_FLOAT_EQ(r.minimum_reuse, 0.2F);
    EXPECT_FLOAT_EQ(r.maximum_reuse, 0.4F) << "gives way";
    EXPECT_FLOAT_EQ(r.pretrace_start, 0.5F);
    EXPECT_FLOAT_EQ(r.pretrace_end, 0.25F);
    EXPECT_FLOAT_EQ(r.gray_threshold, 0.1F);
    EXPECT_FLOAT_EQ(r.brightness, 2);
    EXPECT_FLOAT_EQ(r.max_sample, 9);
    EXPECT_FLOAT_EQ(r.adc_bailout, 0.5F);
    EXPECT_TRUE(r.normal && r.media && r.always_sample);
    EXPECT_FALSE(r.keeps_ambient);
    EXPECT_EQ(built.warnings.size(), 1U) << "minimum_reuse";
    EXPECT_FALSE(built.scene.objects[0].seen_by_radiosity);
    EXPECT_TRUE(built.scene.objects[1].seen_by_radiosity);
    EXPECT_TRUE(build("#version 3.6; global_settings { radiosity { } }").scene.radiosity->keeps_ambient);
}

// A scene refused, or its other objects lost, for one shape that can't be drawn.
TEST(BuildShape, IsosurfacesOfUnknownFunctionsAreLeftOut) {
    const BuiltScene built = build(R"(
        #declare Unknown = function { internal(26) }
        #declare Around = function(x, y, z) { Unknown(x, y, z, 1, 2, 3, 4, 5, 6, 7) + Unknown(z, y, x, 1, 2, 3, 4, 5, 6, 7) }
        isosurface { function { Around(x, y, z) - 1 } contained_by { box { -1, 1 } } max_gradient 2 translate x }
        sphere { 0, 1 })");
    EXPECT_EQ(built.scene.objects.size(), 1U);
    ASSERT_EQ(built.warnings.size(), 1U);
    EXPECT_NE(built.warnings[0].find("internal(26)"), std::string::npos) << built.warnings[0];
}

// Messages without the place, or without what would have been right.
TEST(BuildErrors, NameThePlaceAndWhatHasOneThere) {
    EXPECT_EQ(error_of("sphere { 0, 1\n  falloff 3 }"),
              "test.pov:2:3: error: 'falloff' has no place in sphere { }\n"
              "    2 |   falloff 3 }\n"
              "      |   ^\n"
              "hint: expected an object modifier");
    EXPECT_NE(error_of("camera { hollow }").find("'hollow' has no place in camera { }"), std::string::npos);
    EXPECT_NE(error_of("torus { 1 }").find("torus { } ends too early"), std::string::npos);
    EXPECT_NE(error_of("sphere { 0, 1 matrix <0,0,0, 0,0,0, 0,0,0, 1,1,1> }").find("a matrix without inverse"),
              std::string::npos);
}

}  // namespace
}  // namespace sundog::pov
