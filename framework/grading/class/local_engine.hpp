// SPDX-License-Identifier: MIT
#pragma once

#include "grading/class/engine.hpp"
#include "grading/class/isolated.hpp"

namespace rigor {

/// Grades on this machine, each submission in a process of its own. An engine that grades the whole
/// run keeps each submission to one processor, so that `jobs` is the number of processors in use.
class LocalEngine : public Engine {
public:
    /// @param jobs  how many submissions are graded at the same time
    /// @param part  the prefix of the names of the working folders. If several engines grade
    ///              parts of one run, each part has a prefix of its own. For a task of Slurm it is
    ///              `<job id>_<restarts>`, where <restarts> is how often the task was restarted.
    ///              For an engine that grades the whole run it is empty.
    explicit LocalEngine(unsigned jobs, std::string part = {})
        : isolation_{jobs, part.empty()}, part_(std::move(part))
    {
    }

    std::string grade(const ClassWork& work, const std::vector<std::size_t>& numbers,
                      const OnGraded& on_graded, const OnWait& on_wait) override;

private:
    // The tasks of Slurm cannot agree on processors, so the system decides which processor each
    // task gets.
    Isolation isolation_;
    std::string part_;
};

} // namespace rigor
