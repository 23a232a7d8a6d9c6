// SPDX-License-Identifier: MIT
#pragma once

#include "grading/build/implementation.hpp"

#include <string>

namespace rigor {

/// What a user must know of a build, in lines: files that do not compile, are missing or were left
/// out, names that are defined nowhere, and how long it took. However many names a submission uses,
/// and however long they are, it is about a page.
std::string build_notes(const Implementation& implementation);

} // namespace rigor
