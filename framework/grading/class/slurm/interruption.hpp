// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <csignal>

namespace rigor {

/// While this object lives, SIGINT and SIGTERM are only noted, so that a job of Slurm can be
/// canceled first. The destructor raises a noted signal again, now with its usual effect. At most
/// one such object may live at a time.
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
