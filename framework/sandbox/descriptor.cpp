// SPDX-License-Identifier: MIT
#include "sandbox/descriptor.hpp"

#include <cerrno>
#include <fcntl.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace rigor {

namespace {

int checked(int result, const char* what)
{
    if (result < 0) throw std::system_error(errno, std::generic_category(), what);
    return result;
}

} // namespace

Descriptor::Descriptor(int low, const char* what)
{
    constexpr int lowest = 10;
    fd_ = fcntl(checked(low, what), F_DUPFD_CLOEXEC, lowest);
    const int error = errno;
    close(low);
    errno = error;
    checked(fd_, what);
}

Descriptor::~Descriptor()
{
    if (fd_ >= 0) close(fd_);
}

Descriptor::Descriptor(Descriptor&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}

Descriptor& Descriptor::operator=(Descriptor&& other) noexcept
{
    std::swap(fd_, other.fd_);
    return *this;
}

Ends output_pipe()
{
    std::array<int, 2> ends{};
    checked(pipe2(ends.data(), O_CLOEXEC), "pipe");
    Ends result{Descriptor(ends[0], "pipe"), Descriptor(ends[1], "pipe")};
    checked(fcntl(result.read, F_SETFL, O_NONBLOCK), "pipe");
    return result;
}

Descriptor no_input()
{
    return {open("/dev/null", O_RDONLY | O_CLOEXEC), "/dev/null"};
}

} // namespace rigor
