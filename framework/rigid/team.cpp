// SPDX-License-Identifier: MIT
#include "rigid/team.hpp"

#include <algorithm>
#include <utility>

namespace rigor {

namespace {

// Waits for `value` to become what is wanted: the next work of a step comes within microseconds, so first
// by looking again and again, giving way to others, and only then by falling asleep.
template <class T, class IsWanted> T wait_for(std::atomic<T>& value, const IsWanted& is_wanted)
{
    constexpr int looks = 1000, turns = 4000;
    for (int i = 0; i < looks + turns; ++i) {
        const T now = value.load();
        if (is_wanted(now)) return now;
        if (i >= looks) std::this_thread::yield();
    }
    for (;;) {
        const T now = value.load();
        if (is_wanted(now)) return now;
        value.wait(now);
    }
}

} // namespace

Team::Team(int threads) : threads_(std::max(threads, 1)) {}

Team::~Team()
{
    if (helpers_.empty()) return;
    round_.store(-1);
    round_.notify_all();
    for (std::thread& helper : helpers_)
        helper.join();
}

int Team::stretches_of(std::size_t count, std::size_t least) const
{
    if (count == 0) return 0;
    constexpr int for_each_thread = 4; // so that one that is held up does not hold up all
    const auto most = static_cast<std::size_t>(threads_ < 2 ? 1 : for_each_thread * threads_);
    return static_cast<int>(std::clamp<std::size_t>(count / least, 1, most));
}

Team::Stretch Team::stretch(std::size_t count, int stretches, int k)
{
    const auto n = static_cast<std::size_t>(stretches), i = static_cast<std::size_t>(k);
    return {count * i / n, count * (i + 1) / n};
}

void Team::share_out(int tasks, const void* what, Call call)
{
    // While the work changes, no task of it can be had: a helper that comes late finds none, or that
    // its ticket is no longer valid.
    constexpr std::uint64_t lower_half = 0xffffffff;
    const std::uint64_t work = (ticket_.load() >> 32) + 1;
    ticket_.store(work << 32 | lower_half);
    what_.store(what);
    call_.store(call);
    tasks_.store(static_cast<std::uint32_t>(tasks));
    done_.store(0);
    ticket_.store((work + 1) << 32);
    round_.fetch_add(1);
    round_.notify_all();
    while (static_cast<int>(helpers_.size()) + 1 < threads_)
        helpers_.emplace_back([this] { help(); });
    do_tasks();
    const auto all = static_cast<std::uint32_t>(tasks);
    wait_for(done_, [all](std::uint32_t done) { return done == all; });
    if (thrown_) std::rethrow_exception(std::exchange(thrown_, nullptr));
}

void Team::help()
{
    int seen = 0;
    for (;;) {
        const int round = wait_for(round_, [seen](int now) { return now != seen; });
        if (round < 0) return;
        seen = round;
        do_tasks();
    }
}

void Team::do_tasks()
{
    for (;;) {
        std::uint64_t ticket = ticket_.load();
        const auto task = static_cast<std::uint32_t>(ticket), tasks = tasks_.load();
        if (task >= tasks) return;
        const void* what = what_.load();
        const Call call = call_.load();
        if (!ticket_.compare_exchange_weak(ticket, ticket + 1)) continue;
        try {
            call(what, static_cast<int>(task));
        } catch (...) {
            keep_exception(static_cast<int>(task));
        }
        if (done_.fetch_add(1) + 1 == tasks) done_.notify_one();
    }
}

void Team::keep_exception(int task)
{
    const std::lock_guard lock(mutex_);
    if (thrown_ && thrown_by_ < task) return;
    thrown_by_ = task;
    thrown_ = std::current_exception();
}

} // namespace rigor
