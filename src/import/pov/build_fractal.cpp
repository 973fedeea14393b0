// SPDX-License-Identifier: Apache-2.0
// Julia fractals, eggs, lemons and parametric surfaces (POV-Ray reference, sections 3.4.5.1.7 to 3.4.5.1.10; lemons
// are of 3.8).
#include <algorithm>
#include <array>
#include <cmath>

#include "import/pov/build_function.h"
#include "import/pov/build_shape.h"

namespace sundog::pov {
namespace {

using JuliaFunction = scene::JuliaFractal::Function;

std::optional<JuliaFunction> function_of(Keyword keyword) {
    switch (keyword) {
        case Keyword::sqr:
            return JuliaFunction::sqr;
        case Keyword::cube:
            return JuliaFunction::cube;
        case Keyword::exp:
            return JuliaFunction::exp;
        case Keyword::reciprocal:
            return JuliaFunction::reciprocal;
        case Keyword::sin:
            return JuliaFunction::sin;
        case Keyword::asin:
            return JuliaFunction::asin;
        case Keyword::sinh:
            return JuliaFunction::sinh;
        case Keyword::asinh:
            return JuliaFunction::asinh;
        case Keyword::cos:
            return JuliaFunction::cos;
        case Keyword::acos:
            return JuliaFunction::acos;
        case Keyword::cosh:
            return JuliaFunction::cosh;
        case Keyword::acosh:
            return JuliaFunction::acosh;
        case Keyword::tan:
            return JuliaFunction::tan;
        case Keyword::atan:
            return JuliaFunction::atan;
        case Keyword::tanh:
            return JuliaFunction::tanh;
        case Keyword::atanh:
            return JuliaFunction::atanh;
        case Keyword::ln:
            return JuliaFunction::ln;
        case Keyword::pwr:
            return JuliaFunction::pwr;
        default:
            return std::nullopt;
    }
}

std::array<double, 4> four_numbers(ItemReader& items, std::string_view what) {
    const Value& value = items.value(what);
    std::array<double, 4> out{};
    for (std::size_t i = 0; i < 4; ++i) out[i] = value.count == 1 ? value.v[0] : i < value.count ? value.v[i] : 0;
    return out;
}

bool read_julia_item(ItemReader& items, scene::JuliaFractal& fractal) {
    if (items.take(Keyword::quaternion)) {
        fractal.hypercomplex = false;
    } else if (items.take(Keyword::hypercomplex)) {
        fractal.hypercomplex = true;
    } else if (items.take(Keyword::max_iteration)) {
        constexpr int kMost = 10'000;
        fractal.max_iteration = items.integer("a number of iterations", 1, kMost);
    } else if (items.take(Keyword::precision)) {
        fractal.precision = std::max(items.number("a precision"), 1.0);
    } else if (items.take(Keyword::slice)) {
        fractal.slice = four_numbers(items, "a vector of four components");
        fractal.distance = items.number("a distance from the origin");
        if (fractal.slice[3] == 0)
            items.fail("a slice without a fourth component", "the fourth component of a slice's normal must not be 0");
    } else if (const auto keyword = items.peek_keyword(); keyword && function_of(*keyword)) {
        items.skip();
        fractal.function = *function_of(*keyword);
        if (*keyword == Keyword::pwr)
            for (double& part : fractal.exponent) part = items.number("a part of pwr's exponent");
    } else {
        return false;
    }
    return true;
}

}  // namespace

NodeShape read_julia_fractal(ItemReader& items) {
    scene::JuliaFractal fractal;
    fractal.parameter = four_numbers(items, "a vector of four components");
    while (read_julia_item(items, fractal)) {
    }
    if (!fractal.hypercomplex && fractal.function != JuliaFunction::sqr && fractal.function != JuliaFunction::cube)
        items.fail("a function that quaternions don't have", "quaternions have sqr and cube; write hypercomplex");
    return fractal;
}

NodeShape read_ovus(ItemReader& items) {
    scene::Ovus ovus;
    ovus.bottom_radius = items.number("the bottom radius of the ovus");
    ovus.top_radius = items.number("the top radius of the ovus");
    if (!(ovus.bottom_radius > 0 && ovus.top_radius > 0))
        items.fail("a radius that is not positive", "expected two positive numbers");
    return ovus;
}

NodeShape read_lemon(ItemReader& items) {
    scene::Lemon lemon;
    lemon.base = items.vector("the middle of the lemon's base");
    lemon.base_radius = items.number("the radius of the lemon's base");
    lemon.apex = items.vector("the middle of the lemon's apex");
    lemon.apex_radius = items.number("the radius of the lemon's apex");
    lemon.inner_radius = items.number("the radius of the lemon's arc");
    if (!(length(lemon.apex - lemon.base) > 0)) items.fail("a lemon of no length", "its two ends must be apart");
    return lemon;
}

NodeShape read_parametric(ItemReader& items) {
    scene::Parametric parametric;
    std::array<std::shared_ptr<const FunctionExpression>, 3> functions;
    for (auto& function : functions) {
        function = items.take_function();
        if (!function) items.unexpected("three functions of u and v");
    }
    parametric.first = items.vector2("the least u and v");
    parametric.last = items.vector2("the greatest u and v");
    if (!(parametric.first[0] < parametric.last[0] && parametric.first[1] < parametric.last[1]))
        items.fail("an empty range of u or v", "the second vector must be greater in both components");
    parametric.function = read_functions(items.context(), functions, 3);
    return parametric;
}

bool read_parametric_item(ItemReader& items, scene::Parametric& parametric) {
    if (const auto block = items.take_block(Keyword::contained_by)) {
        scene::Isosurface container;
        read_container(items, *block, container);
        parametric.in_sphere = container.in_sphere;
        parametric.center = container.center, parametric.radius = container.radius;
        parametric.lower = container.lower, parametric.upper = container.upper;
    } else if (items.take(Keyword::max_gradient) || items.take(Keyword::accuracy)) {
        // How to search: the surface is found without such hints, all of it.
        items.number("a number");
    } else if (items.take(Keyword::precompute)) {
        items.number("a depth");
        while (items.value_follows()) items.skip();  // x, y, z
    } else {
        return false;
    }
    return true;
}

}  // namespace sundog::pov
