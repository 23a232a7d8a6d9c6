// SPDX-License-Identifier: MIT
// The progress of a long task on stderr: a bar on a terminal, otherwise a line from time to time.
#pragma once

#include <chrono>
#include <string>
#include <utility>

namespace rigor {

/// A progress bar. It is hidden for the first half second, since a quick task needs no bar. Without
/// a terminal, lines are printed only after 5 s.
class Progress {
public:
    explicit Progress(std::string title) : title_(std::move(title)) {}
    ~Progress() { clear(); }
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// @param fraction  the part of the task that is done, from 0 to 1
    /// @param detail    names the current step
    void update(double fraction, const std::string& detail);
    /// Removes the bar.
    void clear();

private:
    using Clock = std::chrono::steady_clock;
    std::string title_;
    Clock::time_point start_ = Clock::now(), shown_at_ = {};
    bool on_screen_ = false;
    // The last printed fraction in tenths of the task, if stderr is not a terminal.
    int tenths_ = 0;
};

} // namespace rigor
