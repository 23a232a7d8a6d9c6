// SPDX-License-Identifier: MIT
#include "rigid/team.hpp"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

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

// The helpers, and the work at hand.
struct Team::Crew {
    ~Crew();
    // @param helpers  how many there are to be
    void do_all(int helpers, int tasks, const void* what, Call call);
    void help();
    void do_tasks();
    void keep_exception(int task);

    std::vector<std::thread> helpers_;
    std::atomic<const void*> what_ = nullptr;
    std::atomic<Call> call_ = nullptr;
    std::atomic<std::uint32_t> tasks_ = 0;
    std::atomic<std::uint64_t> ticket_ = 0; // which work, and in the lower half its next task
    std::atomic<std::uint32_t> round_ = 0;  // counts works
    std::atomic<bool> is_over_ = false;     // there are no more
    std::atomic<std::uint32_t> done_ = 0;   // tasks of the work at hand
    std::mutex mutex_;                      // of what follows
    int thrown_by_ = 0;
    std::exception_ptr thrown_;
};

Team::Team(int threads) : threads_(std::max(threads, 1)) {}

Team::Team(const Team& other) : Team(other.threads_) {}

Team::Team(Team&& other) noexcept = default;

Team::~Team() = default;

Team& Team::operator=(Team other) noexcept
{
    threads_ = other.threads_;
    crew_ = std::move(other.crew_);
    return *this;
}

void Team::share_out(int tasks, const void* what, Call call)
{
    if (!crew_) crew_ = std::make_unique<Crew>();
    crew_->do_all(threads_ - 1, tasks, what, call);
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

Team::Crew::~Crew()
{
    is_over_.store(true);
    round_.fetch_add(1);
    round_.notify_all();
    for (std::thread& helper : helpers_)
        helper.join();
}

void Team::Crew::do_all(int helpers, int tasks, const void* what, Call call)
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
    while (static_cast<int>(helpers_.size()) < helpers)
        helpers_.emplace_back([this] { help(); });
    do_tasks();
    const auto all = static_cast<std::uint32_t>(tasks);
    wait_for(done_, [all](std::uint32_t done) { return done == all; });
    if (thrown_) std::rethrow_exception(std::exchange(thrown_, nullptr));
}

void Team::Crew::help()
{
    for (std::uint32_t seen = 0;;) {
        seen = wait_for(round_, [seen](std::uint32_t now) { return now != seen; });
        if (is_over_.load()) return;
        do_tasks();
    }
}

void Team::Crew::do_tasks()
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

void Team::Crew::keep_exception(int task)
{
    const std::lock_guard lock(mutex_);
    if (thrown_ && thrown_by_ < task) return;
    thrown_by_ = task;
    thrown_ = std::current_exception();
}

} // namespace rigor
