// SPDX-License-Identifier: Apache-2.0
// Every kernel function gives the same bits for one ray at a time and for 4, 8 or 16.
#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <random>
#include <vector>

#include "lanes/functions.h"

namespace sundog::test {
namespace {

using Evaluate = std::string_view (*)(std::size_t, const Batch&);

class Lanes : public testing::Test {
protected:
    static constexpr std::size_t kCount = 1 << 14;

    Lanes() {
        std::mt19937 random(1);
        std::uniform_real_distribution<float> number(-2, 2);
        for (auto& column : inputs_) {
            column.resize(kCount);
            for (float& x : column) x = number(random);
        }
        // Some rays along the axes and through corners, where comparisons are close calls.
        for (std::size_t i = 0; i < kCount; i += 7)
            for (std::size_t k = 3; k < 6; ++k) inputs_[k][i] = static_cast<float>((i >> k) % 3) - 1.0F;
    }

    /// All functions' outputs, and their names.
    std::vector<std::vector<float>> evaluate(Evaluate evaluate, std::vector<std::string_view>& names) {
        std::vector<std::vector<float>> all;
        names.clear();
        for (std::size_t function = 0;; ++function) {
            std::vector<float> outputs(kOutputs * kCount);
            std::array<const float*, kInputs> in{};
            std::array<float*, kOutputs> out{};
            for (std::size_t k = 0; k < kInputs; ++k) in[k] = inputs_[k].data();
            for (std::size_t k = 0; k < kOutputs; ++k) out[k] = outputs.data() + k * kCount;
            const std::string_view name = evaluate(function, {kCount, in.data(), out.data()});
            if (name.empty()) return all;
            names.push_back(name);
            all.push_back(std::move(outputs));
        }
    }

    void expect_scalar_bits(Evaluate wide) {
        std::vector<std::string_view> names;
        const auto want = evaluate(evaluate_1, names);
        const auto got = evaluate(wide, names);
        ASSERT_GE(names.size(), 12U);
        for (std::size_t f = 0; f < names.size(); ++f) {
            std::size_t differ = 0, set = 0;
            for (std::size_t i = 0; i < want[f].size(); ++i) {
                // NaN's sign and payload are nobody's business.
                const bool both_nan = want[f][i] != want[f][i] && got[f][i] != got[f][i];
                differ +=
                    !both_nan && std::bit_cast<std::uint32_t>(want[f][i]) != std::bit_cast<std::uint32_t>(got[f][i]);
                set += want[f][i] != 0;
            }
            EXPECT_EQ(differ, 0U) << names[f];
            EXPECT_GT(set, kCount / 20) << names[f] << " was hardly exercised";
        }
    }

private:
    std::array<std::vector<float>, kInputs> inputs_;
};

// Catches a lane operation that rounds, selects or compares other than its scalar one.
TEST_F(Lanes, FourGiveTheScalarBits) { expect_scalar_bits(evaluate_4); }

TEST_F(Lanes, EightGiveTheScalarBits) {
    if (!__builtin_cpu_supports("avx2")) GTEST_SKIP() << "this processor has no AVX2";
    expect_scalar_bits(evaluate_8);
}

TEST_F(Lanes, SixteenGiveTheScalarBits) {
    if (!__builtin_cpu_supports("avx512vl") || !__builtin_cpu_supports("avx512dq"))
        GTEST_SKIP() << "this processor has no AVX-512";
    expect_scalar_bits(evaluate_16);
}

// Our own functions against the library's, to the error that their declarations promise.
// Catches a wrong coefficient. (Relative for power and exp2, absolute for log2 and the angle.)
TEST_F(Lanes, TranscendentalFunctionsAreAccurate) {
    std::mt19937 random(2);
    std::uniform_real_distribution<float> number(-2, 2);
    std::vector<std::vector<float>> in(kInputs, std::vector<float>(kCount)), out(kOutputs, std::vector<float>(kCount));
    std::array<const float*, kInputs> inputs{};
    std::array<float*, kOutputs> outputs{};
    for (std::size_t k = 0; k < kInputs; ++k) {
        for (float& x : in[k]) x = number(random);
        inputs[k] = in[k].data();
    }
    for (std::size_t k = 0; k < kOutputs; ++k) outputs[k] = out[k].data();
    std::size_t f = 0;
    const Batch batch{kCount, inputs.data(), outputs.data()};
    while (evaluate_1(f, batch).substr(0, 5) != "power") ++f;
    for (std::size_t i = 0; i < kCount; ++i) {
        const double base = std::fabs(in[0][i]);
        const double power = std::pow(base, std::fabs(static_cast<double>(in[1][i])) * 100.0);
        if (power > 1e-35 && power < 1e35) {
            EXPECT_NEAR(out[0][i] / power, 1.0, 4e-5) << base;
        }
        EXPECT_NEAR(out[1][i], std::log2(base + 1e-6), 2e-6);
        EXPECT_NEAR(out[2][i] / std::exp2(in[1][i] * 40.0), 1.0, 4e-6);
        EXPECT_NEAR(out[3][i], std::atan2(in[2][i], in[3][i]), 2e-6);
    }
}

}  // namespace
}  // namespace sundog::test
