// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <sys/mount.h>
#include <unistd.h>

namespace rigor::testing {

/// A file system in memory, which is mounted while this object lives, if this user may mount one.
class MemoryDisk {
public:
    /// @param options  such as `size=48k`, or `nr_inodes=10` for the number of files
    MemoryDisk(const std::filesystem::path& place, const std::string& options,
               unsigned long flags = 0)
        : place_(place)
    {
        std::filesystem::create_directories(place);
        is_mounted_ =
            geteuid() == 0 && mount("tmpfs", place.c_str(), "tmpfs", flags, options.c_str()) == 0;
    }
    ~MemoryDisk()
    {
        if (is_mounted_) umount2(place_.c_str(), MNT_DETACH);
    }
    MemoryDisk(const MemoryDisk&) = delete;
    MemoryDisk& operator=(const MemoryDisk&) = delete;

    bool is_mounted() const { return is_mounted_; }
    /// @return whether the disk has other options now; it may have too many files for them
    bool remount(const std::string& options) const
    {
        return mount("tmpfs", place_.c_str(), "tmpfs", MS_REMOUNT, options.c_str()) == 0;
    }

private:
    std::filesystem::path place_;
    bool is_mounted_ = false;
};

} // namespace rigor::testing
