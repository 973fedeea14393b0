// SPDX-License-Identifier: Apache-2.0
// The albedos that kernel/bsdf/albedo_tables.h looks up.
#pragma once

#include <vector>

namespace sundog {

/// All tables, one after the other, as kernel::BSDF_TABLE_* says from kernel::BSDF_TABLES_FIRST on; worked out when
/// first asked for.
const std::vector<float>& bsdf_tables();

}  // namespace sundog
