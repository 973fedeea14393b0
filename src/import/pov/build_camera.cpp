// SPDX-License-Identifier: Apache-2.0
#include "import/pov/build_camera.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "import/pov/build_transform.h"

namespace sundog::pov {
namespace {

using Kind = scene::ProjectionCamera::Kind;

constexpr std::array kValid{
    Keyword::perspective,  Keyword::orthographic, Keyword::fisheye,    Keyword::ultra_wide_angle,
    Keyword::omnimax,      Keyword::panoramic,    Keyword::cylinder,   Keyword::spherical,
    Keyword::location,     Keyword::look_at,      Keyword::right,      Keyword::up,
    Keyword::direction,    Keyword::sky,          Keyword::angle,      Keyword::aperture,
    Keyword::blur_samples, Keyword::focal_point,  Keyword::confidence, Keyword::variance,
    Keyword::normal,       Keyword::translate,    Keyword::rotate,     Keyword::scale,
    Keyword::matrix,       Keyword::transform};

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
    CameraReader(BuildContext& context, const Block& block, CameraParts start)
        : context_(context), items_(context, block), parts_(std::move(start)) {
        parts_.camera.where = context.location(block.where);
    }

    CameraParts read() {
        while (!items_.at_end())
            if (!read_transform(items_, moved_) && !read_block() && !read_kind() && !read_vector() && !read_blur())
                items_.unexpected(kValid);
        apply_angle();
        apply_look_at();
        move();
        return std::move(parts_);
    }

private:
    bool read_block() {
        if (const auto base = items_.take_block(Keyword::camera)) {
            parts_ = read_camera(context_, *base, std::move(parts_));
        } else if (items_.take_block(Keyword::normal)) {
            context_.warn_once("camera normal", items_.taken_where(), "a camera's normal { } isn't drawn yet");
        } else if (items_.take_block(Keyword::mesh_camera) || items_.take_block(Keyword::user_defined)) {
            context_.warn_once("mesh_camera", items_.taken_where(),
                               "mesh_camera and user_defined cameras aren't drawn yet",
                               "a perspective camera stands in for it");
        } else if (!items_.take_block(Keyword::bokeh)) {
            return false;
        }
        return true;
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
            camera.location = items_.vector("the place of the camera");
        } else if (items_.take(Keyword::look_at)) {
            look_at_ = items_.vector("the place that the camera looks at");
        } else if (items_.take(Keyword::right)) {
            camera.right = items_.vector("a vector to the right"), sized_ = true;
        } else if (items_.take(Keyword::up)) {
            camera.up = items_.vector("a vector upwards"), sized_ = true;
        } else if (items_.take(Keyword::direction)) {
            camera.direction = items_.vector("a direction");
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
        if (items_.take(Keyword::aperture)) {
            if (items_.number("an aperture") > 0)
                context_.warn_once("focal blur", items_.taken_where(), "focal blur isn't drawn yet",
                                   "everything is in focus");
        } else if (items_.take(Keyword::blur_samples)) {
            items_.number("a number of samples");
            items_.maybe_number();
        } else if (items_.take(Keyword::focal_point)) {
            items_.vector("a point in focus");
        } else if (items_.take(Keyword::confidence) || items_.take(Keyword::variance)) {
            items_.number("a number");
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

    void move() {
        scene::ProjectionCamera& camera = parts_.camera;
        camera.location = transform_point(moved_, camera.location);
        camera.direction = transform_vector(moved_, camera.direction);
        camera.right = transform_vector(moved_, camera.right);
        camera.up = transform_vector(moved_, camera.up);
        camera.sky = transform_vector(moved_, camera.sky);
    }

    BuildContext& context_;
    ItemReader items_;
    CameraParts parts_;
    Affine3d moved_;
    std::optional<Vec3d> look_at_;
    std::optional<double> angle_deg_, vertical_angle_deg_;
    bool angle_given_ = false, sized_ = false;
};

}  // namespace

CameraParts read_camera(BuildContext& context, const Block& block, CameraParts start) {
    return CameraReader(context, block, std::move(start)).read();
}

}  // namespace sundog::pov
