// SPDX-License-Identifier: MIT
// The list of commands. Each command has a file of its own.
#pragma once

#include "cli/command.hpp"

#include <span>

namespace rigor {

struct CommandEntry {
    const char* name;
    const char* summary;
    Action (*declare)(Options& options) = nullptr; // nullptr: the program `rigor_class` has it
};

/// All commands. Those without a function belong to `rigor_class`: their functions are in
/// cli/instructor/main/main.cpp.
std::span<const CommandEntry> commands();

} // namespace rigor
