// SPDX-License-Identifier: MIT
// Puts up the sandbox around this process and starts the program in it. The steps that need
// privileges come first: to make a new root folder and to change the user. Then privileges are
// dropped forever, limits are set, and Landlock denies access to files. The filter comes last,
// since it blocks the calls that all of this needed. It is in force before the program's first
// instruction.
#include "sandbox/main/walls.hpp"

#include "sandbox/main/calls.hpp"
#include "sandbox/main/failure.hpp"
#include "sandbox/main/monitor.hpp"
#include "sandbox/main/namespaces.hpp"
#include "sandbox/main/seccomp.hpp"

#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <grp.h>
#include <linux/capability.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace rigor::confine {

namespace {

// The paths of a system in which a compiler, its assembler and its linker have their parts. Paths
// that do not exist are left out. A tree that grades must lie elsewhere (`require_hidden` in
// grading/places.hpp).
struct SystemPath {
    const char* name;
    Access access;
};
constexpr SystemPath compiler_paths[] = {
    {"/usr", Access::execute},
    {"/bin", Access::execute},
    {"/lib", Access::execute},
    {"/lib64", Access::execute},
    {"/etc/alternatives", Access::execute}, // c++ and g++ may be links into this folder
    {"/etc/ld.so.cache", Access::execute},
    {"/dev/null", Access::use_device},
};

OpenPath opened(const char* name, Access access)
{
    const int descriptor = open(name, O_PATH | O_CLOEXEC);
    if (descriptor < 0) fail(std::string("open ") + name);
    return {name, descriptor, access};
}

std::vector<OpenPath> open_paths(const Options& options)
{
    std::vector<OpenPath> paths;
    for (const SystemPath& path : compiler_paths)
        if (options.is_compiler && access(path.name, F_OK) == 0)
            paths.push_back(opened(path.name, path.access));
    for (const char* path : options.readable)
        paths.push_back(opened(path, Access::execute));
    for (const char* path : options.writable)
        paths.push_back(opened(path, Access::write));
    return paths;
}

int open_program(const char* path)
{
    const int program = open(path, O_PATH | O_CLOEXEC);
    if (program < 0) fail(std::string("open ") + path);
    return program;
}

void set_limit(__rlimit_resource resource, std::uint64_t most)
{
    // If the process has a lower hard limit already, that limit stays.
    rlimit now = {};
    must(getrlimit(resource, &now), "read a limit");
    if (now.rlim_max < most) most = now.rlim_max;
    const rlimit both = {most, most};
    must(setrlimit(resource, &both), "set a limit");
}

void set_limits(const Options& options)
{
    for (const ResourceLimit& limit : options.limits)
        set_limit(limit.resource, limit.most);
    for (const auto resource : {RLIMIT_MEMLOCK, RLIMIT_MSGQUEUE, RLIMIT_RTPRIO})
        set_limit(resource, 0);
    set_limit(RLIMIT_CORE, no_core);
}

void restrict_to(const std::vector<OpenPath>& paths, int program)
{
    std::vector<Grant> grants = {{program, Access::execute}};
    for (const OpenPath& path : paths)
        grants.push_back({path.descriptor, path.access});
    restrict_files(grants);
}

// @return the listener of blocked calls; -1 if there is none
int put_filter_in_force(const Options& options, int program)
{
    if (options.is_compiler)
        return filter_calls(compiler_rules(), Verdict::allowed, options.notify);
    const OwnNumbers own = {static_cast<std::uint32_t>(getpid()),
                            static_cast<std::uint32_t>(options.report),
                            static_cast<std::uint32_t>(program)};
    return filter_calls(worker_rules(own, options.notify), Verdict::refused, options.notify);
}

} // namespace

void change_user(unsigned user)
{
    must(setgroups(0, nullptr), "leave the groups");
    must(setresgid(user, user, user), "change the group");
    must(setresuid(user, user, user), "change the user");
}

void drop_capabilities()
{
    // Without this loop, a program that is started as root would get all capabilities again.
    for (int capability = 0; prctl(PR_CAPBSET_READ, capability) >= 0; ++capability)
        prctl(PR_CAPBSET_DROP, capability); // fails if this process has no capabilities
    __user_cap_header_struct header = {_LINUX_CAPABILITY_VERSION_3, 0};
    const __user_cap_data_struct none[2] = {};
    must(syscall(SYS_capset, &header, none), "drop capabilities");
}

void become_program(const Options& options)
{
    setsid(); // a new process group, which can be killed without killing the monitor
    const int program = open_program(options.program[0]);
    const std::vector<OpenPath> paths = open_paths(options);
    if (options.namespaces) enter_empty_root(paths);
    if (options.user != 0) change_user(options.user);
    const bool has_walls = options.namespaces || options.landlock || options.seccomp;
    if (has_walls) drop_capabilities();
    must(chdir(options.folder), "enter the working directory");
    must(prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0), "refuse new privileges");
    // This comes after change_user, because a change of user clears this setting.
    must(prctl(PR_SET_PDEATHSIG, SIGKILL), "end with the monitor");
    set_limits(options);
    if (options.landlock) restrict_to(paths, program);
    const int listener = options.seccomp ? put_filter_in_force(options, program) : -1;
    report_ready(listener);
    syscall(SYS_execveat, program, "", options.program, environ, AT_EMPTY_PATH);
    fail(std::string("start ") + options.program[0]);
}

} // namespace rigor::confine
