// SPDX-License-Identifier: Apache-2.0
// Pigments as programs of the kernel (kernel/patterns/program.h).
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "fields/host_fields.h"
#include "scene/pigment.h"

namespace sundog::fields {

/// 1 to 3.
std::uint32_t noise_generator_of(const scene::Pattern& pattern);

/// What shaders want to know of the programs in some code.
struct ShaderPrograms {
    std::uint32_t ops = 0, fields = 0;  ///< OP_* and FIELD_* that occur, as bits.
    /// Where in the code the voxels of density files are.
    std::map<std::shared_ptr<const scene::DensityGrid>, std::uint32_t> densities;
};

/// Appends the program of a pigment; what only the host computes goes into `host`. The red of `weight`, if there is
/// one, is the program's weight. Voxels come into the code only if there are `shaders`. Errors: InputError for
/// pigment maps nested deeper than PROGRAM_SLOTS.
void write_pigment_code(const scene::Pigment& pigment, std::vector<std::uint32_t>& code, HostFieldTable& host,
                        const scene::Pigment* weight = nullptr, ShaderPrograms* shaders = nullptr);

/// Appends a program that makes point 1 a pattern's own point: with its warps, transforms and turbulence.
void write_point_code(const scene::Pattern& pattern, const SourceLocation& where, std::vector<std::uint32_t>& code,
                      HostFieldTable& host, ShaderPrograms* shaders = nullptr);

}  // namespace sundog::fields
