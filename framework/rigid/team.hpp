// SPDX-License-Identifier: MIT
// Threads that share the work of a step.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

namespace rigor {

/// The calling thread and others that help it. They start when there is work for them, wait for more, and end
/// with the team. Who does a task changes nothing of its result, as long as no task writes what another one
/// reads. A copy has helpers of its own: a team works for one caller at a time.
class Team {
public:
    /// @param threads  with the calling one; fewer than 2: it works alone
    explicit Team(int threads = 1);
    ~Team();
    Team(const Team& other);
    Team(Team&& other) noexcept;
    Team& operator=(Team other) noexcept;

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

    /// The same, with beside() at the same time.
    template <class Beside, class Work>
    void share_stretches_beside(const Beside& beside, std::size_t count, std::size_t least,
                                const Work& work)
    {
        const int stretches = stretches_of(count, least);
        share(stretches + 1, [&](int k) {
            if (k == 0) return beside();
            const auto [first, last] = stretch(count, stretches, k - 1);
            work(first, last);
        });
    }

    /// share_stretches. @return what work returned, in the order of the stretches: one by one the same for any number
    /// of threads, if put together in that order
    template <class Work>
    auto collect(std::size_t count, std::size_t least, const Work& work)
        -> std::vector<decltype(work(count, count))>
    {
        const int stretches = stretches_of(count, least);
        std::vector<decltype(work(count, count))> results(stretches);
        share(stretches, [&](int k) {
            const auto [first, last] = stretch(count, stretches, k);
            results[k] = work(first, last);
        });
        return results;
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
    struct Crew;
    using Call = void (*)(const void*, int);
    void share_out(int tasks, const void* what, Call call);

    int threads_;
    std::unique_ptr<Crew> crew_; // from the first work on
};

} // namespace rigor
