// SPDX-License-Identifier: MIT
#include "cli/instructor/class_progress.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace rigor {

namespace {

// A duration in words, such as "5 min".
std::string in_words(double seconds)
{
    if (seconds < 90) return fmt::format("{:.0f} s", seconds);
    if (seconds < 5400) return fmt::format("{:.0f} min", seconds / 60);
    return fmt::format("{:.1f} h", seconds / 3600);
}

} // namespace

void ClassProgress::update(std::size_t done, std::size_t total, const std::string& doing,
                           const std::string& detail)
{
    const Clock::time_point now = Clock::now();
    if (doing != doing_) {
        doing_ = doing;
        start_ = now;
        done_at_start_ = done;
        bar_.reset();
    }
    if (!bar_) bar_.emplace(title_);
    std::string text = doing;
    if (doing == "grading" && total > 0) {
        text = fmt::format("{} of {}", done, total);
        const double seconds = std::chrono::duration<double>(now - start_).count();
        if (done > done_at_start_)
            text += fmt::format(", {} left",
                                in_words(seconds / static_cast<double>(done - done_at_start_) *
                                         static_cast<double>(total - done)));
    }
    if (!detail.empty()) text += ", " + detail;
    bar_->update(static_cast<double>(done) / static_cast<double>(std::max<std::size_t>(total, 1)),
                 text);
}

} // namespace rigor
