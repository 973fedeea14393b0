// SPDX-License-Identifier: Apache-2.0
#include "import/pov/build_camera.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "import/pov/build_host_camera.h"
#include "import/pov/build_normal.h"
#include "import/pov/build_pigment.h"
#include "import/pov/build_transform.h"

namespace sundog::pov {
namespace {

using Kind = scene::ProjectionCamera::Kind;

constexpr std::array kValid{
    Keyword::perspective,  Keyword::orthographic, Keyword::fisheye,     Keyword::ultra_wide_angle,
    Keyword::omnimax,      Keyword::panoramic,    Keyword::cylinder,    Keyword::spherical,
    Keyword::location,     Keyword::look_at,      Keyword::right,       Keyword::up,
    Keyword::direction,    Keyword::sky,          Keyword::angle,       Keyword::aperture,
    Keyword::blur_samples, Keyword::focal_point,  Keyword::confidence,  Keyword::variance,
    Keyword::bokeh,        Keyword::normal,       Keyword::mesh_camera, Keyword::user_defined,
    Keyword::translate,    Keyword::rotate,       Keyword::scale,       Keyword::matrix,
    Keyword::transform};

std::optional<Kind> kind_of(Keyword keyword) {
    switch (keyword) {
        case Keyword::perspective:
            return Kind::perspective;
        case Keyword::orthographic:
            return Kind::orthographic;
        case Keyword::fisheye:
            return Kind::fisheye;
        case Keyword::ultra_wide_angle:
            return Kind::ultra_wide_angle;
        case Keyword::omnimax:
            return Kind::omnimax;
        case Keyword::panoramic:
            return Kind::panoramic;
        case Keyword::cylinder:
            return Kind::cylinder;
        case Keyword::spherical:
            return Kind::spherical;
        default:
            return std::nullopt;
    }
}

class CameraReader {
public:
    CameraReader(ObjectReader& objects, const Block& block, CameraParts start)
        : objects_(objects), context_(objects.context()), items_(context_, block), parts_(std::move(start)) {
        parts_.camera.where = context_.location(block.where);
    }

    CameraParts read() {
        while (!items_.at_end())
            if (!read_transform(items_, moved_) && !read_block() && !read_kind() && !read_function() &&
                !read_vector() && !read_blur())
                items_.unexpected(kValid);
        apply_angle();
        apply_look_at();
        move();
        finish_mesh();
        return std::move(parts_);
    }

private:
    bool read_block() {
        if (const auto base = items_.take_block(Keyword::camera)) {
            parts_ = read_camera(objects_, *base, std::move(parts_));
            sized_ = true;  // its window is worked out already
        } else if (const auto normal = items_.take_block(Keyword::normal)) {
            parts_.camera.normal = read_normal(context_, *normal, parts_.camera.normal, nullptr);
            if (parts_.camera.normal && parts_.camera.normal->is_flat()) parts_.camera.normal = nullptr;
        } else if (const auto mesh = items_.take_block(Keyword::mesh_camera)) {
            parts_.camera.mesh = std::make_shared<const scene::MeshCamera>(read_mesh_camera(objects_, *mesh));
        } else if (const auto bokeh = items_.take_block(Keyword::bokeh)) {
            ItemReader inner(context_, *bokeh);
            const auto pigment = inner.take_block(Keyword::pigment);
            if (!pigment) inner.unexpected("pigment { }");
            parts_.camera.blur.bokeh =
                std::make_shared<const scene::Pigment>(read_pigment(context_, *pigment, scene::Pigment{}));
        } else {
            return false;
        }
        return true;
    }

    /// user_defined, and functions of its `location { }` and `direction { }`.
    bool read_function() {
        if (items_.take(Keyword::user_defined)) {
            change_function([](scene::FunctionCamera&) {});
        } else if (const auto location = items_.take_block(Keyword::location)) {
            const auto functions = read_camera_functions(context_, *location);
            change_function([&](scene::FunctionCamera& camera) { camera.location = functions; });
        } else if (const auto direction = items_.take_block(Keyword::direction)) {
            const auto functions = read_camera_functions(context_, *direction);
            change_function([&](scene::FunctionCamera& camera) { camera.direction = functions; });
        } else {
            return false;
        }
        return true;
    }

    template <class Change>
    void change_function(const Change& change) {
        scene::FunctionCamera camera = parts_.camera.function ? *parts_.camera.function : scene::FunctionCamera{};
        change(camera);
        parts_.camera.function = std::make_shared<const scene::FunctionCamera>(std::move(camera));
    }

    bool read_kind() {
        const std::optional<Keyword> keyword = items_.peek_keyword();
        const std::optional<Kind> kind = keyword ? kind_of(*keyword) : std::nullopt;
        if (!kind) return false;
        items_.skip();
        parts_.camera.kind = *kind;
        if (*kind == Kind::cylinder) parts_.camera.cylinder_type = items_.integer("a type of cylinder", 1, 4);
        return true;
    }

    bool read_vector() {
        scene::ProjectionCamera& camera = parts_.camera;
        if (items_.take(Keyword::location)) {
            camera.location = items_.vector("the place of the camera"), location_given_ = camera.location;
        } else if (items_.take(Keyword::look_at)) {
            look_at_ = items_.vector("the place that the camera looks at");
        } else if (items_.take(Keyword::right)) {
            camera.right = items_.vector("a vector to the right"), sized_ = true;
        } else if (items_.take(Keyword::up)) {
            camera.up = items_.vector("a vector upwards"), sized_ = true;
        } else if (items_.take(Keyword::direction)) {
            camera.direction = items_.vector("a direction"), direction_given_ = camera.direction;
        } else if (items_.take(Keyword::sky)) {
            camera.sky = items_.vector("a direction upwards");
        } else if (items_.take(Keyword::angle)) {
            read_angle();
        } else {
            return false;
        }
        return true;
    }

    void read_angle() {
        angle_given_ = true;
        const std::optional<double> angle = items_.maybe_number();
        if (!angle) return;
        if (parts_.camera.kind == Kind::perspective && !(*angle > 0 && *angle < 180))
            items_.fail("an angle out of range", "a perspective camera's angle lies between 0 and 180 degrees");
        if (*angle <= 0) items_.fail("an angle out of range", "expected a positive number of degrees");
        angle_deg_ = *angle;
        vertical_angle_deg_ = items_.maybe_number();
    }

    bool read_blur() {
        scene::FocalBlur& blur = parts_.camera.blur;
        if (items_.take(Keyword::aperture)) {
            blur.aperture = std::max(items_.number("an aperture"), 0.0);
        } else if (items_.take(Keyword::blur_samples)) {
            constexpr int kMostSamples = 1'000'000;
            const int first = items_.integer("a number of samples", 0, kMostSamples);
            const bool both = items_.number_follows();
            blur.most_samples = both ? items_.integer("a number of samples", 0, kMostSamples) : first;
            blur.least_samples = both ? std::max(first, 1) : blur.most_samples < 7 ? 4 : 7;
            blur.least_samples = std::min(blur.least_samples, blur.most_samples);
        } else if (items_.take(Keyword::focal_point)) {
            blur.focal_point = items_.vector("a point in focus");
        } else if (items_.take(Keyword::confidence)) {
            const double confidence = items_.number("a number from 0 to less than 1");
            if (confidence > 0 && confidence < 1) blur.confidence = confidence;
        } else if (items_.take(Keyword::variance)) {
            const double variance = items_.number("a number from 0 to 1");
            if (variance >= 0 && variance < 1) blur.variance = variance;
        } else {
            return false;
        }
        return true;
    }

    /// angle makes the direction as long as it takes to see half of it left and right.
    void apply_angle() {
        scene::ProjectionCamera& camera = parts_.camera;
        const double by_default = camera.kind == Kind::spherical ? 360 : 90;
        if (angle_deg_ || camera.angle_deg == 0) camera.angle_deg = angle_deg_.value_or(by_default);
        camera.vertical_angle_deg = vertical_angle_deg_.value_or(camera.angle_deg / 2);
        const bool by_direction = camera.kind == Kind::perspective || camera.kind == Kind::orthographic;
        if (!angle_deg_ || !by_direction || !(*angle_deg_ < 180)) return;
        const double half = *angle_deg_ * (std::numbers::pi / 360);
        const double len = length(camera.direction);
        if (len > 0) camera.direction = camera.direction * (0.5 * length(camera.right) / std::tan(half) / len);
    }

    void apply_look_at() {
        scene::ProjectionCamera& camera = parts_.camera;
        const Vec3d to_target = look_at_.value_or(Vec3d{0, 0, 1}) - camera.location;
        if (camera.kind == Kind::orthographic && (angle_given_ || !sized_)) see_as_perspective(to_target);
        if (!look_at_ || length(to_target) == 0) return;
        const double direction_length = length(camera.direction);
        const double up_length = length(camera.up);
        // Vectors in one plane (`up z` beside a direction along z) count as right-handed.
        const bool left_handed = dot(cross(camera.up, camera.direction), camera.right) > 0;
        const double right_length = length(camera.right) * (left_handed ? 1 : -1);
        const Vec3d forward = normalize(to_target);
        Vec3d right = cross(camera.sky, forward);
        // Looking along the sky vector: any right will do; the camera's own stays as far as it can.
        if (length(right) < 1e-9 * length(camera.sky)) right = cross(cross(forward, camera.right), forward);
        if (length(right) == 0) right = cross(camera.up, forward);
        right = normalize(right);
        camera.direction = forward * direction_length;
        camera.right = right * right_length;
        camera.up = cross(forward, right) * up_length;
    }

    /// The window of an orthographic camera that sees what a perspective one sees of the plane through its target.
    void see_as_perspective(Vec3d to_target) {
        scene::ProjectionCamera& camera = parts_.camera;
        const double factor = length(to_target) / length(camera.direction);
        if (!(factor > 0) || !std::isfinite(factor)) return;
        camera.right = camera.right * factor;
        camera.up = camera.up * factor;
    }

    /// What location and direction say to a mesh's camera, once all is read.
    void finish_mesh() {
        scene::ProjectionCamera& camera = parts_.camera;
        if (!camera.mesh || !(location_given_ || direction_given_)) return;
        scene::MeshCamera mesh = *camera.mesh;
        if (location_given_) mesh.offset = location_given_->z;
        if (direction_given_) mesh.reversed = direction_given_->z < -1e-10;
        camera.mesh = std::make_shared<const scene::MeshCamera>(std::move(mesh));
    }

    void move() {
        scene::ProjectionCamera& camera = parts_.camera;
        if (camera.function)
            change_function([&](scene::FunctionCamera& f) { f.world_from_camera = moved_ * f.world_from_camera; });
        camera.blur.focal_point = transform_point(moved_, camera.blur.focal_point);
        camera.location = transform_point(moved_, camera.location);
        camera.direction = transform_vector(moved_, camera.direction);
        camera.right = transform_vector(moved_, camera.right);
        camera.up = transform_vector(moved_, camera.up);
        camera.sky = transform_vector(moved_, camera.sky);
    }

    ObjectReader& objects_;
    BuildContext& context_;
    ItemReader items_;
    CameraParts parts_;
    Affine3d moved_;
    std::optional<Vec3d> look_at_, location_given_, direction_given_;
    std::optional<double> angle_deg_, vertical_angle_deg_;
    bool angle_given_ = false, sized_ = false;
};

}  // namespace

CameraParts read_camera(ObjectReader& objects, const Block& block, CameraParts start) {
    return CameraReader(objects, block, std::move(start)).read();
}

}  // namespace sundog::pov
