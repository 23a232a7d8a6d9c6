// SPDX-License-Identifier: MIT
// A forked process becomes the owner of the folder, makes the file, and ends with the number of the
// error.
#include "grading/machine/disk_room.hpp"

#include "sandbox/descriptor.hpp"

#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <random>
#include <stdexcept>
#include <string>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

namespace rigor {

namespace {

// Calls the kernel itself: the functions of the C library would wait for threads that the fork has
// not copied.
bool become(const struct stat& owner)
{
    if (owner.st_uid == geteuid()) return true;
    return syscall(SYS_setgroups, 0, nullptr) == 0 &&
           syscall(SYS_setresgid, owner.st_gid, owner.st_gid, owner.st_gid) == 0 &&
           syscall(SYS_setresuid, owner.st_uid, owner.st_uid, owner.st_uid) == 0;
}

// Gives a file this size, so that the disk keeps room for it. @return 0 or the error
int fill(int file, std::uint64_t size)
{
    int error;
    while ((error = posix_fallocate(file, 0, static_cast<off_t>(size))) == EINTR) {
    }
    // Some file systems tell only at the end.
    return close(file) != 0 && error == 0 ? errno : error;
}

// @return 0 or the error
int make_and_remove(int folder, const char* name, std::uint64_t size)
{
    const int file = openat(folder, name, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
    if (file < 0) return errno;
    const int error = fill(file, size);
    unlinkat(folder, name, 0);
    return error;
}

} // namespace

void require_room(const std::filesystem::path& folder, std::uint64_t size)
{
    const Descriptor place(open(folder.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC), folder.c_str());
    struct stat owner = {};
    const std::string name = fmt::format("room.{:x}", std::random_device{}());
    if (fstat(place, &owner) != 0) owner.st_uid = geteuid();
    const pid_t child = fork();
    if (child == 0) {
        signal(SIGXFSZ, SIG_IGN); // a limit on the size of files is an error here
        _exit(become(owner) ? make_and_remove(place, name.c_str(), size) : EPERM);
    }
    int state = 0;
    while (child > 0 && waitpid(child, &state, 0) < 0 && errno == EINTR) {
    }
    const int error = child < 0 ? errno : WIFEXITED(state) ? WEXITSTATUS(state) : EINTR;
    if (error != 0)
        throw std::runtime_error(
            fmt::format("{}: expected room for a file of {} MB, found none: {}", folder.string(),
                        size >> 20, std::strerror(error)));
}

} // namespace rigor
