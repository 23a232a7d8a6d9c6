// SPDX-License-Identifier: MIT
// What a solution may include: the contract of the formulas, its own folder, and what the system
// offers.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace rigor {

/// Removes the objects without a list of what they were made from, so that a build makes both anew.
/// Objects are relative to the build folder; the list is the compiler's own, `<object>.d`.
void remove_unlisted(const std::vector<std::string>& objects);

/// One line for the first object, made from a file of `folder`, that has something else of this
/// tree or its build in it (by whatever path, macro or link it got there), or a file that is not
/// there; empty if there is none.
///
/// @throws std::runtime_error if an object has no list
std::string forbidden_include(const std::vector<std::string>& objects,
                              const std::filesystem::path& folder);

} // namespace rigor
