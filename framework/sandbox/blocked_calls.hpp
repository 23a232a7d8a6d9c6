// SPDX-License-Identifier: MIT
// Words for system calls that a program in the sandbox must not make.
#pragma once

#include <string>

namespace rigor {

/// What the program tried to do: `open a network socket`.
std::string words_for_blocked_call(int call);

} // namespace rigor
