// SPDX-License-Identifier: MIT
// Finds out which walls (parts of the sandbox) this machine and this user allow, by putting up
// each.
#pragma once

#include "sandbox/main/options.hpp"

namespace rigor::confine {

/// Prints one line of words: `namespaces=plain user seccomp=notify landlock`. Parts of the sandbox
/// that cannot be put up are left out.
void probe(const Options& options);

} // namespace rigor::confine
