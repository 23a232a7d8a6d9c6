// SPDX-License-Identifier: MIT
// An example of a result to report.
#pragma once

#include "grading/result.hpp"

namespace rigor::testing {

inline Task task_of(const std::string& tag, const std::string& formula, double points)
{
    Task task;
    task.tag = tag;
    task.formula = formula;
    task.points = points;
    task.hint = "Think of the transpose, and of which frame each matrix takes its argument from "
                "before it is multiplied.";
    return task;
}

/// A result with one task that passed, one that failed, and two that end at a stub.
inline Result some_result()
{
    Result result;
    result.assignment.name = "a2-inertia";
    result.assignment.topic = "inertia";
    result.assignment.title = "Inertia tensors";
    result.submission = "student";
    TestCase good, bad, stub;
    good.name = bad.name = stub.name = "inertia: it turns with the body";
    bad.status = Status::failed;
    bad.expected = "(1, 2, 3)";
    bad.actual = "(3, 2, 1)";
    bad.error = "2";
    bad.tolerance = "1.8e-15";
    bad.tolerance_class = "R";
    bad.seed = 17;
    bad.mistake = "The components are in reverse order.";
    stub.status = Status::not_implemented;
    stub.message = "A2.3 world_inverse_inertia is not implemented yet (student/inertia.cpp)";
    result.tasks = {score_task(task_of("A2.1", "particle_mass_properties", 2), {good}),
                    score_task(task_of("A2.2", "world_inertia", 1), {good, bad}),
                    score_task(task_of("A2.3", "world_inverse_inertia", 1), {stub}),
                    score_task(task_of("A2.15", "steps", 4), {stub})};
    return result;
}

} // namespace rigor::testing
