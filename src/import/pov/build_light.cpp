// SPDX-License-Identifier: Apache-2.0
// Lights (POV-Ray reference, section 3.4.4.1 "Light Source").
#include <algorithm>
#include <array>
#include <cmath>

#include "import/pov/build_photons.h"
#include "import/pov/build_shape.h"
#include "import/pov/build_transform.h"

namespace sundog::pov {
namespace {

constexpr std::array kValid{Keyword::spotlight,
                            Keyword::cylinder,
                            Keyword::parallel,
                            Keyword::shadowless,
                            Keyword::point_at,
                            Keyword::radius,
                            Keyword::falloff,
                            Keyword::tightness,
                            Keyword::area_light,
                            Keyword::adaptive,
                            Keyword::jitter,
                            Keyword::circular,
                            Keyword::orient,
                            Keyword::fade_power,
                            Keyword::fade_distance,
                            Keyword::looks_like,
                            Keyword::translate,
                            Keyword::area_illumination,
                            Keyword::rotate,
                            Keyword::scale,
                            Keyword::media_attenuation,
                            Keyword::media_interaction,
                            Keyword::projected_through};

class LightReader {
public:
    LightReader(ObjectReader& objects, ItemReader& items)
        : objects_(objects), context_(objects.context()), items_(items) {}

    NodeShape read() {
        scene::Light& light = result_.light;
        const SourceLocation where = context_.location(items_.taken_where());
        if (const auto base = items_.take_block(Keyword::light_source)) {
            const Node node = objects_.read(*base);
            result_ = *std::get<std::shared_ptr<const NodeLight>>(node.shape);
            if (result_.looks_like) looks_like_ = *result_.looks_like;
            radius_ = light.radius, falloff_ = light.falloff;
        } else {
            light.place = to_float(items_.vector("the place of the light"));
            const scene::PigmentColor color = items_.color("the color of the light");
            light.color = {color.r, color.g, color.b};
        }
        light.where = where;
        while (!items_.at_end())
            if (!read_item() && !transform()) items_.unexpected(kValid);
        finish();
        return std::make_shared<const NodeLight>(std::move(result_));
    }

private:
    float number(std::string_view what) { return static_cast<float>(items_.number(what)); }

    /// A light's transformations come in between what they move.
    bool transform() {
        Affine3d moved;
        if (!read_transform(items_, moved)) return false;
        scene::Light& light = result_.light;
        light.place = to_float(transform_point(moved, to_double(light.place)));
        light.point_at = to_float(transform_point(moved, to_double(light.point_at)));
        if (light.area) {
            light.area->axis1 = to_float(transform_vector(moved, to_double(light.area->axis1)));
            light.area->axis2 = to_float(transform_vector(moved, to_double(light.area->axis2)));
        }
        if (looks_like_) place_node(*looks_like_, moved);
        result_.parent_from_projector = moved * result_.parent_from_projector;
        return true;
    }

    bool read_item() {
        scene::Light& light = result_.light;
        if (const auto block = items_.take_block(Keyword::looks_like)) {
            ItemReader inside(context_, *block);
            std::vector<NodePointer> children = read_children(objects_, inside);
            if (children.size() == 1) {
                Node node = *children.front();
                // It is described around the origin and stands where the light is.
                place_node(node, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, to_double(result_.light.place)});
                looks_like_ = std::move(node);
            }
            return true;
        }
        if (const auto block = items_.take_block(Keyword::projected_through)) {
            ItemReader inside(context_, *block);
            result_.projected_through = read_children(objects_, inside);
            result_.parent_from_projector = {};
            // Of its modifiers only where it is counts.
            while (!inside.at_end())
                if (!read_transform(inside, result_.parent_from_projector)) inside.skip();
            return true;
        }
        if (const auto photons = items_.take_block(Keyword::photons)) {
            light.photons = read_light_photons(context_, *photons, light.photons);
            return true;
        }
        const std::optional<Keyword> keyword = items_.peek_keyword();
        if (!keyword || !is_own(*keyword)) return false;
        items_.skip();
        switch (*keyword) {
            case Keyword::spotlight:
                light.kind = scene::Light::Kind::spotlight;
                break;
            case Keyword::cylinder:
                light.kind = scene::Light::Kind::cylinder;
                break;
            case Keyword::parallel:
                parallel_ = true;
                break;
            case Keyword::shadowless:
                light.shadows = light.highlights = false;
                break;
            case Keyword::point_at:
                light.point_at = to_float(items_.vector("the place that the light points at"));
                break;
            case Keyword::radius:
                radius_ = number("a radius");
                break;
            case Keyword::falloff:
                falloff_ = number("a falloff");
                break;
            case Keyword::tightness:
                light.tightness = number("a tightness");
                break;
            case Keyword::fade_distance:
                light.fade_distance = number("a distance");
                break;
            case Keyword::fade_power:
                light.fade_power = number("a power");
                break;
            case Keyword::media_attenuation:
                light.media_attenuation = items_.flag();
                break;
            case Keyword::media_interaction:
                light.media_interaction = items_.flag();
                break;
            case Keyword::area_light:
                read_area();
                break;
            case Keyword::area_illumination:
                area_.illuminates = items_.flag();
                if (light.area) light.area->illuminates = area_.illuminates;
                break;
            default:
                read_area_item(*keyword);
        }
        return true;
    }

    static bool is_own(Keyword keyword) {
        return std::find(kValid.begin(), kValid.end(), keyword) != kValid.end() && keyword != Keyword::translate &&
               keyword != Keyword::rotate && keyword != Keyword::scale;
    }

    void read_area() {
        constexpr int kMost = 65536;
        scene::LightArea& area = area_;
        area.axis1 = to_float(items_.vector("the first axis of the area"));
        area.axis2 = to_float(items_.vector("the second axis of the area"));
        area.size1 = items_.integer("the number of lights along the first axis", 1, kMost);
        area.size2 = items_.integer("the number of lights along the second axis", 1, kMost);
        result_.light.area = area;
    }

    void read_area_item(Keyword keyword) {
        scene::LightArea& area = area_;
        switch (keyword) {
            case Keyword::adaptive:
                area.adaptive = items_.integer("a depth", 0, 30);
                break;
            case Keyword::jitter:
                area.jitter = true;
                break;
            case Keyword::circular:
                area.circular = true;
                break;
            case Keyword::orient:
                area.orient = true;
                break;
            default:
                return;
        }
        if (result_.light.area) {
            area.axis1 = result_.light.area->axis1, area.axis2 = result_.light.area->axis2;
            result_.light.area = area;
        }
    }

    /// What turns to each point it lights is round, and as high as it is wide (reference 3.4.4.1.5).
    void settle_orient(scene::LightArea& area) {
        if (!area.circular) items_.warn("orient is for circular area lights: this one is circular now");
        area.circular = true;
        const float first = length(area.axis1), second = length(area.axis2);
        if (std::abs(first - second) > 1e-6F * first)
            items_.warn("an area light with orient is as long along its second axis as along its first");
        // Of the second axis the length alone is asked for.
        area.axis2 = second > 0 ? area.axis2 * (first / second) : area.axis1;
    }

    static void place_node(Node& node, const Affine3d& placed) {
        node.parent_from_shape = placed * node.parent_from_shape;
        node.parent_from_interior = placed * node.parent_from_interior;
        node.texture.parent_from_texture = placed * node.texture.parent_from_texture;
        node.interior_texture.parent_from_texture = placed * node.interior_texture.parent_from_texture;
        for (std::vector<Node::Clip>* clips : {&node.clipped_by, &node.bounded_by})
            for (Node::Clip& clip : *clips) clip.parent_from_clip = placed * clip.parent_from_clip;
    }

    void finish() {
        scene::Light& light = result_.light;
        const bool narrow = light.kind == scene::Light::Kind::cylinder;
        light.radius = radius_.value_or(narrow ? 0.75F : 30.0F);
        light.falloff = falloff_.value_or(narrow ? 1.0F : 45.0F);
        if (parallel_ && light.kind == scene::Light::Kind::lamp) {
            light.kind = scene::Light::Kind::sun;
            if (light.place == light.point_at) light.place = light.point_at + Vec3{0, 1, 0};
        }
        if (light.area && light.area->orient) settle_orient(*light.area);
        if (!looks_like_) return;
        looks_like_->no_shadow = true;
        result_.looks_like = std::make_shared<const Node>(std::move(*looks_like_));
    }

    ObjectReader& objects_;
    BuildContext& context_;
    ItemReader& items_;
    NodeLight result_;
    std::optional<Node> looks_like_;
    scene::LightArea area_;  // Its items may come before area_light itself.
    bool parallel_ = false;  // Of this block; a base that was parallel is a sun already.
    std::optional<float> radius_, falloff_;
};

}  // namespace

NodeShape read_light_source(ObjectReader& objects, ItemReader& items) { return LightReader(objects, items).read(); }

}  // namespace sundog::pov
