// SPDX-License-Identifier: MIT
// Gives each job a processor of its own. Grader and worker of a submission take turns, so a second
// processor hardly helps them, and jobs that move between processors disturb each other.
#pragma once

#include <cstddef>
#include <vector>

namespace rigor {

/// The processors that this process may use, and how many jobs each of them has.
class Processors {
public:
    /// Without a processor that is known, jobs run where the system lets them run.
    Processors();
    explicit Processors(const std::vector<int>& numbers);

    /// Takes a processor for a job: of those with the fewest jobs, the next one after the last that
    /// was taken, so that in time the jobs are spread over all of them.
    /// @return its number for `keep_to`; -1 if none is known
    int take();
    void give_back(int number);

private:
    struct Processor {
        int number;
        unsigned jobs = 0;
    };
    std::vector<Processor> all_;
    std::size_t next_ = 0;
};

/// Keeps this process, and all that it starts, to one processor; -1: to none in particular.
void keep_to(int processor);

} // namespace rigor
