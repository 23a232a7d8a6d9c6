// SPDX-License-Identifier: MIT
// What a task of a Slurm job does: it grades its chunk of a class.
#pragma once

#include "grading/class/slurm/shared_folder.hpp"

namespace rigor {

/// Grades the submissions of a chunk that have no result yet, and writes their results to the
/// shared folder. @param task  the index of the chunk in `plan.chunks`
/// @param work  the assignment, the run and the reference of this node, without submissions
/// @throws InputError if the node has another tree, other programs or another sandbox than the
///     machine that made the plan. A submission that has changed since then is reported as a fault.
/// @return what is wrong with a control, a submission with known points; empty if nothing is. This
///     text is also written to the shared folder.
std::string run_slurm_task(const slurm::Plan& plan, std::size_t task, ClassWork work);

} // namespace rigor
