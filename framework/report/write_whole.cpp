// SPDX-License-Identifier: MIT
#include "report/write_whole.hpp"

#include "errors/input_error.hpp"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <unistd.h>

namespace rigor {

std::filesystem::path draft_of(const std::filesystem::path& file)
{
    return file.string() + ".new";
}

void write_whole(const std::filesystem::path& file, const std::string& content)
{
    const std::string draft = draft_of(file).string();
    const auto fail = [&] {
        const int error = errno;
        unlink(draft.c_str());
        throw InputError(file.string() + ": cannot be written: " + std::strerror(error));
    };
    const int descriptor = open(draft.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
    if (descriptor < 0) fail();
    bool ok = true;
    for (std::size_t sent = 0; ok && sent < content.size();) {
        const ssize_t n = write(descriptor, content.data() + sent, content.size() - sent);
        if (n < 0 && errno == EINTR) continue;
        ok = n > 0;
        if (ok) sent += static_cast<std::size_t>(n);
    }
    // The data reach the disk before the rename. So after a crash of the machine the file is either
    // the old one or the complete new one.
    ok = ok && fsync(descriptor) == 0;
    const int error = errno;
    close(descriptor);
    errno = error;
    if (!ok || rename(draft.c_str(), file.c_str()) != 0) fail();
}

} // namespace rigor
