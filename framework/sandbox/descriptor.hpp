// SPDX-License-Identifier: MIT
// A file descriptor that closes itself, and the two ends of a pipe.
#pragma once

#include <array>

namespace rigor {

/// An open descriptor. Its number is higher than the numbers of the descriptors that a child
/// process gets. So it is not overwritten when the child's descriptors are put in place by dup2.
/// Programs that are started do not inherit it.
class Descriptor {
public:
    Descriptor() = default;
    /// Takes over the descriptor `low`, which may be the result of a call that failed.
    /// @throws std::system_error with errno, if `low` is negative
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

/// A pipe whose read end is non-blocking.
Ends output_pipe();

/// /dev/null for reading.
Descriptor no_input();

} // namespace rigor
