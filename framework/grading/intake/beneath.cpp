// SPDX-License-Identifier: MIT
// Walks from folder to folder. Each step opens one part of the name inside the folder that is open
// already, and fails if this part is a link.
#include "grading/intake/beneath.hpp"

#include <algorithm>
#include <cerrno>
#include <dirent.h>
#include <fcntl.h>
#include <memory>
#include <system_error>
#include <unistd.h>

namespace rigor {

namespace fs = std::filesystem;

namespace {

constexpr int one_folder = O_PATH | O_DIRECTORY | O_CLOEXEC;

// The open folder that the last part of `name` lies in.
Descriptor opened_parent(const fs::path& folder, const fs::path& name)
{
    Descriptor parent(open(folder.empty() ? "." : folder.c_str(), one_folder), folder.c_str());
    for (const fs::path& part : name.parent_path())
        parent = Descriptor(openat(parent, part.c_str(), one_folder | O_NOFOLLOW), name.c_str());
    return parent;
}

std::string last_part(const fs::path& name)
{
    return name.has_filename() ? name.filename().string() : ".";
}

} // namespace

Descriptor opened_beneath(const fs::path& folder, const fs::path& name, int flags)
{
    const Descriptor parent = opened_parent(folder, name);
    return {openat(parent, last_part(name).c_str(), flags | O_NOFOLLOW | O_CLOEXEC), name.c_str()};
}

struct stat status_beneath(const fs::path& folder, const fs::path& name)
{
    const Descriptor parent = opened_parent(folder, name);
    struct stat status = {};
    if (fstatat(parent, last_part(name).c_str(), &status, AT_SYMLINK_NOFOLLOW) != 0)
        throw std::system_error(errno, std::generic_category(), name.string());
    return status;
}

std::vector<FolderEntry> entries_beneath(const fs::path& folder, const fs::path& name,
                                         std::size_t most)
{
    const Descriptor opened = opened_beneath(folder, name, O_RDONLY | O_DIRECTORY);
    const auto fail = [&] {
        throw std::system_error(errno, std::generic_category(), name.string());
    };
    const int listed = fcntl(opened, F_DUPFD_CLOEXEC, 0); // `closedir` closes this one
    DIR* const stream = listed < 0 ? nullptr : fdopendir(listed);
    if (stream == nullptr) fail();
    const std::unique_ptr<DIR, int (*)(DIR*)> closes_itself(stream, closedir);
    std::vector<FolderEntry> entries;
    errno = 0;
    for (const dirent* entry; entries.size() <= most && (entry = readdir(stream)) != nullptr;) {
        const std::string called = entry->d_name;
        if (called == "." || called == "..") continue;
        struct stat status = {};
        const bool is_there = fstatat(opened, called.c_str(), &status, AT_SYMLINK_NOFOLLOW) == 0;
        entries.push_back({called, is_there ? status.st_mode : 0});
        errno = 0;
    }
    if (errno != 0) fail();
    std::sort(entries.begin(), entries.end(),
              [](const FolderEntry& a, const FolderEntry& b) { return a.name < b.name; });
    return entries;
}

} // namespace rigor
