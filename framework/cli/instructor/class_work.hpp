// SPDX-License-Identifier: MIT
// The preparation that is common to the commands that grade a class.
#pragma once

#include "grading/class/engine.hpp"

#include <cstdint>
#include <string>

namespace rigor {

/// All tasks of an assignment. @throws InputError if the word names something else
Selection whole_assignment(const std::string& word);

/// A line for the instructor if student/ has stubs that a right solution of the topic calls: what
/// they cost, and the command that puts solutions in their place. Empty if there are none.
std::string warning_about_stubs(const std::string& topic);

/// Builds the tests, the reference and what all submissions share, with a progress bar. The result
/// has no submissions yet. Prints on stderr how strong the sandbox around submissions is, whether
/// hidden tests are left out, whether a secret draws the random cases, which stubs in student/ cost
/// points, and whether the tree has no reference. Without a reference, no control shows that a
/// right solution gets every point.
/// @param secret_file  the file with the course's secret; empty: the course has no secret
ClassWork prepared_class_work(const Selection& selection, std::uint32_t seed,
                              const std::string& secret_file);

} // namespace rigor
