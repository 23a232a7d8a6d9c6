// SPDX-License-Identifier: MIT
#pragma once

#include "cli/progress.hpp"

#include <chrono>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

namespace rigor {

/// The progress bar while a class is graded, with an estimate of the remaining time.
class ClassProgress {
public:
    explicit ClassProgress(std::string title) : title_(std::move(title)) {}

    /// @param done    the number of submissions that are graded, out of `total`
    /// @param doing   what is being done, such as "grading"
    /// @param detail  such as "3 tasks", or empty
    void update(std::size_t done, std::size_t total, const std::string& doing,
                const std::string& detail);
    void clear() { bar_.reset(); }

private:
    using Clock = std::chrono::steady_clock;
    std::string title_, doing_;
    std::optional<Progress> bar_; // a new bar for each value of `doing`
    Clock::time_point start_;
    std::size_t done_at_start_ = 0;
};

} // namespace rigor
