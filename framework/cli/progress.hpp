// SPDX-License-Identifier: MIT
// How far something is, on stderr: a bar on a terminal, a plain line now and then elsewhere.
#pragma once

#include <chrono>
#include <string>

namespace rigor {

/// Shows nothing before half a second has passed: what is quick needs no bar.
class Progress {
public:
    explicit Progress(std::string title) : title_(std::move(title)) {}
    ~Progress() { clear(); }
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// @param detail  what is being done right now
    void update(double fraction, const std::string& detail);
    /// Takes the bar away.
    void clear();

private:
    using Clock = std::chrono::steady_clock;
    std::string title_;
    Clock::time_point start_ = Clock::now(), shown_at_ = {};
    bool on_screen_ = false;
    int tenths_ = 0; // shown so far, where there is no terminal
};

} // namespace rigor
