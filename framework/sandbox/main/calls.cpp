// SPDX-License-Identifier: MIT
// Says which system calls a worker and a compiler may make. A worker is a statically linked program
// that computes and prints. So it may make only the few calls that such a program and its C library
// make, and no call that opens files, starts programs or finds out about other processes. A
// compiler opens files and starts an assembler and a linker, so no short list has all its calls. It
// may make all calls except those that no compiler needs, and Landlock and namespaces limit which
// files it can use.
#include "sandbox/main/calls.hpp"

#include <fcntl.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/syscall.h>

namespace rigor::confine {

namespace {

using enum Verdict;

constexpr Condition never_executable = {Condition::lacks_bits, 2, PROT_EXEC};

constexpr Rule worker_table[] = {
    // Communication with the grader: the worker waits on words in shared memory (futex) and prints
    // to a pipe. All descriptors are inherited; no call here makes a new one.
    {SYS_futex, allowed},
    {SYS_read, allowed},
    {SYS_write, allowed},
    {SYS_readv, allowed},
    {SYS_writev, allowed},
    {SYS_lseek, allowed},
    {SYS_fstat, allowed},
    {SYS_close, allowed},

    // Memory: the heap, and the memory shared with the grader. It is never executable.
    {SYS_brk, allowed},
    {SYS_mmap, allowed, never_executable},
    {SYS_mprotect, allowed, never_executable},
    {SYS_munmap, allowed},
    {SYS_mremap, allowed},
    {SYS_madvise, allowed},

    // Start of the C library.
    {SYS_set_tid_address, allowed},
    {SYS_set_robust_list, allowed},
    {SYS_rseq, allowed},
    {SYS_getrandom, allowed},
    {SYS_uname, allowed},
    // Argument 2, the new limits, must be null: a worker may read limits, but not set them.
    {SYS_prlimit64, allowed, {Condition::is_null, 2}, declined},
#ifdef SYS_arch_prctl
    {SYS_arch_prctl, allowed}, // sets the register for thread-local variables
#endif
#ifdef SYS_getrlimit
    {SYS_getrlimit, allowed},
#endif

    // Clocks and waiting.
    {SYS_clock_gettime, allowed},
    {SYS_clock_getres, allowed},
    {SYS_clock_nanosleep, allowed},
    {SYS_nanosleep, allowed},
    {SYS_gettimeofday, allowed},
    {SYS_times, allowed},
    {SYS_getrusage, allowed},
    {SYS_restart_syscall, allowed},
    {SYS_sched_yield, allowed},
    {SYS_getcpu, allowed},
    {SYS_sysinfo, allowed},           // qsort asks for the size of the memory
    {SYS_sched_getaffinity, allowed}, // malloc asks for the number of processors
#ifdef SYS_time
    {SYS_time, allowed},
#endif

    // The worker's handling of signals, and its end.
    {SYS_rt_sigaction, allowed},
    {SYS_rt_sigprocmask, allowed},
    {SYS_rt_sigreturn, allowed},
    {SYS_sigaltstack, allowed},
    {SYS_exit, allowed},
    {SYS_exit_group, allowed},

    // The ids of the worker's process, thread, user and group.
    {SYS_getpid, allowed},
    {SYS_gettid, allowed},
    {SYS_getuid, allowed},
    {SYS_geteuid, allowed},
    {SYS_getgid, allowed},
    {SYS_getegid, allowed},

    // Calls that the C library tries by itself and can do without: it asks for the kind of the
    // output and the path of the program, and gives names to memory areas.
    {SYS_ioctl, declined},
    {SYS_fcntl, declined},
    {SYS_newfstatat, declined},
    {SYS_readlinkat, declined},
    {SYS_prctl, declined},
    {SYS_setrlimit, declined},
#ifdef SYS_readlink
    {SYS_readlink, declined},
#endif
};

// The calls that no compiler needs.
constexpr int never_by_a_compiler[] = {
    // The network.
    SYS_socket, SYS_connect, SYS_bind, SYS_listen, SYS_accept, SYS_accept4, SYS_sendto,

    // Other processes.
    SYS_ptrace, SYS_process_vm_readv, SYS_process_vm_writev, SYS_process_madvise, SYS_pidfd_getfd,
    SYS_kcmp,

    // Namespaces and mounts.
    SYS_unshare, SYS_setns, SYS_mount, SYS_umount2, SYS_pivot_root, SYS_chroot, SYS_open_tree,
    SYS_move_mount, SYS_fsopen, SYS_fsmount, SYS_fspick, SYS_mount_setattr,

    // Parts of the kernel in which errors were found again and again.
    SYS_bpf, SYS_perf_event_open, SYS_userfaultfd, SYS_io_uring_setup, SYS_io_uring_enter,
    SYS_io_uring_register, SYS_keyctl, SYS_add_key, SYS_request_key, SYS_open_by_handle_at,

    // Memory and queues that outlive a process.
    SYS_shmget, SYS_msgget, SYS_semget, SYS_mq_open,

    // Settings of the whole machine.
    SYS_init_module, SYS_finit_module, SYS_delete_module, SYS_kexec_load, SYS_reboot, SYS_swapon,
    SYS_swapoff, SYS_quotactl, SYS_acct, SYS_settimeofday, SYS_clock_settime, SYS_adjtimex,
    SYS_sethostname, SYS_setdomainname, SYS_syslog, SYS_vhangup, SYS_personality};

} // namespace

std::vector<Rule> worker_rules(const OwnNumbers& own, bool grader_allows_start)
{
    std::vector<Rule> rules(std::begin(worker_table), std::end(worker_table));
    // abort() and raise() send a signal to their own process.
    rules.push_back({SYS_tgkill, allowed, {Condition::equals, 0, own.process}});
    // The launcher needs two more calls to start the program, sendmsg and execveat. Both name a
    // descriptor that is closed when the program starts, so the program cannot make these calls.
    // But an execveat with an absolute path ignores the descriptor. Therefore the grader allows
    // only the first execveat, or else Landlock allows no other program to be started.
    rules.push_back({SYS_sendmsg, allowed, {Condition::equals, 0, own.report}});
    if (!grader_allows_start)
        rules.push_back({SYS_execveat, allowed, {Condition::equals, 0, own.program}});
    return rules;
}

std::vector<Rule> compiler_rules()
{
    std::vector<Rule> rules;
    for (const int call : never_by_a_compiler)
        rules.push_back({call, refused});
    // A compiler may start processes, but must not make user namespaces. The flags of clone3 are in
    // memory, where no filter can see them. So clone3 fails as on a kernel that lacks it, and the C
    // library calls clone instead.
    rules.push_back({SYS_clone, allowed, {Condition::lacks_bits, 0, CLONE_NEWUSER}});
    rules.push_back({SYS_clone3, missing});
    return rules;
}

} // namespace rigor::confine
