// SPDX-License-Identifier: MIT
#pragma once

#include "grading/selection.hpp"

namespace rigor::testing {

/// A selection of one task of two points, as tests of classes need it.
inline Selection one_task()
{
    Task task;
    task.tag = "A2.1";
    task.formula = "f";
    task.points = 2;
    Selection selection;
    selection.assignment.name = "a2-inertia";
    selection.assignment.topic = "inertia";
    selection.assignment.tasks = {task};
    selection.tags = {task.tag};
    return selection;
}

} // namespace rigor::testing
