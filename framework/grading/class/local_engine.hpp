// SPDX-License-Identifier: MIT
#pragma once

#include "grading/class/engine.hpp"

namespace rigor {

/// Grades on this machine, each submission in a process of its own.
class LocalEngine : public Engine {
public:
    /// @param jobs  how many submissions are graded at the same time
    /// @param part  the beginning of the names of the working folders. If several engines grade
    ///              parts of one run, each part has another beginning. For a task of Slurm it is
    ///              `<job id>_<restarts>`, where <restarts> is how often the task was restarted.
    ///              Empty for an engine that grades the whole run.
    explicit LocalEngine(unsigned jobs, std::string part = {}) : jobs_(jobs), part_(std::move(part))
    {
    }

    std::string grade(const ClassWork& work, const std::vector<std::size_t>& numbers,
                      const OnGraded& on_graded, const OnWait& on_wait) override;

private:
    unsigned jobs_;
    std::string part_;
};

} // namespace rigor
