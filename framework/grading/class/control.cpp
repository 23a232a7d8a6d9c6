// SPDX-License-Identifier: MIT
#include "grading/class/control.hpp"

#include <fmt/format.h>

namespace rigor {

std::string fault_of_control(const Result& result, bool is_complete)
{
    if (result.status != SubmissionStatus::graded)
        return fmt::format("is {}: {}", to_string(result.status), result.message);
    if (result.max_score() <= 0) return "could get no points";
    for (const TaskResult& task : result.tasks) {
        const double expected = is_complete ? task.max_score : 0;
        if (task.score != expected)
            return fmt::format("got {:g} of {:g} points; in {} it got {:g}, expected {:g}",
                               result.score(), result.max_score(), task.task.tag, task.score,
                               expected);
    }
    return "";
}

} // namespace rigor
