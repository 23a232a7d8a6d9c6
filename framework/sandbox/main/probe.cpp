// SPDX-License-Identifier: MIT
// Tries which walls (parts of the sandbox) work. Each wall is really put up, in a child process,
// since it cannot be taken down again. So a wall that exists but does not work is noticed too, such
// as a call that a container forbids.
#include "sandbox/main/probe.hpp"

#include "sandbox/main/landlock.hpp"
#include "sandbox/main/namespaces.hpp"
#include "sandbox/main/seccomp.hpp"
#include "sandbox/main/walls.hpp"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <linux/seccomp.h>
#include <sys/ioctl.h>
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
        const bool has_root = works([] {
            // Copying a mount and protecting the copy needs calls that older kernels lack.
            const char* name = "/dev/null";
            enter_empty_root({{name, open(name, O_PATH | O_CLOEXEC), Access::execute}});
        });
        if (!has_root) _exit(1);
    });
}

// Whether a call that the filter has stopped can go on after all. Without this, no program can be
// started behind a filter that reports the calls it stops. The answer is for a call that does not
// exist, and an older kernel refuses it before it looks for the call.
bool can_continue_calls(int listener)
{
    seccomp_notif_resp answer = {};
    answer.flags = SECCOMP_USER_NOTIF_FLAG_CONTINUE;
    return ioctl(listener, SECCOMP_IOCTL_NOTIF_SEND, &answer) != 0 && errno == ENOENT;
}

bool filter_works(bool notify)
{
    return works([&] {
        drop_capabilities();
        prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
        const int listener = filter_calls({}, Verdict::allowed, notify);
        if (notify && !can_continue_calls(listener)) _exit(1);
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
