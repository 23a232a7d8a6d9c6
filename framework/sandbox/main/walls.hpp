// SPDX-License-Identifier: MIT
// The walls (parts of the sandbox) around one program, put up from inside in the only order in
// which that works.
#pragma once

#include "sandbox/main/options.hpp"

namespace rigor::confine {

/// Puts up all walls (parts of the sandbox) that the options name and then becomes the program. If
/// a wall cannot be put up, this process ends.
[[noreturn]] void become_program(const Options& options);

/// Changes to another user and group, which have no privileges, and leaves all other groups.
void change_user(unsigned user);

/// Gives up all capabilities, forever.
void drop_capabilities();

} // namespace rigor::confine
