// SPDX-License-Identifier: MIT
// Finds out which walls (parts of the sandbox) this machine and this user allow, by putting up
// each.
#pragma once

#include "sandbox/main/options.hpp"

namespace rigor::confine {

/// Prints one line of words, one for each part of the sandbox that can be put up:
/// `namespaces=plain` (or `=user`: inside a user namespace), `user` (the program gets a user id of
/// its own), `seccomp=notify` (or `=kill`: blocked calls are not named) and `landlock`.
void probe(const Options& options);

} // namespace rigor::confine
