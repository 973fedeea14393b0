// SPDX-License-Identifier: Apache-2.0
// Evaluates flat functions: their value, their derivatives, and bounds over boxes.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "fields/affine_math.h"
#include "fields/gradient_math.h"
#include "fields/run.h"
#include "scene/function.h"
#include "scene/scene.h"

namespace sundog::fields {

/// A function made ready. Immutable: any number of threads may use it, each with a Workspace of its own.
class FunctionEvaluator {
public:
    /// `textures` are what images in the function's pigments are taken from; copied where they are needed.
    explicit FunctionEvaluator(std::shared_ptr<const scene::Function> function,
                               std::span<const scene::Texture> textures = {});

    [[nodiscard]] const scene::Function& function() const { return *function_; }
    [[nodiscard]] const PigmentSource* pigments() const { return pigments_.get(); }
    /// Instructions that one evaluation may take (loops can be long).
    static constexpr std::uint64_t kStepLimit = 1'000'000;

private:
    std::shared_ptr<const scene::Function> function_;
    std::shared_ptr<const PigmentSource> pigments_;
};

/// Registers for one kind of number. Small functions need no heap.
template <class Math>
class Registers {
public:
    using Value = typename Math::Value;
    explicit Registers(const scene::Function& f) : f_(f) {
        if (f.register_count() > kFew) {
            many_ = std::make_unique_for_overwrite<Value[]>(f.register_count());
            data_ = many_.get();
        }
        for (std::size_t i = 0; i < f.constants.size(); ++i) data_[i] = Math::constant(f.constants[i]);
    }
    [[nodiscard]] Value* data() { return data_; }
    void set_input(std::size_t i, const Value& v) { data_[f_.first_input() + i] = v; }
    [[nodiscard]] const Value& output(std::size_t i) const { return data_[f_.outputs[i]]; }

private:
    static constexpr std::size_t kFew = 96;
    union Few {
        Few() {}  // NOLINT(modernize-use-equals-default): the registers aren't to be filled
        std::array<Value, kFew> values;
    };
    const scene::Function& f_;
    Few few_;
    std::unique_ptr<Value[]> many_;
    Value* data_ = few_.values.data();
};

/// Values of a function of doubles, point by point.
class PointEvaluation {
public:
    explicit PointEvaluation(const FunctionEvaluator& f, NoiseCells& cells) : PointEvaluation(f, cells, f.pigments()) {}
    /// With a memory of colours between the function and its pigments.
    PointEvaluation(const FunctionEvaluator& f, NoiseCells& cells, const PigmentSource* pigments)
        : f_(f.function()), math_{pigments, &cells}, registers_(f_) {}
    /// Runs the function; output() tells what came out. False where it takes too long.
    bool run(std::span<const double> inputs, std::uint64_t& budget) {
        for (std::size_t i = 0; i < f_.input_count; ++i) registers_.set_input(i, inputs[i]);
        fields::run(math_, f_, registers_.data(), budget);
        return budget > 0;
    }
    /// The first output; no number where it takes more than the step limit.
    double value(std::span<const double> inputs) {
        std::uint64_t budget = FunctionEvaluator::kStepLimit;
        return run(inputs, budget) ? output(0) : DoubleMath::unknown();
    }
    [[nodiscard]] double output(std::size_t i) const { return registers_.output(i); }

private:
    const scene::Function& f_;
    DoubleMath math_;
    Registers<DoubleMath> registers_;
};

/// Values of a function of three inputs at many points, in order: colours of the pigments that it asks for at the point
/// itself are computed together, ahead.
class PointsEvaluation {
public:
    PointsEvaluation(const FunctionEvaluator& f, std::span<const Vec3d> points);
    PointsEvaluation(const PointsEvaluation&) = delete;
    PointsEvaluation& operator=(const PointsEvaluation&) = delete;
    ~PointsEvaluation() = default;
    /// The first output at the next point; counts `budget` down, and is nothing where that is at an end.
    std::optional<double> next(std::uint64_t& budget);

private:
    /// Answers from what was computed ahead, for the point that is under way.
    class Ahead final : public PigmentSource {
    public:
        Ahead(const FunctionEvaluator& f, std::span<const Vec3d> points);
        [[nodiscard]] std::array<double, 5> color(std::uint32_t index, double x, double y, double z) const override;
        [[nodiscard]] std::array<double, 2> range(std::uint32_t index, std::uint8_t component) const override {
            return source_->range(index, component);
        }
        [[nodiscard]] double slope_limit(std::uint32_t index) const override { return source_->slope_limit(index); }
        std::size_t at = 0;

    private:
        const PigmentSource* source_;
        std::span<const Vec3d> points_;
        std::vector<std::vector<std::array<double, 5>>> colors_;  ///< By pigment and point.
    };

    std::span<const Vec3d> points_;
    NoiseCells cells_;
    Ahead ahead_;
    PointEvaluation evaluation_;
};

/// Values and derivatives by the function's first N inputs.
template <std::size_t N>
class GradientEvaluation {
public:
    explicit GradientEvaluation(const FunctionEvaluator& f, NoiseCells& cells)
        : f_(f.function()), math_{f.pigments(), &cells}, registers_(f_) {}
    void run(std::span<const double> inputs) {
        for (std::size_t i = 0; i < f_.input_count; ++i) {
            Derived<N> v{inputs[i], {}};
            if (i < N) v.by[i] = 1;
            registers_.set_input(i, v);
        }
        std::uint64_t budget = FunctionEvaluator::kStepLimit;
        fields::run(math_, f_, registers_.data(), budget);
    }
    [[nodiscard]] const Derived<N>& output(std::size_t i) const { return registers_.output(i); }

private:
    const scene::Function& f_;
    GradientMath<N> math_;
    Registers<GradientMath<N>> registers_;
};

/// Bounds over ranges of N variables that the inputs depend on.
template <std::size_t N>
class RangeEvaluation {
public:
    explicit RangeEvaluation(const FunctionEvaluator& f, NoiseCells& cells) : RangeEvaluation(f, cells, f.pigments()) {}
    /// With a memory of colours between the function and its pigments.
    RangeEvaluation(const FunctionEvaluator& f, NoiseCells& cells, const PigmentSource* pigments)
        : f_(f.function()), math_{pigments, &cells, &undefined_}, registers_(f_) {}
    RangeEvaluation(const RangeEvaluation&) = delete;
    RangeEvaluation& operator=(const RangeEvaluation&) = delete;
    ~RangeEvaluation() = default;
    void set_input(std::size_t i, const Affine<N>& v) { registers_.set_input(i, v); }
    /// Runs the function; what came out encloses all values that are numbers.
    void run() {
        undefined_ = false;
        std::uint64_t budget = FunctionEvaluator::kStepLimit;
        fields::run(math_, f_, registers_.data(), budget);
        too_long_ = budget == 0;
    }
    [[nodiscard]] Affine<N> output(std::size_t i) const {
        return too_long_ ? AffineMath<N>::unknown() : registers_.output(i);
    }
    /// Whether the function may have no value somewhere (the square root of -1).
    [[nodiscard]] bool may_be_undefined() const { return undefined_ || too_long_; }

private:
    const scene::Function& f_;
    bool undefined_ = false, too_long_ = false;
    AffineMath<N> math_;
    Registers<AffineMath<N>> registers_;
};

}  // namespace sundog::fields
