// SPDX-License-Identifier: MIT
// Modules, each made of x.hpp and x.cpp, and the modules that they include.
#pragma once

#include "layout/files.hpp"

#include <map>
#include <set>
#include <string>
#include <vector>

namespace rigor::layout {

/// Path of a module without extension.
std::string module_of(const std::filesystem::path& file);

/// The modules that each module includes, without itself. An include is looked for in framework/,
/// in tests/ and beside the file.
using Includes = std::map<std::string, std::set<std::string>>;
Includes module_includes(const Files& sources);

/// Sets of several modules that all reach each other by includes (strongly connected components,
/// Tarjan 1972).
std::vector<std::vector<std::string>> cycles(const Includes& includes);

} // namespace rigor::layout
