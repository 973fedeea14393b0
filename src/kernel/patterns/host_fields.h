// SPDX-License-Identifier: Apache-2.0
// What only the host computes for pigment programs, behind the interface by which kernel/patterns/host.h asks. The
// CPU's alone; shaders never see this header.
#ifndef SUNDOG_KERNEL_PATTERNS_HOST_FIELDS_H
#define SUNDOG_KERNEL_PATTERNS_HOST_FIELDS_H

#include <span>

#include "kernel/compat/types.h"

namespace sundog::kernel {

/// A lane's PatternPoint (kernel/patterns/host.h).
struct HostPoint {
    vec3 p, normal, direction, world;
};

/// Fields (x of the answer), warps (points) and normals (what is added to them), by number. Any number of threads may
/// ask at once.
class HostFields {
public:
    HostFields() = default;
    HostFields(const HostFields&) = delete;
    HostFields& operator=(const HostFields&) = delete;
    virtual ~HostFields() = default;
    /// What field number `index` answers at each of the points, into as many of `answers`.
    virtual void at(uint index, std::span<const HostPoint> points, std::span<vec3> answers) const = 0;
};

}  // namespace sundog::kernel

#endif
