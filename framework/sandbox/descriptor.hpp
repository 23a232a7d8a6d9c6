// SPDX-License-Identifier: MIT
// A file descriptor that closes itself, and the two ends of a pipe.
#pragma once

#include <array>

namespace rigor {

/// An open descriptor. It has a high number, above those that dup2 gives to the descriptors of a
/// child process, so it is not overwritten there. Programs that are started do not inherit it.
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
