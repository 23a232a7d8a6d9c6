// SPDX-License-Identifier: MIT
// Landlock: a process gives up all access to files except below some paths, forever. It needs no
// privilege.
#pragma once

#include <vector>

namespace rigor::confine {

/// The version of Landlock in this kernel; 0 if there is none.
int landlock_version();

/// What may be done with the files below a path.
enum class Access {
    execute,   // read and start
    write,     // read, write, make and delete, but not start
    use_device // read and write, but not make or delete: /dev/null
};

struct Grant {
    int path; // a descriptor of a file or folder
    Access access;
};

/// Gives up access to all files but these, to the network, and to all processes that do not share
/// this restriction (those that this process starts do), as far as the kernel's version of Landlock
/// covers each. Descriptors that are open already stay as they are.
void restrict_files(const std::vector<Grant>& grants);

} // namespace rigor::confine
