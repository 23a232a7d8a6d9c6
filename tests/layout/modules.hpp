// SPDX-License-Identifier: MIT
// Modules, x.hpp and x.cpp together, and who includes whom.
#pragma once

#include "layout/files.hpp"

#include <map>
#include <set>
#include <string>
#include <vector>

namespace rigor::layout {

/// Path of a module without extension.
std::string module_of(const std::filesystem::path& file);

/// To each module those that it includes, itself left out. An include is looked for in framework/,
/// in tests/ and beside the file.
using Includes = std::map<std::string, std::set<std::string>>;
Includes module_includes(const Files& sources);

/// Sets of modules of which each reaches each other by includes (strongly connected components,
/// Tarjan 1972), those of one module left out.
std::vector<std::vector<std::string>> cycles(const Includes& includes);

} // namespace rigor::layout
