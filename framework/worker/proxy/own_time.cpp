// SPDX-License-Identifier: MIT
#include "worker/proxy/own_time.hpp"

#include "worker/failure.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cmath>
#include <ctime>
#include <sys/time.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace rigor {

namespace own_time {

volatile std::sig_atomic_t ticks = 0, last_formula = -1;

} // namespace own_time

namespace {

constexpr int ticks_per_second = 4;

volatile std::sig_atomic_t most_ticks = 0;
LastWords last_words;
const OwnTimeLimit* innermost = nullptr;

double on_processor()
{
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

// Writes a text by `write`, one of the functions that a signal handler may call.
void say(const char* text, std::size_t size)
{
    while (size > 0) {
        const ssize_t n = write(last_words.descriptor, text, size);
        if (n <= 0) return;
        text += n;
        size -= static_cast<std::size_t>(n);
    }
}

void tick(int)
{
    const int error = errno;
    own_time::ticks = own_time::ticks + 1;
    if (own_time::ticks > most_ticks) {
        say(last_words.before.data(), last_words.before.size());
        if (own_time::last_formula >= 0) {
            const std::string_view name =
                formulas[static_cast<unsigned>(own_time::last_formula)].name;
            say(name.data(), name.size());
        }
        say(last_words.after.data(), last_words.after.size());
        _exit(stalled_status);
    }
    errno = error;
}

void start_timer()
{
    static const bool runs = [] {
        struct sigaction action = {};
        action.sa_handler = tick;
        action.sa_flags = SA_RESTART;
        const timeval period = {0, 1'000'000 / ticks_per_second};
        const itimerval timer = {period, period};
        if (sigaction(SIGPROF, &action, nullptr) != 0 ||
            setitimer(ITIMER_PROF, &timer, nullptr) != 0)
            throw std::system_error(errno, std::generic_category(), "a timer");
        return true;
    }();
    static_cast<void>(runs);
}

} // namespace

void watch_own_time(LastWords words, double stall)
{
    most_ticks = 0x7fffffff; // no limit while the last words are being set
    last_words = std::move(words);
    own_time::ticks = 0;
    own_time::last_formula = -1;
    most_ticks = static_cast<int>(std::ceil(stall * ticks_per_second));
    start_timer();
}

OwnTimeLimit::OwnTimeLimit(std::string subject, double seconds)
    : subject_(std::move(subject)), seconds_(seconds), end_(on_processor() + seconds),
      outer_(std::exchange(innermost, this))
{
}

OwnTimeLimit::~OwnTimeLimit()
{
    innermost = outer_;
}

void OwnTimeLimit::check() const
{
    if (outer_) outer_->check();
    if (on_processor() > end_)
        throw OwnTimeOver(subject_, fmt::format("does not come to its end: with the answers of its "
                                                "formulas it takes more than {:.3g} s",
                                                seconds_));
}

void own_time::check()
{
    if (innermost) innermost->check();
}

} // namespace rigor
