// SPDX-License-Identifier: MIT
// Threads that share the work of a step.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

namespace rigor {

/// The calling thread and worker threads that help it. The workers start with the first work that
/// is shared, wait for more work, and end with the pool. The result of a task does not depend on
/// the thread that does the task, as long as no task writes what another task reads or writes. A
/// copy of a pool has workers of its own, since a pool works for one caller at a time.
class ThreadPool {
public:
    /// @param threads  number of threads, including the calling thread; below 2 the calling thread
    ///                 works alone
    explicit ThreadPool(int threads = 1);
    ~ThreadPool();
    ThreadPool(const ThreadPool& other);
    ThreadPool(ThreadPool&& other) noexcept;
    ThreadPool& operator=(ThreadPool other) noexcept;

    /// Calls work(k) once for each k in [0, tasks). If calls throw, the exception of the lowest k
    /// is thrown again here. Several threads first do all other tasks; one thread alone stops at
    /// the first exception.
    /// @throws std::length_error if several threads get more than 65535 tasks
    template <class Work> void for_each_task(int tasks, const Work& work)
    {
        if (threads_ < 2 || tasks < 2) {
            for (int k = 0; k < tasks; ++k)
                work(k);
            return;
        }
        run_by_workers(tasks, &work,
                       [](const void* what, int k) { (*static_cast<const Work*>(what))(k); });
    }

    /// Calls work(first, last) for ranges that cover [0, count). Each range has at least
    /// `grain_size` items; if there are fewer items, there is one range. With a larger grain size,
    /// the distribution of the ranges takes less time; with a smaller one, threads can share a
    /// smaller amount of work. So cheap items need a large grain size. The grain sizes of all
    /// callers were chosen by trial; no result depends on them. `bench pile` shows how much time a
    /// second thread saves.
    template <class Work>
    void for_each_range(std::size_t count, std::size_t grain_size, const Work& work)
    {
        const int ranges = range_count(count, grain_size);
        for_each_task(ranges, [&](int k) {
            const auto [first, last] = range(count, ranges, k);
            work(first, last);
        });
    }

    /// Does the same as `for_each_range`, and calls beside() at the same time, as one more task. A
    /// single thread calls beside() first.
    template <class Beside, class Work>
    void for_each_range_beside(const Beside& beside, std::size_t count, std::size_t grain_size,
                               const Work& work)
    {
        const int ranges = range_count(count, grain_size);
        for_each_task(ranges + 1, [&](int k) {
            if (k == 0) return beside();
            const auto [first, last] = range(count, ranges, k - 1);
            work(first, last);
        });
    }

    /// Calls work(first, last) as `for_each_range` does.
    /// @return the results of the calls, in the order of the ranges. If the results are lists,
    ///         their concatenation in this order is the same for any number of threads.
    template <class Work>
    auto collect_ranges(std::size_t count, std::size_t grain_size, const Work& work)
        -> std::vector<decltype(work(count, count))>
    {
        const int ranges = range_count(count, grain_size);
        std::vector<decltype(work(count, count))> results(ranges);
        for_each_task(ranges, [&](int k) {
            const auto [first, last] = range(count, ranges, k);
            results[k] = work(first, last);
        });
        return results;
    }

    /// Calls both functions: at the same time if `count` is at least twice `grain_size` and the
    /// pool has several threads, otherwise one after the other.
    template <class First, class Second>
    void run_both(std::size_t count, std::size_t grain_size, const First& first,
                  const Second& second)
    {
        const int tasks = range_count(count, grain_size) < 2 ? 1 : 2;
        for_each_task(tasks, [&](int k) {
            if (k == 0) first();
            if (k == 1 || tasks == 1) second();
        });
    }

    /// The number of ranges that `for_each_range` makes; 0 if `count` is 0.
    int range_count(std::size_t count, std::size_t grain_size) const;

    struct Range {
        std::size_t first = 0, last = 0;
    };
    /// Range k of [0, count), divided into `ranges` ranges whose lengths differ by at most one.
    static Range range(std::size_t count, int ranges, int k);

private:
    class Workers;
    using Call = void (*)(const void*, int);
    void run_by_workers(int tasks, const void* what, Call call);

    int threads_;
    std::unique_ptr<Workers> workers_; // null until the first work is shared
};

} // namespace rigor
