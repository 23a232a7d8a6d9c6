// SPDX-License-Identifier: MIT
// The command line of the launcher. Only the grader writes it. To run a program
// (`sandbox/confined.cpp`), it is, for example:
//
//     confine --report=4 --profile=worker --namespaces=plain --user=1879048200 --seccomp=notify
//             --landlock --read=FOLDER --write=FOLDER --folder=FOLDER
//             --limit=address_space:2147483648 -- PROGRAM ARGUMENT...
//
// To find out which walls are possible (`sandbox/tier.cpp`):
//
//     confine --probe --user=1879048200
#pragma once

#include <cstdint>
#include <string>
#include <sys/resource.h>
#include <vector>

namespace rigor::confine {

struct ResourceLimit {
    __rlimit_resource resource;
    std::uint64_t most;
};

struct Options {
    bool probe = false; // only find out which parts of the sandbox are possible
    int report = -1;    // descriptor of the socket to the grader; the program gets all lower ones
    bool is_compiler = false; // whether the profile is `compiler`; otherwise it is `worker`
    // Whether to make new namespaces: of mounts, processes, network, IPC and host name.
    bool namespaces = false;
    bool user_namespace = false; // whether the namespaces need a user namespace around them
    unsigned user = 0;           // the program's user id and group id; 0 to keep the present ones
    bool seccomp = false;
    /// Whether a blocked call waits for the grader, who learns which call it is. Otherwise a
    /// blocked call kills the process.
    bool notify = false;
    bool landlock = false;
    std::vector<const char*> readable, writable; // paths in addition to those of the profile
    const char* folder = "/";                    // the program's working directory
    std::vector<ResourceLimit> limits;
    char** program = nullptr; // the program's path and arguments
};

/// @return the options; a malformed command line ends this process
Options parse(char** arguments);

} // namespace rigor::confine
