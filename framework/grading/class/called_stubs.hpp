// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace rigor {

/// The other topics whose formulas a correct solution of `topic` calls, and whose files in student/
/// still have stubs. A submission without files for these topics is linked with the stubs, so all
/// formulas that call them fail. The topics are in the order of the assignments. They are found by
/// the includes of reference/; in a tree without this folder the result is empty.
std::vector<std::string> called_stubs(const std::filesystem::path& source,
                                      const std::string& topic);

} // namespace rigor
