// SPDX-License-Identifier: MIT
#pragma once

#include "cli/progress.hpp"

#include <chrono>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

namespace rigor {

/// The progress of a run over a class, with the time that is left, as far as it can be told.
class ClassProgress {
public:
    explicit ClassProgress(std::string title) : title_(std::move(title)) {}

    /// @param doing  what is being done  @param detail  by whom
    void update(std::size_t done, std::size_t total, const std::string& doing,
                const std::string& detail);
    void clear() { bar_.reset(); }

private:
    using Clock = std::chrono::steady_clock;
    std::string title_, doing_;
    std::optional<Progress> bar_; // each thing that is done has one of its own
    Clock::time_point start_;
    std::size_t done_at_start_ = 0;
};

} // namespace rigor
