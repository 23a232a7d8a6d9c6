// SPDX-License-Identifier: MIT
#pragma once

#include <csignal>

namespace rigor {

/// Makes this process no longer ignore SIGCHLD, as it does if whoever started it ignored the
/// signal. While a process ignores SIGCHLD, it cannot find out how its children ended, and neither
/// can they. Whoever starts a child process and waits for its end calls this function first.
inline void notice_children()
{
    struct sigaction now = {};
    if (sigaction(SIGCHLD, nullptr, &now) == 0 && now.sa_handler == SIG_IGN)
        std::signal(SIGCHLD, SIG_DFL);
}

} // namespace rigor
