// SPDX-License-Identifier: MIT
// The walls around one program, put up from inside in the only order in which that works.
#pragma once

#include "sandbox/main/options.hpp"

namespace rigor::confine {

/// Puts up all walls that the options name and then becomes the program. A wall that cannot be put
/// up ends this process.
[[noreturn]] void become_program(const Options& options);

/// Changes to another user and group, which have no privileges, and leaves all other groups.
void change_user(unsigned user);

/// Gives up all capabilities, forever.
void drop_capabilities();

} // namespace rigor::confine
