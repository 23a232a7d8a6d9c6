// SPDX-License-Identifier: MIT
// What the launcher, which starts a program in the sandbox, reports to the grader on the socket
// between them. Before the program starts, the launcher reports an error, or it reports that the
// sandbox is up. The listener of blocked calls is attached to this second kind of report. The
// socket is closed when the program starts, so no report can come from the program.
#pragma once

namespace rigor {

struct Report {
    int error;        // errno of what failed; 0 if the sandbox is up
    char action[252]; // what failed: "open /path/worker"
};

/// The exit status of the launcher if it could not start the program.
inline constexpr int not_started = 125;

} // namespace rigor
