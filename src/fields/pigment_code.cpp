// SPDX-License-Identifier: Apache-2.0
#include "fields/pigment_code.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <optional>
#include <string>

#include "base/diagnostics.h"
#include "fields/host_fields.h"
#include "fields/pavement.h"
#include "fields/shader_words.h"
#include "fields/tilings.h"
#include "kernel/shared.h"

namespace sundog::fields {
namespace {

using scene::Pattern;
using scene::Pigment;
using scene::PigmentColor;

std::optional<std::uint32_t> field_of(Pattern::Kind kind) {
    switch (kind) {
        case Pattern::Kind::gradient:
            return kernel::FIELD_GRADIENT;
        case Pattern::Kind::onion:
            return kernel::FIELD_ONION;
        case Pattern::Kind::spherical:
            return kernel::FIELD_SPHERICAL;
        case Pattern::Kind::cylindrical:
            return kernel::FIELD_CYLINDRICAL;
        case Pattern::Kind::planar:
            return kernel::FIELD_PLANAR;
        case Pattern::Kind::boxed:
            return kernel::FIELD_BOXED;
        case Pattern::Kind::radial:
            return kernel::FIELD_RADIAL;
        case Pattern::Kind::leopard:
            return kernel::FIELD_LEOPARD;
        case Pattern::Kind::wood:
            return kernel::FIELD_WOOD;
        case Pattern::Kind::marble:
            return kernel::FIELD_MARBLE;
        case Pattern::Kind::spiral1:
            return kernel::FIELD_SPIRAL1;
        case Pattern::Kind::spiral2:
            return kernel::FIELD_SPIRAL2;
        case Pattern::Kind::bozo:
        case Pattern::Kind::bumps:
        case Pattern::Kind::spotted:
            return kernel::FIELD_NOISE;
        case Pattern::Kind::granite:
            return kernel::FIELD_GRANITE;
        case Pattern::Kind::agate:
            return kernel::FIELD_AGATE;
        case Pattern::Kind::wrinkles:
            return kernel::FIELD_WRINKLES;
        case Pattern::Kind::dents:
            return kernel::FIELD_DENTS;
        case Pattern::Kind::cells:
            return kernel::FIELD_CELLS;
        case Pattern::Kind::crackle:
            return kernel::FIELD_CRACKLE;
        case Pattern::Kind::ripples:
            return kernel::FIELD_RIPPLES;
        case Pattern::Kind::waves:
            return kernel::FIELD_WAVES;
        default:
            return std::nullopt;
    }
}

std::optional<std::uint32_t> choice_of(Pattern::Kind kind) {
    switch (kind) {
        case Pattern::Kind::checker:
            return kernel::CHOICE_CHECKER;
        case Pattern::Kind::brick:
            return kernel::CHOICE_BRICK;
        case Pattern::Kind::hexagon:
            return kernel::CHOICE_HEXAGON;
        case Pattern::Kind::square:
            return kernel::CHOICE_SQUARE;
        case Pattern::Kind::triangular:
            return kernel::CHOICE_TRIANGULAR;
        case Pattern::Kind::cubic:
            return kernel::CHOICE_CUBIC;
        default:
            return std::nullopt;
    }
}

std::uint32_t octaves_of(int octaves) { return static_cast<std::uint32_t>(std::clamp(octaves, 1, 10)); }

/// How a pattern's turbulence moves points.
std::uint32_t way_of(Pattern::Kind kind) {
    switch (kind) {
        case Pattern::Kind::marble:
            return kernel::STIR_X;
        case Pattern::Kind::wood:
            return kernel::STIR_WAVES;
        case Pattern::Kind::spiral1:
        case Pattern::Kind::spiral2:
            return kernel::STIR_ALL_Z;
        default:
            return kernel::STIR_ALL;
    }
}

/// The wave form of a pattern that names none.
std::uint32_t standard_wave(Pattern::Kind kind) {
    switch (kind) {
        case Pattern::Kind::marble:
        case Pattern::Kind::wood:
        case Pattern::Kind::spiral1:
        case Pattern::Kind::spiral2:
            return kernel::WAVE_TRIANGLE;
        default:
            return kernel::WAVE_RAMP;
    }
}

std::uint32_t wave_of(const Pattern& pattern) {
    switch (pattern.wave) {
        case Pattern::Wave::standard:
            return standard_wave(pattern.kind);
        case Pattern::Wave::ramp:
            return kernel::WAVE_RAMP;
        case Pattern::Wave::triangle:
            return kernel::WAVE_TRIANGLE;
        case Pattern::Wave::sine:
            return kernel::WAVE_SINE;
        case Pattern::Wave::scallop:
            return kernel::WAVE_SCALLOP;
        case Pattern::Wave::cubic:
            return kernel::WAVE_CUBIC;
        case Pattern::Wave::poly:
            return kernel::WAVE_POLY;
    }
    return kernel::WAVE_RAMP;
}

/// A function that is a component of a pigment at the pattern's point, or a power of it: what scenes write to change a
/// pigment's gamma.
struct PigmentPower {
    const Pigment* pigment = nullptr;
    std::uint32_t component = 0;
    double exponent = 1;
};

std::optional<PigmentPower> pigment_power_of(const Pattern& pattern) {
    if (pattern.kind != Pattern::Kind::function || !pattern.function) return std::nullopt;
    const scene::Function& f = *pattern.function;
    using Op = scene::FunctionOp;
    constexpr std::uint32_t kComponents = 5;
    const auto input = static_cast<std::uint32_t>(f.first_input());
    const auto first = static_cast<std::uint32_t>(f.first_result());
    const bool has_power = f.code.size() == kComponents + 1;
    if (f.input_count != 3 || f.outputs.size() != 1 || (f.code.size() != kComponents && !has_power))
        return std::nullopt;
    const scene::FunctionInstruction& asks = f.code[0];
    if (asks.op != Op::pigment || asks.a != input || asks.b != input + 1 || asks.c != input + 2) return std::nullopt;
    PigmentPower out{f.pigments[asks.index].get(), f.outputs[0] - first, 1};
    if (has_power) {
        const scene::FunctionInstruction& raises = f.code.back();
        if (raises.op != Op::power || f.outputs[0] != first + kComponents || raises.b >= f.constants.size() ||
            raises.a < first)
            return std::nullopt;
        out.component = raises.a - first;
        out.exponent = f.constants[raises.b];
    }
    if (out.component >= kComponents || !(out.exponent > 0)) return std::nullopt;
    return out;
}

/// Writes one pigment's program.
class ProgramWriter {
public:
    ProgramWriter(std::vector<std::uint32_t>& code, HostFieldTable& host, ShaderPrograms* shaders)
        : code_(code), host_(host), shaders_(shaders) {}

    /// The pigment's colour into colour slot `slot`, asked at point number `base`; slots from there on, values and
    /// points likewise, are free to use.
    void write(const Pigment& pigment, std::uint32_t slot, std::uint32_t base) {
        where_ = &pigment.where;
        check_depth(slot);
        switch (pigment.kind) {
            case Pigment::Kind::solid:
                write_solid(pigment.color, slot);
                break;
            case Pigment::Kind::mapped:
                if (pigment.pattern.kind != Pattern::Kind::average) write_field(pigment.pattern, slot, base);
                write_entries(pigment, slot, base);
                break;
            case Pigment::Kind::choice:
                write_choice(pigment.pattern, slot, base);
                write_entries(pigment, slot, base);
                break;
            case Pigment::Kind::image:
                write_image(pigment, slot, base);
                break;
        }
        where_ = &pigment.where;
    }
    void end() { instruction(kernel::OP_END, 0); }
    /// Makes the red of a pigment the program's weight; where it is 0, what follows isn't run.
    void write_weight(const Pigment& weight) {
        write(weight, 0, 0);
        instruction(kernel::OP_WEIGHT, 0);
    }

    /// The number of the point that a pattern is to be asked at: base or the one after it. `slot` says for which lanes.
    std::uint32_t write_point(const Pattern& pattern, const SourceLocation& where, std::uint32_t slot,
                              std::uint32_t base) {
        where_ = &where;
        check_depth(base + 1);
        std::uint32_t point = base;
        for (const scene::WarpStep& step : pattern.warps) {
            point = write_transform(step.warp_from_before, point, base + 1);
            point = write_warp(step.warp, point, base + 1, slot);
        }
        point = write_transform(pattern.pattern_from_texture, point, base + 1);
        const Stirring stirring{pattern.turbulence, pattern.octaves, pattern.lambda, pattern.omega};
        return write_turbulence(stirring, way_of(pattern.kind), noise_generator_of(pattern), point, base + 1);
    }

private:
    void check_depth(std::uint32_t slot) const {
        if (slot >= kernel::PROGRAM_SLOTS)
            throw InputError(
                {Severity::error, *where_,
                 "pigment maps are nested deeper than " + std::to_string(kernel::PROGRAM_SLOTS) + " levels", "",
                 "take a level out"});
    }
    void instruction(std::uint32_t op, std::uint32_t target, std::uint32_t source = 0, std::uint32_t source2 = 0) {
        code_.push_back(op | target << 8U | source << 16U | source2 << 24U);
        if (shaders_ != nullptr) shaders_->ops |= 1U << op;
    }
    void put(double value) { code_.push_back(std::bit_cast<std::uint32_t>(static_cast<float>(value))); }
    void put_counted(const std::vector<std::uint32_t>& words) {
        code_.push_back(static_cast<std::uint32_t>(words.size()));
        code_.insert(code_.end(), words.begin(), words.end());
    }
    void put(const Vec3d& v) { put(v.x), put(v.y), put(v.z); }
    void put(const PigmentColor& c) { put(c.r), put(c.g), put(c.b), put(c.filter), put(c.transmit); }

    void write_solid(const PigmentColor& color, std::uint32_t slot) {
        instruction(kernel::OP_SOLID, slot);
        put(color);
    }

    std::uint32_t write_transform(const Affine3d& to_from, std::uint32_t from, std::uint32_t to) {
        if (to_from == Affine3d{}) return from;
        instruction(kernel::OP_TRANSFORM, to, from);
        put(to_from.x), put(to_from.y), put(to_from.z), put(to_from.t);
        return to;
    }

    struct Stirring {
        Vec3d amount;
        int octaves;
        double lambda, omega;
    };
    std::uint32_t write_turbulence(const Stirring& stirring, std::uint32_t way, std::uint32_t generator,
                                   std::uint32_t from, std::uint32_t to) {
        if (stirring.amount == Vec3d{}) return from;
        instruction(kernel::OP_TURBULENCE, to, from);
        put(stirring.amount);
        code_.push_back(generator | octaves_of(stirring.octaves) << 8U | way << 16U);
        put(stirring.lambda), put(stirring.omega);
        return to;
    }

    std::uint32_t write_warp(const scene::Warp& warp, std::uint32_t from, std::uint32_t to, std::uint32_t slot) {
        if (warp.kind == scene::Warp::Kind::turbulence)
            return write_turbulence({warp.turbulence, warp.octaves, warp.lambda, warp.omega}, kernel::STIR_ALL, 0, from,
                                    to);
        const ShaderWarp for_shaders = shader_warp(warp);
        instruction(for_shaders.op, to, from, slot);
        code_.push_back(host_.add_shared(make_host_warp(warp)));
        put_counted(for_shaders.words);
        return to;
    }

    /// The field's value, bent by its wave form, into value `slot`.
    void write_field(const Pattern& pattern, std::uint32_t slot, std::uint32_t base) {
        const std::uint32_t point = write_point(pattern, *where_, slot, base);
        const std::optional<std::uint32_t> field = field_of(pattern.kind);
        const bool is_tiling = pattern.kind == Pattern::Kind::tiling && pattern.tiling <= kPeriodicTilings;
        const bool is_gray = pattern.pigment != nullptr &&
                             (pattern.kind == Pattern::Kind::pigment || pattern.kind == Pattern::Kind::image);
        if (is_gray) {
            write(*pattern.pigment, slot, point);
            instruction(kernel::OP_GRAY, slot, slot);
            code_.push_back(pattern.uses_alpha ? 1 : 0);
        } else if (const std::optional<PigmentPower> power = pigment_power_of(pattern)) {
            write(*power->pigment, slot, point);
            instruction(kernel::OP_GRAY, slot, slot);
            code_.push_back(2U + power->component);
            instruction(kernel::OP_POWER, slot);
            put(power->exponent);
        } else if (pattern.kind == Pattern::Kind::crackle && !(pattern.crackle == scene::CrackleForm{})) {
            instruction(kernel::OP_CRACKLE, slot, point);
            put(pattern.crackle.form), put(pattern.crackle.metric), put(pattern.crackle.offset);
            code_.push_back(pattern.crackle.solid ? 1 : 0);
        } else if (is_tiling) {
            write_tiling(pattern.tiling, slot, point);
        } else if (pattern.kind == Pattern::Kind::density_file && shaders_ != nullptr && is_moderate(pattern)) {
            write_density(pattern, slot, point);
        } else if (is_host_field(pattern.kind)) {
            if (pattern.kind == Pattern::Kind::pavement) check_pavement(pattern.pavement);
            write_host_field(pattern, slot, point);
        } else {
            write_kernel_field(pattern, field, slot, point);
        }
        instruction(kernel::OP_WAVE, slot);
        // What isn't drawn takes the middle of its map everywhere.
        const bool drawn = is_gray || field || is_host_field(pattern.kind) || is_tiling;
        code_.push_back(drawn ? wave_of(pattern) : kernel::WAVE_RAMP);
        const bool as_it_is = pattern.frequency == 0;
        put(as_it_is ? 1 : pattern.frequency);
        put(!drawn ? 0.5 : as_it_is ? 0 : pattern.phase);
        put(pattern.exponent);
    }

    void write_host_field(const Pattern& pattern, std::uint32_t slot, std::uint32_t point) {
        const std::optional<ShaderField> for_shaders = shader_field(pattern);
        instruction(for_shaders ? kernel::OP_SHARED_FIELD : kernel::OP_HOST_FIELD, slot, point, slot);
        if (!for_shaders) {
            code_.push_back(host_.add_field(pattern, *where_));
            return;
        }
        code_.push_back(host_.add_shared_field(pattern));
        code_.push_back(for_shaders->kind);
        put_counted(for_shaders->words);
        if (shaders_ != nullptr) shaders_->fields |= for_shaders->fields;
    }

    void check_pavement(const scene::PavementForm& form) const {
        if (find_arrangement(form.sides, form.tiles, form.pattern) != nullptr) return;
        const std::string kind = std::to_string(form.tiles) + " tiles of " + std::to_string(form.sides) + " sides";
        const int count = arrangement_count(form.sides, form.tiles);
        throw InputError({Severity::error, *where_,
                          "there is no pavement " + std::to_string(form.pattern) + " of " + kind, "",
                          count == 0 ? "take fewer tiles" : "they are numbered 1 to " + std::to_string(count)});
    }

    /// Of so many voxels as are copied for shaders.
    static bool is_moderate(const Pattern& pattern) {
        constexpr std::size_t kMostVoxels = std::size_t{1} << 27U;
        return !pattern.density || pattern.density->values.size() <= kMostVoxels;
    }

    void write_density(const Pattern& pattern, std::uint32_t slot, std::uint32_t point) {
        instruction(kernel::OP_DENSITY, slot, point, slot);
        code_.push_back(host_.add_shared(make_host_field(pattern, {})));
        code_.push_back(static_cast<std::uint32_t>(std::clamp(pattern.interpolation, 0, 2)));
        const bool has_voxels = pattern.density && !pattern.density->values.empty();
        for (std::size_t axis = 0; axis < 3; ++axis) code_.push_back(has_voxels ? pattern.density->size[axis] : 0);
        const auto behind = static_cast<std::uint32_t>(code_.size() + 2);
        const auto [known, is_new] = shaders_->densities.try_emplace(pattern.density, behind);
        code_.push_back(known->second);
        put_counted(is_new && has_voxels ? voxel_words(*pattern.density) : std::vector<std::uint32_t>());
    }

    void write_tiling(int number, std::uint32_t slot, std::uint32_t point) {
        const std::vector<std::uint32_t> words = tiling_words(periodic_tiling(number));
        instruction(kernel::OP_TILING, slot, point);
        put_counted(words);
    }

    void write_kernel_field(const Pattern& pattern, std::optional<std::uint32_t> field, std::uint32_t slot,
                            std::uint32_t point) {
        instruction(kernel::OP_FIELD, slot, point);
        const std::uint32_t number = field.value_or(kernel::FIELD_GRADIENT);
        code_.push_back(number);
        if (shaders_ != nullptr) shaders_->fields |= 1U << number;
        const bool spiral = pattern.kind == Pattern::Kind::spiral1 || pattern.kind == Pattern::Kind::spiral2;
        Vec3d parameters = normalize(pattern.axis);
        if (spiral) parameters = {static_cast<double>(pattern.arms), 0, 0};
        std::uint32_t octaves = 0;
        if (pattern.kind == Pattern::Kind::agate) {
            parameters = {pattern.agate_turbulence, pattern.lambda, pattern.omega};
            octaves = octaves_of(pattern.octaves);
        }
        put(field ? parameters : Vec3d{});
        code_.push_back(noise_generator_of(pattern) | octaves << 8U);
    }

    void write_choice(const Pattern& pattern, std::uint32_t slot, std::uint32_t base) {
        // Floors and walls lie on the borders of squares all the time (a checker on plane { y, -1 }); single precision
        // would draw lots there. POV-Ray gives such a border to the upper side. Squares larger than a unit have no
        // wider borders.
        constexpr double kBorder = 1e-4;
        if (pattern.kind == Pattern::Kind::object || pattern.kind == Pattern::Kind::material) {
            const std::uint32_t point = write_point(pattern, *where_, slot, base);
            instruction(kernel::OP_HOST_FIELD, slot, point, slot);
            code_.push_back(host_.add_field(pattern, *where_));
            return;
        }
        Pattern raised = pattern;
        Affine3d& m = raised.pattern_from_texture;
        const auto border = [&](double x, double y, double z) {
            return kBorder * std::min(1.0, length(Vec3d{x, y, z}));
        };
        m.t += Vec3d{border(m.x.x, m.y.x, m.z.x), border(m.x.y, m.y.y, m.z.y), border(m.x.z, m.y.z, m.z.z)};
        const std::uint32_t point = write_point(raised, *where_, slot, base);
        instruction(kernel::OP_CHOICE, slot, point);
        code_.push_back(choice_of(pattern.kind).value_or(kernel::CHOICE_CHECKER));
        put(pattern.brick_size);
        put(pattern.mortar);
    }

    void write_entries(const Pigment& pigment, std::uint32_t slot, std::uint32_t base) {
        const bool average = pigment.pattern.kind == Pattern::Kind::average;
        const bool map = pigment.kind == Pigment::Kind::mapped;
        const std::vector<scene::PigmentEntry>& entries = pigment.entries;
        const bool plain =
            std::none_of(entries.begin(), entries.end(), [](const auto& e) { return e.pigment != nullptr; });
        if (plain && !average) {
            instruction(map ? kernel::OP_MAP : kernel::OP_PICK, slot, slot);
            code_.push_back(static_cast<std::uint32_t>(entries.size()));
            for (const scene::PigmentEntry& entry : entries) {
                if (map) put(entry.at);
                put(entry.color);
            }
            return;
        }
        double total = 0;
        for (const scene::PigmentEntry& entry : entries) total += static_cast<double>(entry.at);
        check_depth(slot + 1);
        instruction(kernel::OP_CLEAR, slot);
        for (std::size_t i = 0; i < entries.size(); ++i) {
            instruction(average ? kernel::OP_ENTER_SHARE : map ? kernel::OP_ENTER_MAP : kernel::OP_ENTER_PICK, slot);
            if (average) {
                put(total > 0 ? static_cast<double>(entries[i].at) / total : 1.0 / static_cast<double>(entries.size()));
            } else if (map) {
                put(i > 0 ? entries[i - 1].at : -2.0);
                put(entries[i].at);
                put(i + 1 < entries.size() ? entries[i + 1].at : 3.0);
            } else {
                put(static_cast<double>(i));
            }
            const std::size_t skip = code_.size();
            code_.push_back(0);
            if (entries[i].pigment) write(*entries[i].pigment, slot + 1, base);
            else write_solid(entries[i].color, slot + 1);
            instruction(kernel::OP_BLEND, slot);
            code_[skip] = static_cast<std::uint32_t>(code_.size() - skip - 1);
        }
    }

    void write_image(const Pigment& pigment, std::uint32_t slot, std::uint32_t base) {
        const scene::ImageMap& image = pigment.image;
        const std::uint32_t point = write_point(pigment.pattern, pigment.where, slot, base);
        instruction(kernel::OP_IMAGE, slot, point);
        code_.push_back(image.texture);
        code_.push_back((image.once ? kernel::IMAGE_ONCE : 0U) | (image.smooth ? kernel::IMAGE_SMOOTH : 0U));
        code_.push_back(static_cast<std::uint32_t>(image.map_type));
        put(image.filter_all), put(image.transmit_all);
    }

    std::vector<std::uint32_t>& code_;
    HostFieldTable& host_;
    ShaderPrograms* shaders_;
    const SourceLocation* where_ = nullptr;  ///< Of the pigment that is being written.
};

}  // namespace

std::uint32_t noise_generator_of(const Pattern& pattern) {
    return pattern.noise_generator == 0 ? 2 : static_cast<std::uint32_t>(std::clamp(pattern.noise_generator, 1, 3));
}

void write_pigment_code(const scene::Pigment& pigment, std::vector<std::uint32_t>& code, HostFieldTable& host,
                        const scene::Pigment* weight, ShaderPrograms* shaders) {
    ProgramWriter writer(code, host, shaders);
    if (weight != nullptr) writer.write_weight(*weight);
    writer.write(pigment, 0, 0);
    writer.end();
}

void write_point_code(const Pattern& pattern, const SourceLocation& where, std::vector<std::uint32_t>& code,
                      HostFieldTable& host, ShaderPrograms* shaders) {
    ProgramWriter writer(code, host, shaders);
    if (shaders != nullptr) shaders->ops |= 1U << kernel::OP_POINT;
    writer.write_point(pattern, where, 0, 0);
    writer.end();
}

}  // namespace sundog::fields
