// SPDX-License-Identifier: MIT
// The secret of a course, from which `seeds/drawn_seed.hpp` draws the seeds of random cases.
#pragma once

#include <string>

namespace rigor {

/// The content of the file that --secret names, without the newline at its end; empty if `file` is
/// empty.
/// @throws InputError if it cannot be read, or is too short to be a secret or too long
std::string secret_in(const std::string& file);

} // namespace rigor
