// SPDX-License-Identifier: Apache-2.0
#include "fields/pigment_code.h"

#include <algorithm>
#include <array>
#include <bit>
#include <optional>
#include <string>

#include "base/diagnostics.h"
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

/// The wave form of a pattern that names none.
std::uint32_t standard_wave(Pattern::Kind kind) {
    switch (kind) {
        case Pattern::Kind::marble:
        case Pattern::Kind::wood:
        case Pattern::Kind::spiral1:
            return kernel::WAVE_TRIANGLE;
        case Pattern::Kind::spiral2:
            return kernel::WAVE_NONE;
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

/// Writes one pigment's program.
class ProgramWriter {
public:
    explicit ProgramWriter(std::vector<std::uint32_t>& code) : code_(code) {}

    /// The pigment's colour into colour slot `slot`; slots from there on, and values likewise, are free to use.
    void write(const Pigment& pigment, std::uint32_t slot) {
        if (slot >= kernel::PROGRAM_SLOTS)
            throw InputError(
                {Severity::error, pigment.where,
                 "pigment maps are nested deeper than " + std::to_string(kernel::PROGRAM_SLOTS) + " levels", "",
                 "take a level out"});
        switch (pigment.kind) {
            case Pigment::Kind::solid:
                write_solid(pigment.color, slot);
                break;
            case Pigment::Kind::mapped:
                write_field(pigment.pattern, slot);
                write_entries(pigment, slot);
                break;
            case Pigment::Kind::choice:
                write_choice(pigment.pattern, slot);
                write_entries(pigment, slot);
                break;
            case Pigment::Kind::image:
                write_image(pigment.image, slot);
                break;
        }
    }
    void end() { instruction(kernel::OP_END, 0); }

private:
    // Every pattern starts from the texture's own point, so one more is enough.
    static constexpr std::uint32_t kPatternPoint = 1;

    void instruction(std::uint32_t op, std::uint32_t target, std::uint32_t source = 0, std::uint32_t source2 = 0) {
        code_.push_back(op | target << 8U | source << 16U | source2 << 24U);
    }
    void put(double value) { code_.push_back(std::bit_cast<std::uint32_t>(static_cast<float>(value))); }
    void put(const Vec3d& v) { put(v.x), put(v.y), put(v.z); }
    void put(const PigmentColor& c) { put(c.r), put(c.g), put(c.b), put(c.filter), put(c.transmit); }

    void write_solid(const PigmentColor& color, std::uint32_t slot) {
        instruction(kernel::OP_SOLID, slot);
        put(color);
    }

    /// The number of the point that a pattern is to be asked at.
    std::uint32_t write_point(const Affine3d& pattern_from_texture) {
        if (pattern_from_texture == Affine3d{}) return 0;
        instruction(kernel::OP_TRANSFORM, kPatternPoint, 0);
        put(pattern_from_texture.x), put(pattern_from_texture.y), put(pattern_from_texture.z);
        put(pattern_from_texture.t);
        return kPatternPoint;
    }

    /// The same, with the pattern's turbulence.
    std::uint32_t write_stirred_point(const Pattern& pattern) {
        const std::uint32_t point = write_point(pattern.pattern_from_texture);
        if (pattern.turbulence == Vec3d{}) return point;
        instruction(kernel::OP_TURBULENCE, kPatternPoint, point);
        put(pattern.turbulence);
        code_.push_back(static_cast<std::uint32_t>(std::clamp(pattern.octaves, 1, 10)));
        put(pattern.lambda), put(pattern.omega);
        return kPatternPoint;
    }

    void write_field(const Pattern& pattern, std::uint32_t slot) {
        const std::optional<std::uint32_t> field = field_of(pattern.kind);
        const std::uint32_t point = write_stirred_point(pattern);
        instruction(kernel::OP_FIELD, slot, point);
        code_.push_back(field.value_or(kernel::FIELD_GRADIENT));
        const bool spiral = pattern.kind == Pattern::Kind::spiral1 || pattern.kind == Pattern::Kind::spiral2;
        Vec3d parameters = normalize(pattern.axis);
        if (spiral) parameters = {static_cast<double>(pattern.arms), 0, 0};
        if (pattern.kind == Pattern::Kind::agate) parameters = {pattern.agate_turbulence, 0, 0};
        put(field ? parameters : Vec3d{});
        code_.push_back(static_cast<std::uint32_t>(std::clamp(pattern.noise_generator, 1, 3)));
        instruction(kernel::OP_WAVE, slot);
        // What isn't drawn yet takes the middle of its map everywhere.
        code_.push_back(field ? wave_of(pattern) : kernel::WAVE_RAMP);
        put(field ? pattern.frequency : 0), put(field ? pattern.phase : 0.5), put(pattern.exponent);
    }

    void write_choice(const Pattern& pattern, std::uint32_t slot) {
        // Floors and walls lie on the borders of squares all the time (a checker on plane { y, -1 }); single precision
        // would draw lots there. POV-Ray gives such a border to the upper side.
        constexpr double kBorder = 1e-4;
        Pattern raised = pattern;
        raised.pattern_from_texture.t += Vec3d{kBorder, kBorder, kBorder};
        const std::uint32_t point = write_stirred_point(raised);
        instruction(kernel::OP_CHOICE, slot, point);
        code_.push_back(choice_of(pattern.kind).value_or(kernel::CHOICE_CHECKER));
        put(pattern.brick_size);
        put(pattern.mortar);
    }

    void write_entries(const Pigment& pigment, std::uint32_t slot) {
        const bool map = pigment.kind == Pigment::Kind::mapped;
        const std::vector<scene::PigmentEntry>& entries = pigment.entries;
        const bool plain =
            std::none_of(entries.begin(), entries.end(), [](const auto& e) { return e.pigment != nullptr; });
        if (plain) {
            instruction(map ? kernel::OP_MAP : kernel::OP_PICK, slot, slot);
            code_.push_back(static_cast<std::uint32_t>(entries.size()));
            for (const scene::PigmentEntry& entry : entries) {
                if (map) put(entry.at);
                put(entry.color);
            }
            return;
        }
        instruction(kernel::OP_CLEAR, slot);
        for (std::size_t i = 0; i < entries.size(); ++i) {
            if (entries[i].pigment) write(*entries[i].pigment, slot + 1);
            else write_solid(entries[i].color, slot + 1);
            if (map) {
                instruction(kernel::OP_BLEND_MAP, slot, slot + 1, slot);
                put(i > 0 ? entries[i - 1].at : -2.0);
                put(entries[i].at);
                put(i + 1 < entries.size() ? entries[i + 1].at : 3.0);
            } else {
                instruction(kernel::OP_BLEND_PICK, slot, slot + 1, slot);
                put(static_cast<double>(i));
            }
        }
    }

    void write_image(const scene::ImageMap& image, std::uint32_t slot) {
        const std::uint32_t point = write_point(image.pattern_from_texture);
        instruction(kernel::OP_IMAGE, slot, point);
        code_.push_back(image.texture);
        code_.push_back((image.once ? kernel::IMAGE_ONCE : 0U) | (image.smooth ? kernel::IMAGE_SMOOTH : 0U));
        code_.push_back(static_cast<std::uint32_t>(image.map_type));
        put(image.filter_all), put(image.transmit_all);
    }

    std::vector<std::uint32_t>& code_;
};

}  // namespace

void write_pigment_code(const scene::Pigment& pigment, std::vector<std::uint32_t>& code) {
    ProgramWriter writer(code);
    writer.write(pigment, 0);
    writer.end();
}

}  // namespace sundog::fields
