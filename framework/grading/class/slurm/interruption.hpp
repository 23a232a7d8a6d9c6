// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <csignal>

namespace rigor {

/// While this object lives, SIGINT and SIGTERM are noted. When it ends they do what they usually
/// do, also one that was noted: so work elsewhere can be called off first. One object at a time.
class Interruption {
public:
    Interruption();
    ~Interruption();
    Interruption(const Interruption&) = delete;
    Interruption& operator=(const Interruption&) = delete;

    bool is_wanted() const;

private:
    static constexpr std::array<int, 2> signals = {SIGINT, SIGTERM};
    std::array<struct sigaction, 2> before_ = {};
};

} // namespace rigor
