// SPDX-License-Identifier: MIT
// Landlock, a part of Linux: a process gives up all access to files except below some paths,
// forever. The process needs no privilege for this.
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

/// Gives up access to all files but the granted ones, and to TCP ports. The process also can no
/// longer send signals, or connect by abstract sockets, to other processes than those that it
/// starts later. An older Landlock restricts only a part of this. Descriptors that are open already
/// stay as they are.
void restrict_files(const std::vector<Grant>& grants);

} // namespace rigor::confine
