// SPDX-License-Identifier: MIT
// Things that a program behind walls may try, by name.
#pragma once

namespace rigor::testing {

/// Tries it and prints `done`, or `failed` with the reason. The second argument is a path or a
/// process number, if one is needed.
void attempt(const char* name, const char* about);

} // namespace rigor::testing
