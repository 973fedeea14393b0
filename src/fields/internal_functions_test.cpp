// SPDX-License-Identifier: Apache-2.0
#include "fields/internal_functions.h"

#include <gtest/gtest.h>

#include <vector>

#include "fields/function_evaluator.h"

namespace sundog::fields {
namespace {

// A sign, a parameter or a term of a formula that isn't POV-Ray's: the values are what povray 3.7 prints.
TEST(PovInternalFunctions, ValuesAreThoseOfPovRay) {
    struct Known {
        std::uint32_t number;
        std::vector<double> arguments;
        double value;
    };
    const std::vector<Known> known{
        {4, {0.3, -0.4, 0.5, 1, 0.8}, -0.8356},
        {5, {0.3, -0.4, 0.5, 1, 3}, -0.658},
        {7, {0.3, -0.4, 0.5, 0.8, 2, 1.3, 0.5}, -0.325519166},
        {25, {0.3, -0.4, 0.5, 3, 2.5, 0.2, 0.6, 1.5, 1, 30}, 0.071678642},
        {8, {0.3, -0.4, 0.5, 0.01, 0.5}, -0.150052279141},
        {11, {0.3, -0.4, 0.5, 2}, 0.845},
        {12, {0.3, -0.4, 0.5, 2}, 0.818},
        {13, {0.3, -0.4, 0.5, 2}, 0.035},
        {14, {0.3, -0.4, 0.5, 2}, -0.1952},
        {16, {0.3, -0.4, 0.5, 1, 0.9, 0.3, 0.2, 0.1, 0.8}, -0.15843364},
        {17, {0.3, -0.4, 0.5, 0.5, 0.6, 0.7}, 0.450111097397},
        {20, {0.3, -0.4, 0.5, 0.7, 0.2, 0.3}, 0.32585},
        {22, {0.3, -0.4, 0.5, 2}, -0.80947},
        {23, {0.3, -0.4, 0.5, 2}, 0.180092},
        {30, {0.3, -0.4, 0.5, 0.001}, 3.5463677},
        {31, {0.3, -0.4, 0.5, 1, 0.6, 0.4}, -0.2704},
        {33, {0.3, -0.4, 0.5, 2, 0.5, 0.25}, -0.8218},
        {35, {0.3, -0.4, 0.5, 0.5}, -1.6015},
        {36, {0.3, -0.4, 0.5, 2}, -1.0386},
        {37, {0.3, -0.4, 0.5, 0.5, -0.3, -0.7, 0.2}, 0.559815},
        {38, {0.3, -0.4, 0.5, 2}, -0.6562},
        {41, {0.3, -0.4, 0.5, 2}, -0.1712},
        {42, {0.3, -0.4, 0.5, 2}, -2.522},
        {43, {0.3, -0.4, 0.5, 2}, 0.035},
        {44, {0.3, -0.4, 0.5, 1, 0.7, 0.3, 0.2}, -0.85678},
        {45, {0.3, -0.4, 0.5, 2}, -1.48},
        {46, {0.3, -0.4, 0.5, 1, 0.6, 0.4}, -0.3477},
        {47, {0.3, -0.4, 0.5}, 2.17206054347},
        {48, {0.3, -0.4, 0.5, 2}, -0.8076},
        {49, {0.3, -0.4, 0.5, 2}, 0.7822},
        {51, {0.3, -0.4, 0.5, 0.2, 0.3, 0.4, 0.5, 0.6}, 0.455735189485},
        {54, {0.3, -0.4, 0.5, 2}, -0.9412},
        {55, {0.3, -0.4, 0.5, 2}, -0.6912},
        {56, {0.3, -0.4, 0.5, 2, 0.7, 0.3}, -0.0818},
        {57, {0.3, -0.4, 0.5}, 0.707106781187},
        {60, {0.3, -0.4, 0.5, 0.1, 0.2, 0.35, 0.45}, 0.191546594742},
        {61, {0.3, -0.4, 0.5, 0.25}, 0.457106781187},
        {63, {0.3, -0.4, 0.5, 0.5, 2, 3, 1.5}, -0.417529045975},
        {65, {0.3, -0.4, 0.5, 2}, -0.0338},
        {66, {0.3, -0.4, 0.5, 1, 0.7, 0.3, 0.2}, 0.0036},
        {68, {0.3, -0.4, 0.5, 0.5, 0.7}, 0.405067003168},
        {69, {0.3, -0.4, 0.5}, 0.540419500271},
        {70, {0.3, -0.4, 0.5, 0.6, 0.2}, 0.200357056412},
        {71, {0.3, -0.4, 0.5, 1, 0.6, 0.4}, -0.0004},
        {72, {0.3, -0.4, 0.5, 0.1}, -0.83321},
        {73, {0.3, -0.4, 0.5, 2}, -0.38},
        {74, {0.3, -0.4, 0.5, 2, 0.3}, 1.112},
    };
    for (const Known& k : known) {
        const InternalFunction* function = internal_function(k.number);
        ASSERT_NE(function, nullptr) << k.number;
        ASSERT_EQ(function->argument_count, k.arguments.size()) << function->name;
        FunctionBuilder builder(static_cast<std::uint32_t>(k.arguments.size()));
        std::vector<Number> inputs;
        for (std::uint32_t i = 0; i < k.arguments.size(); ++i) inputs.push_back(builder.input(i));
        const Number result = build_internal_function(k.number, inputs);
        const FunctionEvaluator evaluator(std::make_shared<const scene::Function>(builder.finish(std::array{result})));
        NoiseCells cells;
        EXPECT_NEAR(PointEvaluation(evaluator, cells).value(k.arguments), k.value, 1e-9) << function->name;
    }
    EXPECT_EQ(internal_function(1000), nullptr);
}

}  // namespace
}  // namespace sundog::fields
