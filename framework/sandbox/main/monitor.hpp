// SPDX-License-Identifier: MIT
// The monitor is the process that stays outside the sandbox while the program runs inside. Nothing
// that the program starts outlives the monitor.
#pragma once

#include <sys/types.h>

namespace rigor::confine {

/// The limit on the size of core files with which no core file is made. With a limit of 0 bytes,
/// the kernel would still hand a core over to a program that collects core files. With a limit of
/// 1 byte it does not.
inline constexpr unsigned no_core = 1; // [bytes]

/// Makes this process the monitor of all processes that it starts from now on. Their descendants
/// whose parents have died become its children. If the grader dies, this process gets SIGTERM.
void become_monitor();

/// To be called in a child of the monitor: unblocks the signals that the monitor waits for.
void leave_monitor();

/// Waits until the program ends or until SIGTERM comes, ends every descendant that is left, and
/// then ends this process: in the way in which the program ended, or after SIGTERM with exit
/// status 0. If the program is stopped, this process stops too. `init` is the first process of the
/// program's process namespace, 0 if it has none.
[[noreturn]] void watch(pid_t program, pid_t init);

} // namespace rigor::confine
