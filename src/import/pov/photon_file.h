// SPDX-License-Identifier: Apache-2.0
// Files of photons: `save_file` and `load_file`. The format is Sundog's own; povray's files are of povray alone.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "base/photons.h"
#include "import/pov/build_context.h"

namespace sundog::pov {

/// The contents of such a file: a line that names the format, one with the numbers of photons on surfaces and in
/// media, then for each of them twelve 32-bit floats, lowest byte first: place, direction, surface's normal, power.
std::string photon_file_bytes(const StoredPhotons& photons);

/// The reverse. Errors: std::runtime_error that says what is wrong.
StoredPhotons photons_of_bytes(std::string_view bytes);

/// Reads the file that a scene names at a place. Errors: InputError there.
std::shared_ptr<const StoredPhotons> load_photons(BuildContext& context, std::string_view name, Place where);

/// What writes to the file that a scene names at a place, once there is something to write. Errors: InputError there
/// for what may not be written.
std::shared_ptr<const PhotonStore> photon_store(BuildContext& context, std::string_view name, Place where);

}  // namespace sundog::pov
