// SPDX-License-Identifier: MIT
// All handouts as one HTML page that needs no other file and no network.
#pragma once

#include <filesystem>
#include <string>

namespace rigor::book {

/// Makes the page, in HTML. @param assignments  the folder of the handouts
/// @throws InputError if a text or a picture is missing, or a formula cannot be shown
std::string book(const std::filesystem::path& assignments);

/// The page for printing. All its folded parts (<details>) are unfolded.
std::string unfolded(const std::string& page);

} // namespace rigor::book
