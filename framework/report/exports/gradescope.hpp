// SPDX-License-Identifier: MIT
#pragma once

#include "grading/result.hpp"

#include <string>

namespace rigor {

/// results.json of a Gradescope autograder. A hidden task is shown once grades are published. Empty
/// for an `internal_error`: Gradescope then says that the autograder failed, and gives no points.
std::string gradescope_json(const Result& result);

} // namespace rigor
