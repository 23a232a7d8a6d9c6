// SPDX-License-Identifier: MIT
#include "attempts.hpp"

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <dirent.h>
#include <fcntl.h>
#include <string>
#include <sys/mman.h>
#include <sys/mount.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/shm.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <sys/wait.h>
#include <unistd.h>

namespace rigor::testing {

namespace {

int process(const char* about)
{
    return std::atoi(about);
}

bool read_file(const char* path)
{
    char byte;
    const int file = open(path, O_RDONLY);
    return file >= 0 && read(file, &byte, 1) >= 0;
}

bool write_file(const char* path)
{
    const int file = open(path, O_WRONLY | O_CREAT, 0644);
    return file >= 0 && write(file, "x", 1) == 1;
}

bool list_folder(const char* path)
{
    DIR* folder = opendir(path);
    return folder && readdir(folder);
}

bool execute(const char* path)
{
    char* const arguments[] = {const_cast<char*>(path), nullptr};
    execv(path, arguments);
    return false;
}

// Uses the system call by which the launcher starts a program, with each descriptor that the
// launcher may have used.
bool execute_like_the_launcher(const char* path)
{
    char* const arguments[] = {const_cast<char*>(path), nullptr};
    for (int descriptor = 0; descriptor < 10; ++descriptor)
        syscall(SYS_execveat, descriptor, path, arguments, nullptr, AT_EMPTY_PATH);
    return false;
}

bool execute_from_memory(const char* path)
{
    const int program = memfd_create("program", 0);
    if (program < 0) return false;
    const int file = open(path, O_RDONLY);
    char buffer[65536];
    for (ssize_t n; (n = read(file, buffer, sizeof buffer)) > 0;)
        if (write(program, buffer, n) != n) return false;
    char* const arguments[] = {const_cast<char*>("memory"), nullptr};
    fexecve(program, arguments, environ);
    return false;
}

// Twenty daemons, each in a session of its own and without a living parent. Each parent waits until
// its daemon, which first prints a line, kills this parent.
bool leave_daemons(const char*)
{
    for (int i = 0; i < 20; ++i) {
        const pid_t child = fork();
        if (child < 0) return false;
        if (child > 0) continue;
        setsid();
        const pid_t daemon = fork();
        if (daemon < 0) _exit(0);
        while (daemon > 0)
            pause();
        setsid();
        std::printf("daemon %d\n", getpid());
        std::fflush(stdout);
        kill(getppid(), SIGKILL);
        signal(SIGTERM, SIG_IGN);
        for (;;)
            pause();
    }
    while (wait(nullptr) > 0) {
    }
    return true;
}

bool start_a_process(const char*)
{
    const pid_t child = fork();
    if (child == 0) _exit(0);
    return child > 0 && waitpid(child, nullptr, 0) == child;
}

bool read_memory_of(const char* about)
{
    char byte = 0;
    iovec here = {&byte, 1}, there = {&byte, 1};
    // The address need not exist in that process: only the permission counts.
    return process_vm_readv(process(about), &here, 1, &there, 1, 0) == 1 || errno == EFAULT;
}

bool map_executable(const char*)
{
    return mmap(nullptr, 4096, PROT_READ | PROT_WRITE | PROT_EXEC, MAP_PRIVATE | MAP_ANONYMOUS, -1,
                0) != MAP_FAILED;
}

bool make_executable(const char*)
{
    void* page = mmap(nullptr, 4096, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    return mprotect(page, 4096, PROT_READ | PROT_EXEC) == 0;
}

bool fill_disk(const char* path)
{
    signal(SIGXFSZ, SIG_IGN);
    const int file = open(path, O_WRONLY | O_CREAT, 0644);
    if (file < 0) return false;
    for (int i = 0; i < 64; ++i) {
        static char block[1 << 20];
        if (write(file, block, sizeof block) != sizeof block) return false;
    }
    return true;
}

bool raise_a_limit(const char*)
{
    rlimit limit = {};
    getrlimit(RLIMIT_CORE, &limit);
    limit.rlim_cur = limit.rlim_max = 1 << 20;
    return setrlimit(RLIMIT_CORE, &limit) == 0;
}

// System calls by the interface for 32-bit programs, where the numbers mean other calls.
bool use_old_interface(const char*)
{
#if defined(__x86_64__)
    long result = 20; // getpid there
    asm volatile("int $0x80" : "+a"(result) : : "memory");
    return result > 0;
#else
    return syscall(SYS_socket, AF_INET, SOCK_STREAM, 0) >= 0;
#endif
}

// System calls by the interface for 64-bit programs with short pointers.
bool use_second_interface(const char*)
{
    syscall(0x40000000 | SYS_socket, AF_INET, SOCK_STREAM, 0);
    return true;
}

// A system call by its number, with arguments that no call accepts.
bool call_by_number(const char* about)
{
    syscall(process(about), -1, -1, -1, -1, -1, -1);
    return true;
}

bool print_user(const char*)
{
    std::printf("%u ", getuid());
    return true;
}

bool flood(const char*)
{
    for (;;)
        std::puts("a line that is repeated without end");
}

bool loop(const char*)
{
    for (;;)
        asm volatile("");
}

struct Attempt {
    const char* name;
    bool (*run)(const char* about);
};

const Attempt attempts[] = {
    {"socket", [](const char*) { return socket(AF_INET, SOCK_STREAM, 0) >= 0; }},
    {"read", read_file},
    {"write", write_file},
    {"list", list_folder},
    {"execute", execute},
    {"execute like the launcher", execute_like_the_launcher},
    {"execute from memory", execute_from_memory},
    {"fork", start_a_process},
    {"daemons", leave_daemons},
    {"ptrace", [](const char* about) { return ptrace(PTRACE_SEIZE, process(about), 0, 0) == 0; }},
    {"read memory", read_memory_of},
    {"signal", [](const char* about) { return kill(process(about), 0) == 0; }},
    {"executable memory", map_executable},
    {"make executable", make_executable},
    {"shared memory", [](const char*) { return shmget(IPC_PRIVATE, 4096, IPC_CREAT | 0600) >= 0; }},
    {"mount", [](const char* path) { return mount("none", path, "tmpfs", 0, nullptr) == 0; }},
    {"own user", [](const char*) { return setuid(0) == 0 && getuid() == 0; }},
    {"look",
     [](const char* path) {
         struct stat status;
         return lstat(path, &status) == 0;
     }},
    {"make a folder", [](const char* path) { return mkdir(path, 0755) == 0; }},
    {"raise a limit", raise_a_limit},
    {"fill the disk", fill_disk},
    {"handle SIGSYS",
     [](const char*) {
         signal(SIGSYS, [](int) { std::puts("handled"); });
         return socket(AF_INET, SOCK_STREAM, 0) >= 0;
     }},
    {"old interface", use_old_interface},
    {"second interface", use_second_interface},
    {"call", call_by_number},
    {"user", print_user},
    {"abort", [](const char*) -> bool { std::abort(); }},
    {"crash", [](const char*) -> bool { return *static_cast<volatile int*>(nullptr) == 1; }},
    {"stop", [](const char*) { return raise(SIGSTOP) == 0; }},
    {"exit", [](const char*) -> bool { _exit(3); }},
    {"flood", flood},
    {"loop", loop},
};

} // namespace

void attempt(const char* name, const char* about)
{
    for (const Attempt& attempt : attempts) {
        if (std::strcmp(attempt.name, name) != 0) continue;
        if (attempt.run(about))
            std::puts("done");
        else
            std::printf("failed: %s\n", std::strerror(errno));
        return;
    }
    std::printf("there is no attempt '%s'\n", name);
}

} // namespace rigor::testing
