// SPDX-License-Identifier: MIT
// Solutions with something else in the place of one formula.
#pragma once

#include "slips.hpp"

#include <filesystem>
#include <string>

namespace rigor::slips {

/// The reference's file of a topic. Formulas that it has in other files of the topic are missing.
std::string solution(const std::string& topic);

/// Copies the headers that the reference's files include beside the contract.
void copy_headers(const std::filesystem::path& folder);

/// All files of a topic's solution as one, in which the formula is called `right_` and its name.
/// `definition`, which is appended, has to define the formula.
std::string whole_solution_beside(const std::string& topic, const std::string& formula,
                                  const std::string& definition);

/// The solution of a topic, whose formula at `place` is called `right_` and its name.
/// `definition`, which is appended, has to define the formula.
std::string solution_beside(const Place& place, const std::string& definition);

} // namespace rigor::slips
