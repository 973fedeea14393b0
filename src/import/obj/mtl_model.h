// SPDX-License-Identifier: Apache-2.0
// Sundog's own MTL key `bsdf`.
#pragma once

#include "base/text_file.h"
#include "scene/reflection_model.h"

namespace sundog::import {

/// What follows the keyword: a model's name and its numbers, and a metal's name where it needs one. Errors: InputError.
scene::ReflectionModel read_reflection_model(LineCursor& cursor);

}  // namespace sundog::import
