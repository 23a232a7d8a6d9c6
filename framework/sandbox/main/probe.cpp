// SPDX-License-Identifier: MIT
// Tries which walls (parts of the sandbox) work. Each wall is really put up, in a child process,
// since it cannot be taken down again. So a wall that exists but does not work is noticed too, such
// as a call that a container forbids.
#include "sandbox/main/probe.hpp"

#include "sandbox/main/landlock.hpp"
#include "sandbox/main/namespaces.hpp"
#include "sandbox/main/seccomp.hpp"
#include "sandbox/main/walls.hpp"

#include <cstring>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace rigor::confine {

namespace {

/// Whether a wall (a part of the sandbox) can be put up. This is tried in a child process.
template <class Wall> bool works(Wall put_up)
{
    const pid_t child = fork();
    if (child == 0) {
        put_up();
        _exit(0);
    }
    int status = -1;
    waitpid(child, &status, 0);
    return child > 0 && status == 0;
}

bool namespaces_work(bool user_namespace)
{
    return works([&] {
        enter_namespaces(user_namespace);
        if (!works([] { enter_empty_root({}); })) _exit(1);
    });
}

bool filter_works(bool notify)
{
    return works([&] {
        drop_capabilities();
        prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
        filter_calls({}, Verdict::allowed, notify);
    });
}

} // namespace

void probe(const Options& options)
{
    std::string words;
    if (geteuid() == 0 && namespaces_work(false))
        words += "namespaces=plain ";
    else if (namespaces_work(true))
        words += "namespaces=user ";
    if (geteuid() == 0 && options.user != 0 && works([&] { change_user(options.user); }))
        words += "user ";
    if (filter_works(true))
        words += "seccomp=notify ";
    else if (filter_works(false))
        words += "seccomp=kill ";
    if (landlock_version() > 0 && works([] {
            prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
            restrict_files({});
        }))
        words += "landlock ";
    words += '\n';
    if (write(STDOUT_FILENO, words.data(), words.size()) < 0) _exit(1);
}

} // namespace rigor::confine
