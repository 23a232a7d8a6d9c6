// SPDX-License-Identifier: MIT
#include "cli/progress.hpp"

#include "report/terminal.hpp"

#include <algorithm>
#include <cstdio>
#include <unistd.h>

namespace rigor {

void Progress::update(double fraction, const std::string& detail)
{
    const Clock::time_point now = Clock::now();
    const double f = std::clamp(fraction, 0.0, 1.0);
    if (!is_terminal(STDERR_FILENO)) {
        const int tenths = static_cast<int>(10 * f);
        if (now - start_ < std::chrono::seconds(5) || tenths <= tenths_) return;
        tenths_ = tenths;
        std::fprintf(stderr, "%s: %d %%  %s\n", title_.c_str(), 10 * tenths, detail.c_str());
        return;
    }
    if (now - start_ < std::chrono::milliseconds(500) ||
        now - shown_at_ < std::chrono::milliseconds(50))
        return;
    shown_at_ = now;
    on_screen_ = true;
    constexpr int width = 24;
    const int filled = static_cast<int>(width * f);
    std::string bar;
    for (int i = 0; i < width; ++i)
        bar += i < filled ? "█" : "░";
    std::fprintf(stderr, "\r\033[K%-10.20s %s %3d %%  %.30s", title_.c_str(), bar.c_str(),
                 static_cast<int>(100 * f), detail.c_str());
    std::fflush(stderr);
}

void Progress::clear()
{
    if (on_screen_) std::fputs("\r\033[K", stderr);
    on_screen_ = false;
}

} // namespace rigor
