// SPDX-License-Identifier: MIT
// Controls are submissions whose points are known. They show that the machine and the tests work.
#pragma once

#include "grading/result.hpp"

#include <string>

namespace rigor {

/// What is wrong with the result of a control; empty if nothing is.
/// @param is_complete  whether it must get every point; otherwise it must get none
std::string fault_of_control(const Result& result, bool is_complete);

} // namespace rigor
