// SPDX-License-Identifier: MIT
// Checks what a solution includes. It may include the contract of the formulas, files of its own
// folder, and system headers.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace rigor {

/// Removes each object that has no list of the files it was made from, so that a build makes both
/// again. Objects are relative to the build folder; the list is the compiler's own, `<object>.d`.
void remove_unlisted(const std::vector<std::string>& objects);

/// An error message of one line about the first object with a forbidden file in it: another file of
/// this tree or of its build (by whatever path, macro or link it was included), or a file that does
/// not exist any more. Empty if there is none.
///
/// @param folder  the solution from whose files the objects were made
/// @throws std::runtime_error if an object has no list
std::string forbidden_include(const std::vector<std::string>& objects,
                              const std::filesystem::path& folder);

} // namespace rigor
