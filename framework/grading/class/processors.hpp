// SPDX-License-Identifier: MIT
// Gives each job a processor of its own. The grader and the worker of a submission run in turn, so
// a second processor hardly helps them, and jobs that move between processors slow each other down.
#pragma once

#include <cstddef>
#include <vector>

namespace rigor {

/// The processors that this process may use, and how many jobs each of them has.
class Processors {
public:
    /// Determines the processors that this process may use. If this fails, `take` returns -1, and
    /// the system decides where jobs run.
    Processors();
    explicit Processors(const std::vector<int>& numbers);

    /// Takes a processor for a job. Among those with the fewest jobs, it is the next one after the
    /// processor that was taken last, so that the jobs are spread over all processors.
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

/// Makes this process, and all that it starts, run only on this processor. Does nothing for -1.
void keep_to(int processor);

} // namespace rigor
