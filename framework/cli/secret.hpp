// SPDX-License-Identifier: MIT
// The secret of a course, from which `seeds/drawn_seed.hpp` draws the seeds of random tests.
#pragma once

#include <string>

namespace rigor {

/// The content of the file that --secret names, without the line breaks at its end. The result is
/// empty if `file`, the name of the file, is empty.
/// @throws InputError if the file cannot be read, or if the secret is too short or too long
std::string secret_in(const std::string& file);

} // namespace rigor
