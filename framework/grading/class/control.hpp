// SPDX-License-Identifier: MIT
// Controls are submissions whose points are known. They show that the machine and the tests work.
#pragma once

#include "grading/class/engine.hpp"
#include "grading/class/isolated.hpp"
#include "grading/class/work_folders.hpp"
#include "grading/result.hpp"

#include <functional>
#include <string>

namespace rigor {

/// What is wrong with the result of a control; empty if nothing is.
/// @param is_complete  true: the control must get every point; false: it must get none
std::string fault_of_control(const Result& result, bool is_complete);

/// Grades the reference, if there is one, and a file without formulas, in the same way as
/// submissions.
/// @param when  for the message: "before the first submission" or "after the last submission"
/// @return what is wrong with a control; empty if nothing is
std::string fault_of_controls(const ClassWork& work, const WorkFolders& folders,
                              const Isolation& how, const std::string& when,
                              const std::function<void()>& on_wait);

} // namespace rigor
