// SPDX-License-Identifier: MIT
// The list of commands. Each command has a file of its own.
#pragma once

#include "cli/command.hpp"

#include <span>

namespace rigor {

struct CommandEntry {
    const char* name;
    const char* summary;
    Action (*declare)(Options& options);
};

std::span<const CommandEntry> commands();

} // namespace rigor
