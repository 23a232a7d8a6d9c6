// SPDX-License-Identifier: MIT
// Makes the namespaces and a new root folder. The root is a small file system in memory. It is
// mounted over /tmp, a folder that exists everywhere. Copies of the mounts below each path are
// taken first, because the new root may hide them, and are attached below the new root afterwards.
// A process without capabilities and without descriptors of folders outside cannot leave such a
// root.
#include "sandbox/main/namespaces.hpp"

#include "sandbox/main/failure.hpp"

#include <cstring>
#include <fcntl.h>
#include <sched.h>
#include <string>
#include <sys/mount.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace rigor::confine {

namespace {

void write_file(const char* path, const std::string& text)
{
    const int file = must(open(path, O_WRONLY | O_CLOEXEC), path);
    must(write(file, text.data(), text.size()), path);
    close(file);
}

// The user keeps its user id and group id, and gets every capability inside the new namespaces.
void map_own_user(uid_t user, gid_t group)
{
    const auto itself = [](unsigned id) {
        return std::to_string(id) + " " + std::to_string(id) + " 1";
    };
    write_file("/proc/self/setgroups", "deny");
    write_file("/proc/self/uid_map", itself(user));
    write_file("/proc/self/gid_map", itself(group));
}

void make_folders_above(const std::string& path)
{
    for (std::size_t slash = path.find('/'); slash != std::string::npos;
         slash = path.find('/', slash + 1))
        mkdir(path.substr(0, slash).c_str(), 0755); // may fail, since most of these folders exist
}

void set_attributes(int mount, unsigned flags, bool writable)
{
    mount_attr attributes = {};
    attributes.attr_set = MOUNT_ATTR_NOSUID | (writable ? 0 : MOUNT_ATTR_RDONLY);
    must(mount_setattr(mount, "", AT_EMPTY_PATH | flags, &attributes, sizeof attributes),
         "protect a mount");
}

struct Copy {
    int mount;
    bool is_folder;
};

Copy copy_of(const OpenPath& path)
{
    struct stat status = {};
    must(fstat(path.descriptor, &status), path.name);
    const unsigned flags = OPEN_TREE_CLONE | OPEN_TREE_CLOEXEC | AT_EMPTY_PATH | AT_RECURSIVE;
    const int mount = must(open_tree(path.descriptor, "", flags), path.name);
    set_attributes(mount, AT_RECURSIVE, path.access != Access::execute);
    return {mount, S_ISDIR(status.st_mode)};
}

// `name` is relative to the new root, which is the working directory.
void attach(const Copy& copy, const std::string& name)
{
    make_folders_above(name);
    if (copy.is_folder)
        mkdir(name.c_str(), 0755);
    else
        close(open(name.c_str(), O_CREAT | O_WRONLY | O_CLOEXEC, 0644));
    must(move_mount(copy.mount, "", AT_FDCWD, name.c_str(), MOVE_MOUNT_F_EMPTY_PATH),
         "attach a path");
    close(copy.mount);
}

} // namespace

void enter_namespaces(bool user_namespace)
{
    const uid_t user = geteuid();
    const gid_t group = getegid();
    must(unshare(CLONE_NEWNS | CLONE_NEWPID | CLONE_NEWNET | CLONE_NEWIPC | CLONE_NEWUTS |
                 (user_namespace ? CLONE_NEWUSER : 0)),
         "enter new namespaces");
    if (user_namespace) map_own_user(user, group);
    must(mount(nullptr, "/", nullptr, MS_REC | MS_PRIVATE, nullptr), "separate the mounts");
}

void enter_empty_root(const std::vector<OpenPath>& paths)
{
    std::vector<Copy> copies;
    copies.reserve(paths.size());
    for (const OpenPath& path : paths)
        copies.push_back(copy_of(path));
    const char* place = "/tmp";
    must(mount("root", place, "tmpfs", MS_NOSUID | MS_NODEV, "size=64k,mode=755"), "mount a root");
    must(chdir(place), "enter the new root");
    for (std::size_t i = 0; i < paths.size(); ++i)
        attach(copies[i], paths[i].name + 1);
    must(mount(nullptr, ".", nullptr, MS_REMOUNT | MS_BIND | MS_RDONLY | MS_NOSUID | MS_NODEV,
               nullptr),
         "protect the new root");
    must(chroot("."), "enter the new root");
}

} // namespace rigor::confine
