// SPDX-License-Identifier: MIT
// Denies access to files by the system calls of Landlock. Its rights and structures are written out
// here as in linux/landlock.h, since the headers of a Linux distribution are often older than its
// kernel.
#include "sandbox/main/landlock.hpp"

#include "sandbox/main/failure.hpp"

#include <cstdint>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace rigor::confine {

namespace {

constexpr std::uint64_t bit(unsigned n)
{
    return std::uint64_t{1} << n;
}

constexpr std::uint64_t execute = bit(0), write_file = bit(1), read_file = bit(2),
                        read_dir = bit(3);
constexpr std::uint64_t truncate = bit(14), ioctl_on_device = bit(15);
constexpr std::uint64_t make_links_across = bit(13);
// Bits 4 to 12 are the rights to delete and to make files, folders, links, sockets, pipes and
// devices.
constexpr std::uint64_t make_and_delete = bit(13) - bit(4);
constexpr std::uint64_t make_devices = bit(6) | bit(11);
constexpr std::uint64_t on_files = execute | write_file | read_file | truncate | ioctl_on_device;

struct Ruleset {
    std::uint64_t files, network, outside;
};

struct [[gnu::packed]] PathBeneath {
    std::uint64_t allowed;
    std::int32_t parent;
};

constexpr unsigned query_version = 1, path_beneath = 1;

// All rights that this version of Landlock can restrict.
Ruleset everything(int version)
{
    Ruleset all = {bit(13) - 1, 0, 0};
    if (version >= 2) all.files |= make_links_across;
    if (version >= 3) all.files |= truncate;
    if (version >= 5) all.files |= ioctl_on_device;
    if (version >= 4) all.network = bit(0) | bit(1); // to bind and to connect by TCP
    if (version >= 6) all.outside = bit(0) | bit(1); // abstract sockets and signals
    return all;
}

std::uint64_t rights(Access access)
{
    switch (access) {
    case Access::execute:
        return execute | read_file | read_dir;
    case Access::write:
        return read_file | read_dir | write_file | truncate | make_links_across |
               (make_and_delete & ~make_devices);
    case Access::use_device:
        return read_file | write_file | truncate;
    }
    return 0;
}

bool is_folder(int descriptor)
{
    struct stat status = {};
    must(fstat(descriptor, &status), "look at a path");
    return S_ISDIR(status.st_mode);
}

void allow(int ruleset, const Grant& grant, std::uint64_t handled)
{
    const std::uint64_t possible = is_folder(grant.path) ? handled : handled & on_files;
    const PathBeneath rule = {rights(grant.access) & possible, grant.path};
    must(syscall(SYS_landlock_add_rule, ruleset, path_beneath, &rule, 0), "allow a path");
}

} // namespace

int landlock_version()
{
    const long version = syscall(SYS_landlock_create_ruleset, nullptr, 0, query_version);
    return version > 0 ? static_cast<int>(version) : 0;
}

void restrict_files(const std::vector<Grant>& grants)
{
    // An older kernel refuses a structure with fields that it does not know, unless they are 0.
    const Ruleset all = everything(landlock_version());
    const int ruleset = static_cast<int>(must(
        syscall(SYS_landlock_create_ruleset, &all, sizeof all, 0), "create rules of Landlock"));
    for (const Grant& grant : grants)
        allow(ruleset, grant, all.files);
    must(syscall(SYS_landlock_restrict_self, ruleset, 0), "restrict files by Landlock");
    close(ruleset);
}

} // namespace rigor::confine
