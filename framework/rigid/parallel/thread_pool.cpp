// SPDX-License-Identifier: MIT
// The pool distributes task indices through one atomic word, without a lock. The caller takes tasks
// from the first one upwards, the workers from the last one downwards. So if a task is repeated, as
// in the sweeps of a step, it usually runs on the same processor and finds most of its data in the
// cache. A thread without work checks several thousand times for new work before it sleeps
// (`wait_for`).
#include "rigid/parallel/thread_pool.hpp"

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

// Waits until `is_wanted(value)` is true, and returns the value. The next work of a step usually
// comes within microseconds. So a thread first checks the value in a loop, then lets other threads
// run between the checks, and only then sleeps.
template <class T, class IsWanted> T wait_for(std::atomic<T>& value, const IsWanted& is_wanted)
{
    constexpr int spins = 1000, yields = 4000; // numbers of checks without and then with a yield
    for (int i = 0; i < spins + yields; ++i) {
        const T now = value.load();
        if (is_wanted(now)) return now;
        if (i >= spins) std::this_thread::yield();
    }
    for (;;) {
        const T now = value.load();
        if (is_wanted(now)) return now;
        value.wait(now);
    }
}

} // namespace

// The tasks that threads have taken in the current call of `run`. `from_first` counts those taken
// from the first task upwards, `from_last` those taken from the last task downwards. `work` changes
// with each call of `run`, so that a worker that still holds values of an earlier call cannot take
// a task.
struct alignas(std::uint64_t) TakenTasks {
    std::uint32_t work = 0;
    std::uint16_t from_first = 0, from_last = 0;
};
static_assert(std::atomic<TakenTasks>::is_always_lock_free);
constexpr int most_tasks = 0xffff; // largest value of `from_first` and of `from_last`

class ThreadPool::Workers {
public:
    ~Workers();
    /// Does all tasks with `workers` threads in addition to the calling thread.
    void run(int workers, int tasks, const void* what, Call call);

private:
    void wait_and_work();
    void do_tasks(bool from_first);
    void keep_exception(int task);

    std::vector<std::thread> threads_;
    std::atomic<const void*> what_ = nullptr;
    std::atomic<Call> call_ = nullptr;
    std::atomic<int> tasks_ = 0;
    std::atomic<TakenTasks> taken_ = TakenTasks{};
    std::atomic<std::uint32_t> round_ = 0; // `run` changes this number to wake idle workers
    std::atomic<bool> is_over_ = false;    // true: the workers have to end
    std::atomic<int> done_ = 0;            // number of finished tasks in this call of `run`
    std::mutex mutex_;                     // guards the two members below
    int thrown_by_ = 0;                    // lowest index of a task that threw
    std::exception_ptr thrown_;
};

ThreadPool::ThreadPool(int threads) : threads_(std::max(threads, 1)) {}

ThreadPool::ThreadPool(const ThreadPool& other) : ThreadPool(other.threads_) {}

ThreadPool::ThreadPool(ThreadPool&& other) noexcept = default;

ThreadPool::~ThreadPool() = default;

ThreadPool& ThreadPool::operator=(ThreadPool other) noexcept
{
    threads_ = other.threads_;
    workers_ = std::move(other.workers_);
    return *this;
}

void ThreadPool::run_by_workers(int tasks, const void* what, Call call)
{
    if (tasks > most_tasks) throw std::length_error("too many tasks for a thread pool");
    if (!workers_) workers_ = std::make_unique<Workers>();
    workers_->run(threads_ - 1, tasks, what, call);
}

int ThreadPool::range_count(std::size_t count, std::size_t grain_size) const
{
    if (count == 0 || threads_ < 2) return count == 0 ? 0 : 1;
    constexpr int ranges_per_thread = 4; // several, so that fast threads can take more ranges
    const auto most =
        static_cast<std::size_t>(ranges_per_thread) * static_cast<std::size_t>(threads_);
    return static_cast<int>(std::clamp<std::size_t>(count / grain_size, 1, most));
}

ThreadPool::Range ThreadPool::range(std::size_t count, int ranges, int k)
{
    if (ranges == 1) return {0, count};
    const auto n = static_cast<std::size_t>(ranges), i = static_cast<std::size_t>(k);
    return {count * i / n, count * (i + 1) / n};
}

ThreadPool::Workers::~Workers()
{
    is_over_.store(true);
    round_.fetch_add(1);
    round_.notify_all();
    for (std::thread& thread : threads_)
        thread.join();
}

void ThreadPool::Workers::run(int workers, int tasks, const void* what, Call call)
{
    // No thread can take a task while the members below change. A worker may still be in `do_tasks`
    // from the previous call. This worker finds no task left, since `most_tasks` tasks count as
    // taken, or its compare-and-exchange fails because `work` has changed.
    const std::uint32_t work = taken_.load().work;
    taken_.store({work + 1, most_tasks, 0});
    what_.store(what);
    call_.store(call);
    tasks_.store(tasks);
    done_.store(0);
    taken_.store({work + 2, 0, 0});
    round_.fetch_add(1);
    round_.notify_all();
    while (static_cast<int>(threads_.size()) < workers)
        threads_.emplace_back([this] { wait_and_work(); });
    do_tasks(true);
    wait_for(done_, [tasks](int done) { return done == tasks; });
    if (thrown_) std::rethrow_exception(std::exchange(thrown_, nullptr));
}

void ThreadPool::Workers::wait_and_work()
{
    for (std::uint32_t seen = 0;;) {
        seen = wait_for(round_, [seen](std::uint32_t now) { return now != seen; });
        if (is_over_.load()) return;
        do_tasks(false);
    }
}

void ThreadPool::Workers::do_tasks(bool from_first)
{
    for (;;) {
        TakenTasks taken = taken_.load(), next = taken;
        const int tasks = tasks_.load();
        if (taken.from_first + taken.from_last >= tasks) return;
        const int task = from_first ? next.from_first++ : tasks - ++next.from_last;
        const void* what = what_.load();
        const Call call = call_.load();
        if (!taken_.compare_exchange_weak(taken, next)) continue;
        try {
            call(what, task);
        } catch (...) {
            keep_exception(task);
        }
        if (done_.fetch_add(1) + 1 == tasks) done_.notify_one();
    }
}

void ThreadPool::Workers::keep_exception(int task)
{
    const std::lock_guard lock(mutex_);
    if (thrown_ && thrown_by_ < task) return;
    thrown_by_ = task;
    thrown_ = std::current_exception();
}

} // namespace rigor
