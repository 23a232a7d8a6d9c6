// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace rigor {

/// The names of the topics, one for each file of student/, in the order of the assignments.
std::vector<std::string> topics();

} // namespace rigor
