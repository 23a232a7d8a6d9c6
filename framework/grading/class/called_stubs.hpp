// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace rigor {

/// The other topics whose formulas a right solution of a topic calls, and of which student/ has
/// stubs. A submission without files for them loses the points of what calls them, since nothing
/// but its own worker answers such a call. In the order of the assignments; none if the tree has no
/// reference/, whose includes say what calls what.
std::vector<std::string> called_stubs(const std::filesystem::path& source,
                                      const std::string& topic);

} // namespace rigor
