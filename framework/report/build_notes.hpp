// SPDX-License-Identifier: MIT
#pragma once

#include "grading/build/implementation.hpp"

#include <string>

namespace rigor {

/// What a user must know of a build, in lines: files that do not compile, are missing or were left
/// out, and how long it took.
std::string build_notes(const Implementation& implementation);

} // namespace rigor
