// SPDX-License-Identifier: MIT
// Things that a program behind walls may try, by name.
#pragma once

namespace rigor::testing {

/// Tries what `name` says, and prints `done`, or `failed` with the reason.
/// @param about  a path, a process or another word, if the attempt needs one
void attempt(const char* name, const char* about);

} // namespace rigor::testing
