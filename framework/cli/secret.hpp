// SPDX-License-Identifier: MIT
// The secret of a course, from which `seeds/drawn_seed.hpp` draws the random cases.
#pragma once

#include <string>

namespace rigor {

/// The content of the file that --secret names, without the newline at its end; empty without a
/// name.
/// @throws InputError if it cannot be read, or is too short to be a secret or too long
std::string secret_in(const std::string& file);

} // namespace rigor
