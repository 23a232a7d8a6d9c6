// SPDX-License-Identifier: MIT
// Threads that share the work of one step.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace rigor {

/// The calling thread and others that help it. They start when there is work for them, and end with the
/// team. Who does a task changes nothing of its result, as long as no task writes what another one reads.
class Team {
public:
    /// @param threads  with the calling one; fewer than 2: it works alone
    explicit Team(int threads = 1);
    ~Team();
    Team(const Team&) = delete;
    Team& operator=(const Team&) = delete;

    /// Calls work(k) once for each k in [0, tasks). If some throw, what the first of them threw.
    template <class Work> void share(int tasks, const Work& work)
    {
        if (threads_ < 2 || tasks < 2) {
            for (int k = 0; k < tasks; ++k)
                work(k);
            return;
        }
        share_out(tasks, &work,
                  [](const void* what, int k) { (*static_cast<const Work*>(what))(k); });
    }

    /// Calls work(first, last) for stretches of [0, count), each of at least `least`.
    template <class Work>
    void share_stretches(std::size_t count, std::size_t least, const Work& work)
    {
        const int stretches = stretches_of(count, least);
        share(stretches, [&](int k) {
            const auto [first, last] = stretch(count, stretches, k);
            work(first, last);
        });
    }

    /// Calls both: at the same time if they are about `count` things, of which `least` are worth it.
    template <class First, class Second>
    void share_both(std::size_t count, std::size_t least, const First& first, const Second& second)
    {
        const int tasks = stretches_of(count, least) < 2 ? 1 : 2;
        share(tasks, [&](int k) {
            if (k == 0) first();
            if (k == 1 || tasks == 1) second();
        });
    }

    /// In how many stretches `share_stretches` would do it; for results that are put together again.
    int stretches_of(std::size_t count, std::size_t least) const;

    struct Stretch {
        std::size_t first = 0, last = 0;
    };
    static Stretch stretch(std::size_t count, int stretches, int k);

private:
    using Call = void (*)(const void*, int);
    void share_out(int tasks, const void* what, Call call);
    void help();
    void do_tasks();
    void keep_exception(int task);

    int threads_;
    std::vector<std::thread> helpers_;
    std::atomic<const void*> what_ = nullptr; // the work at hand
    std::atomic<Call> call_ = nullptr;
    std::atomic<std::uint32_t> tasks_ = 0;
    std::atomic<std::uint64_t> ticket_ = 0; // which work, and in the lower half its next task
    std::atomic<int> round_ = 0;            // counts works; negative: there are no more
    std::atomic<std::uint32_t> done_ = 0;   // tasks of the work at hand
    std::mutex mutex_;                      // of what follows
    int thrown_by_ = 0;
    std::exception_ptr thrown_;
};

} // namespace rigor
