// SPDX-License-Identifier: MIT
// What the commands that grade a class share.
#pragma once

#include "grading/class/engine.hpp"

#include <cstdint>
#include <string>

namespace rigor {

/// All tasks of an assignment. @throws InputError if the word names something else
Selection whole_assignment(const std::string& word);

/// Builds the tests, the reference and what all submissions share, with a progress bar. The result
/// has no submissions yet. Prints on stderr which walls there are, and what is left out.
/// @param secret_file  the file of the course's secret; empty: none
ClassWork prepared_class_work(const Selection& selection, std::uint32_t seed,
                              const std::string& secret_file);

} // namespace rigor
