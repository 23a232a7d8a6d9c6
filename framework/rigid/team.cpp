// SPDX-License-Identifier: MIT
#include "rigid/team.hpp"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <exception>
#include <mutex>
#include <stdexcept>
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

// Which work it is, and how many of its tasks were taken: by the caller from the first on, by the others from the last
// on. So tasks that come again and again, a step's sweeps, find most of what they need in their processor's cache.
struct alignas(std::uint64_t) Ticket {
    std::uint32_t work = 0;
    std::uint16_t from_first = 0, from_last = 0;
};
static_assert(std::atomic<Ticket>::is_always_lock_free);
constexpr int most_tasks = 0xffff;

// The helpers, and the work at hand.
struct Team::Crew {
    ~Crew();
    // @param helpers  how many there are to be
    void do_all(int helpers, int tasks, const void* what, Call call);
    void help();
    void do_tasks(bool from_first);
    void keep_exception(int task);

    std::vector<std::thread> helpers_;
    std::atomic<const void*> what_ = nullptr;
    std::atomic<Call> call_ = nullptr;
    std::atomic<int> tasks_ = 0;
    std::atomic<Ticket> ticket_ = Ticket{};
    std::atomic<std::uint32_t> round_ = 0; // counts works
    std::atomic<bool> is_over_ = false;    // there are no more
    std::atomic<int> done_ = 0;            // tasks of the work at hand
    std::mutex mutex_;                     // of what follows
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
    if (tasks > most_tasks) throw std::length_error("too many tasks for a team");
    if (!crew_) crew_ = std::make_unique<Crew>();
    crew_->do_all(threads_ - 1, tasks, what, call);
}

int Team::stretches_of(std::size_t count, std::size_t least) const
{
    if (count == 0 || threads_ < 2) return count == 0 ? 0 : 1;
    constexpr int for_each_thread = 4; // so that one that is held up does not hold up all
    const auto most = static_cast<std::size_t>(for_each_thread * threads_);
    return static_cast<int>(std::clamp<std::size_t>(count / least, 1, most));
}

Team::Stretch Team::stretch(std::size_t count, int stretches, int k)
{
    if (stretches == 1) return {0, count};
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
    const std::uint32_t work = ticket_.load().work;
    ticket_.store({work + 1, most_tasks, 0});
    what_.store(what);
    call_.store(call);
    tasks_.store(tasks);
    done_.store(0);
    ticket_.store({work + 2, 0, 0});
    round_.fetch_add(1);
    round_.notify_all();
    while (static_cast<int>(helpers_.size()) < helpers)
        helpers_.emplace_back([this] { help(); });
    do_tasks(true);
    wait_for(done_, [tasks](int done) { return done == tasks; });
    if (thrown_) std::rethrow_exception(std::exchange(thrown_, nullptr));
}

void Team::Crew::help()
{
    for (std::uint32_t seen = 0;;) {
        seen = wait_for(round_, [seen](std::uint32_t now) { return now != seen; });
        if (is_over_.load()) return;
        do_tasks(false);
    }
}

void Team::Crew::do_tasks(bool from_first)
{
    for (;;) {
        Ticket ticket = ticket_.load(), next = ticket;
        const int tasks = tasks_.load();
        if (ticket.from_first + ticket.from_last >= tasks) return;
        const int task = from_first ? next.from_first++ : tasks - ++next.from_last;
        const void* what = what_.load();
        const Call call = call_.load();
        if (!ticket_.compare_exchange_weak(ticket, next)) continue;
        try {
            call(what, task);
        } catch (...) {
            keep_exception(task);
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
