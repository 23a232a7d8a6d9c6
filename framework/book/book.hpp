// SPDX-License-Identifier: MIT
// All handouts as one page that needs no other file and no network.
#pragma once

#include <filesystem>
#include <string>

namespace rigor::book {

/// @param assignments  the folder of the handouts
/// @throws InputError if a text or a picture is missing, or a formula cannot be shown
std::string book(const std::filesystem::path& assignments);

/// The same page for paper: all folds are open.
std::string unfolded(const std::string& page);

} // namespace rigor::book
