// SPDX-License-Identifier: MIT
#include "sandbox/blocked_calls.hpp"

#include <algorithm>
#include <initializer_list>
#include <sys/syscall.h>

namespace rigor {

namespace {

struct Purpose {
    const char* words;
    std::initializer_list<int> calls;
};

const Purpose purposes[] = {
    {"open a network socket",
     {SYS_socket, SYS_socketpair, SYS_connect, SYS_bind, SYS_listen, SYS_accept, SYS_accept4,
      SYS_sendto, SYS_recvfrom, SYS_sendmsg, SYS_recvmsg}},
    {"open a file",
     {SYS_openat, SYS_openat2,
#ifdef SYS_open
      SYS_open, SYS_creat,
#endif
      SYS_open_by_handle_at}},
    {"start another program", {SYS_execve, SYS_execveat}},
    {"start a thread or another process",
     {SYS_clone, SYS_clone3,
#ifdef SYS_fork
      SYS_fork, SYS_vfork
#endif
     }},
    {"look into another process",
     {SYS_ptrace, SYS_process_vm_readv, SYS_process_vm_writev, SYS_process_madvise, SYS_pidfd_open,
      SYS_pidfd_getfd, SYS_kcmp}},
    {"ask which process started it", {SYS_getppid}},
    {"ask for signals by a clock",
     {
         SYS_timer_create,
         SYS_setitimer,
         SYS_timerfd_create,
#ifdef SYS_alarm
         SYS_alarm,
#endif
     }},
    {"change the time", {SYS_clock_settime, SYS_settimeofday, SYS_adjtimex, SYS_clock_adjtime}},
    {"change how it is scheduled",
     {SYS_setpriority, SYS_sched_setscheduler, SYS_sched_setparam, SYS_sched_setattr,
      SYS_sched_setaffinity}},
    {"send a signal to a process",
     {SYS_kill, SYS_tkill, SYS_tgkill, SYS_rt_sigqueueinfo, SYS_rt_tgsigqueueinfo,
      SYS_pidfd_send_signal}},
    {"make a file in memory", {SYS_memfd_create}},
    {"make memory executable", {SYS_mmap, SYS_mprotect, SYS_pkey_mprotect}},
    {"look at files",
     {SYS_statx, SYS_faccessat, SYS_getdents64, SYS_getcwd, SYS_statfs,
#ifdef SYS_stat
      SYS_stat, SYS_lstat, SYS_access,
#endif
      SYS_fstatfs}},
    {"change files",
     {SYS_unlinkat, SYS_renameat2, SYS_mkdirat,  SYS_mknodat,   SYS_symlinkat, SYS_linkat,
      SYS_fchmodat, SYS_fchownat,  SYS_truncate, SYS_ftruncate, SYS_utimensat,
#ifdef SYS_unlink
      SYS_unlink,   SYS_rename,    SYS_renameat, SYS_mkdir,     SYS_rmdir,     SYS_mknod,
      SYS_symlink,  SYS_link,      SYS_chmod,    SYS_chown,
#endif
      SYS_fallocate}},
    {"change mounts or namespaces",
     {SYS_mount, SYS_umount2, SYS_pivot_root, SYS_chroot, SYS_unshare, SYS_setns, SYS_open_tree,
      SYS_move_mount, SYS_fsopen, SYS_fsmount}},
    {"become another user", {SYS_setuid, SYS_setreuid, SYS_setresuid, SYS_setgid, SYS_capset}},
    {"leave its session", {SYS_setsid, SYS_setpgid}},
    {"share memory with other processes", {SYS_shmget, SYS_shmat, SYS_msgget, SYS_semget}},
    {"make a pipe or copy a descriptor",
     {SYS_pipe2, SYS_dup, SYS_dup3,
#ifdef SYS_pipe
      SYS_pipe, SYS_dup2
#endif
     }},
};

} // namespace

std::string words_for_blocked_call(int call)
{
    for (const Purpose& purpose : purposes)
        if (std::find(purpose.calls.begin(), purpose.calls.end(), call) != purpose.calls.end())
            return purpose.words;
    return "make system call " + std::to_string(call) + ", which is not allowed here";
}

} // namespace rigor
