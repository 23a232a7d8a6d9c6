// SPDX-License-Identifier: MIT
// Right and wrong solutions of a build, and how far the graded tests find them from the bounds.
#pragma once

#include "grading/assignment.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace rigor::tolerances {

struct Solution {
    std::string name; // "collision_inverse", or "inertia/combine/masses_swapped"
    std::filesystem::path worker;
    std::string topic;
    std::string tag; // the task of the formula that is wrong; empty for a right solution
};

/// The reference, once for each topic, and all alternatives.
std::vector<Solution> right_solutions();

/// All known mistakes.
std::vector<Solution> wrong_solutions();

/// What a test case found.
struct Finding {
    std::string tag, law;
    std::string tolerance_class; // the class of the comparison that failed; empty if all held
    bool is_passed = false;
    /// The largest error of the comparisons that held, or the error of the one that failed, as a
    /// part of its tolerance. Infinite if the test case failed without an error, as when a value
    /// must be the same or a program crashes.
    double error = 0;
};

/// Runs the tests of a solution: of its task if it is wrong, else of its topic.
/// @throws std::runtime_error if the tests could not run
std::vector<Finding> findings(const Solution& solution, const std::vector<Assignment>& assignments,
                              unsigned seed);

} // namespace rigor::tolerances
