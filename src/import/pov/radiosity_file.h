// SPDX-License-Identifier: Apache-2.0
// Files of radiosity: `save_file` and `load_file`, Radiosity_File_Name. The format is Sundog's own; povray's files are
// of povray alone.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "base/irradiance.h"
#include "import/pov/build_context.h"

namespace sundog::pov {

/// The contents of such a file: a line that names the format, one with the number of samples, then for each of them its
/// bounce, a 32-bit word, and 28 32-bit floats, lowest byte first: place, normal, light, reach, then the light's
/// changes by moving and by turning, three vectors each.
std::string radiosity_file_bytes(const StoredRadiosity& samples);

/// The reverse. Errors: std::runtime_error that says what is wrong.
StoredRadiosity radiosity_of_bytes(std::string_view bytes);

/// Reads the file that a scene names at a place. Errors: InputError there.
std::shared_ptr<const StoredRadiosity> load_radiosity(BuildContext& context, std::string_view name, Place where);

/// What writes to the file that a scene names at a place, once all is gathered. Errors: InputError there for what may
/// not be written.
std::shared_ptr<const RadiosityStore> radiosity_store(BuildContext& context, std::string_view name, Place where);

}  // namespace sundog::pov
