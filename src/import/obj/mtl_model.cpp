// SPDX-License-Identifier: Apache-2.0
#include "import/obj/mtl_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics.h"

namespace sundog::import {
namespace {

using scene::ReflectionModel;
using Kind = ReflectionModel::Kind;

constexpr float kMostExponent = 1e6F;
constexpr float kRightAngle_deg = 90;
/// Smoother facets would be mirrors.
constexpr float kLeastRoughness = 1e-3F;

struct Form {
    std::string_view name;
    Kind kind;
    int numbers;  ///< 1 or 2.
    bool metal;
    std::string_view text;
};

constexpr std::array<Form, 8> kForms{{
    {"oren-nayar", Kind::oren_nayar, 1, false, "bsdf oren-nayar degrees"},
    {"phong", Kind::phong, 1, false, "bsdf phong exponent"},
    {"blinn-phong", Kind::blinn_phong, 1, false, "bsdf blinn-phong exponent"},
    {"ward", Kind::ward, 2, false, "bsdf ward roughness_x roughness_y"},
    {"cook-torrance", Kind::cook_torrance, 1, true, "bsdf cook-torrance slope metal"},
    {"beckmann", Kind::beckmann, 2, true, "bsdf beckmann roughness_x roughness_y metal"},
    {"ggx", Kind::ggx, 2, true, "bsdf ggx roughness_x roughness_y metal"},
    {"glass", Kind::glass, 1, false, "bsdf glass roughness"},
}};

float number_in(LineCursor& cursor, const Form& form, float low, float high) {
    const char* const at = cursor.here();
    const float value = cursor.number(form.text);
    if (!(value >= low && value <= high)) {
        std::string range = high >= kMostExponent ? "0 or more" : "0 to " + std::to_string(std::lround(high));
        cursor.fail(at, "a number out of its range in '" + std::string(form.text) + "'", "expected " + range);
    }
    return value;
}

const Form& form_of(LineCursor& cursor) {
    const char* const at = cursor.here();
    const std::string_view name = cursor.token("bsdf and the name of a reflection model");
    const auto* const form = std::find_if(kForms.begin(), kForms.end(), [&](const Form& f) { return f.name == name; });
    if (form != kForms.end()) return *form;
    std::array<std::string_view, kForms.size()> names;
    std::transform(kForms.begin(), kForms.end(), names.begin(), [](const Form& f) { return f.name; });
    cursor.fail(at, "unknown reflection model '" + std::string(name) + "'", suggest(name, names));
}

const scene::Metal& metal_of(LineCursor& cursor, const Form& form) {
    const char* const at = cursor.here();
    const std::string_view name = cursor.token(form.text);
    std::vector<std::string_view> names;
    for (const scene::Metal& metal : scene::metals()) {
        if (metal.name == name) return metal;
        names.push_back(metal.name);
    }
    cursor.fail(at, "unknown metal '" + std::string(name) + "'", suggest(name, names));
}

}  // namespace

scene::ReflectionModel read_reflection_model(LineCursor& cursor) {
    const Form& form = form_of(cursor);
    ReflectionModel model;
    model.kind = form.kind;
    switch (form.kind) {
        case Kind::oren_nayar:
            model.first = number_in(cursor, form, 0, kRightAngle_deg) * std::numbers::pi_v<float> / 180;
            break;
        case Kind::phong:
        case Kind::blinn_phong:
            model.first = number_in(cursor, form, 0, kMostExponent);
            break;
        default:
            model.first = std::max(number_in(cursor, form, 0, 1), kLeastRoughness);
            break;
    }
    model.second = form.numbers == 2 ? std::max(number_in(cursor, form, 0, 1), kLeastRoughness) : model.first;
    if (form.metal) {
        const scene::Metal& metal = metal_of(cursor, form);
        model.n = metal.n;
        model.k = metal.k;
    }
    return model;
}

}  // namespace sundog::import
