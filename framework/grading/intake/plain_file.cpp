// SPDX-License-Identifier: MIT
#include "grading/intake/plain_file.hpp"

#include "grading/intake/beneath.hpp"
#include "grading/intake/refused.hpp"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace rigor {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void refuse_unreadable(int error)
{
    throw Refused(std::string("cannot be read: ") + std::strerror(error));
}

void require_plain(mode_t mode)
{
    if (S_ISREG(mode)) return;
    throw Refused(
        fmt::format("expected a file, found {}", S_ISDIR(mode) ? "a folder" : special_kind(mode)));
}

} // namespace

std::string_view special_kind(mode_t mode)
{
    return S_ISREG(mode) || S_ISDIR(mode) ? ""
           : S_ISLNK(mode)                ? "a link"
           : S_ISFIFO(mode)               ? "a pipe"
           : S_ISSOCK(mode)               ? "a socket"
                                          : "a device";
}

Descriptor opened_plain_file(const fs::path& folder, const fs::path& name)
{
    try {
        // Asked before the opening too, since opening a device may already do something.
        require_plain(status_beneath(folder, name).st_mode);
        Descriptor opened = opened_beneath(folder, name, O_RDONLY | O_NONBLOCK | O_NOCTTY);
        struct stat status = {};
        if (fstat(opened, &status) != 0) refuse_unreadable(errno);
        require_plain(status.st_mode);
        return opened;
    } catch (const std::system_error& error) {
        refuse_unreadable(error.code().value());
    }
}

PlainFile read_plain_file(const fs::path& folder, const fs::path& name, std::size_t most)
{
    const Descriptor descriptor = opened_plain_file(folder, name);
    struct stat status = {};
    if (fstat(descriptor, &status) != 0) refuse_unreadable(errno);
    PlainFile result;
    result.size = static_cast<std::size_t>(status.st_size);
    std::string block(65536, '\0');
    while (result.size <= most) { // the file may grow while it is read
        const ssize_t n = read(descriptor, block.data(), block.size());
        if (n < 0 && errno == EINTR) continue;
        if (n < 0) refuse_unreadable(errno);
        if (n == 0) {
            result.size = result.text.size();
            return result;
        }
        result.text.append(block, 0, static_cast<std::size_t>(n));
        if (result.text.size() > most) result.size = result.text.size();
    }
    result.text.clear();
    return result;
}

} // namespace rigor
