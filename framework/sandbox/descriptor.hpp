// SPDX-License-Identifier: MIT
// A file descriptor that closes itself, and the two ends of a pipe.
#pragma once

#include <array>

namespace rigor {

/// An open descriptor. Its number is higher than those that a child process gets, so that none is
/// overwritten when the child's descriptors are put in place. Programs do not inherit it.
class Descriptor {
public:
    Descriptor() = default;
    /// Takes over the descriptor `low`, which may be the result of a call that failed.
    /// @throws std::system_error with errno, if it is negative
    Descriptor(int low, const char* what);
    ~Descriptor();
    Descriptor(Descriptor&& other) noexcept;
    Descriptor& operator=(Descriptor&& other) noexcept;
    operator int() const { return fd_; }

private:
    int fd_ = -1;
};

struct Ends {
    Descriptor read, write;
};

/// A pipe whose read end does not wait.
Ends output_pipe();

/// /dev/null for reading.
Descriptor no_input();

} // namespace rigor
