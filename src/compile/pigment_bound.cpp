// SPDX-License-Identifier: Apache-2.0
#include "compile/pigment_bound.h"

#include <algorithm>
#include <cmath>

namespace sundog {
namespace {

float most_of(const scene::PigmentColor& color) {
    return std::max({std::abs(color.r), std::abs(color.g), std::abs(color.b)});
}

}  // namespace

float most_of(const scene::Pigment& pigment) {
    switch (pigment.kind) {
        case scene::Pigment::Kind::solid:
            return most_of(pigment.color);
        case scene::Pigment::Kind::image:
            return 1;  // Texels are.
        case scene::Pigment::Kind::mapped:
        case scene::Pigment::Kind::choice:
            break;
    }
    // Between two entries of a map, colours are between theirs.
    float most = 0;
    for (const scene::PigmentEntry& entry : pigment.entries)
        most = std::max(most, entry.pigment ? most_of(*entry.pigment) : most_of(entry.color));
    return most;
}

}  // namespace sundog
