// SPDX-License-Identifier: MIT
// Namespaces: the program sees no process, network or file system but its own.
#pragma once

#include "sandbox/main/landlock.hpp"

#include <vector>

namespace rigor::confine {

/// A path that the program may use.
struct OpenPath {
    const char* name;
    int descriptor; // opened with O_PATH
    Access access;
};

/// Gives this process and its children namespaces of their own for mounts, network, System V IPC
/// and the host name; its later children also share a new process namespace. With `user_namespace`
/// there is a user namespace around them, which needs no privilege.
void enter_namespaces(bool user_namespace);

/// Makes a root folder that has only these paths, and moves there. The paths are read-only, except
/// those that may be written. `enter_namespaces` must have been called before; otherwise, if this
/// process runs as root, the new root would hide /tmp from the whole machine.
void enter_empty_root(const std::vector<OpenPath>& paths);

} // namespace rigor::confine
