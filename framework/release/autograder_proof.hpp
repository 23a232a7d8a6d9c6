// SPDX-License-Identifier: MIT
#pragma once

#include "grading/assignment.hpp"
#include "release/proof.hpp"

#include <filesystem>
#include <string>

namespace rigor {

/// Lays a Gradescope autograder out as Gradescope does, sets it up, and runs it on a solved file,
/// on a file without formulas, and on an empty submission. If this process runs as root, the
/// autograder runs as user `nobody`, if possible.
/// @param zip     the autograder
/// @param layout  the folder that takes the place of /autograder; what an earlier proof has built
///     there is kept
/// @param source  the tree with reference/
/// @param on_step called `steps_of_autograder_proof` times
/// @return who ran it: "nobody" or "this user"
/// @throws std::runtime_error that says what is wrong
std::string prove_autograder(const std::filesystem::path& zip, const std::filesystem::path& layout,
                             const Assignment& assignment, const std::filesystem::path& source,
                             const OnProofStep& on_step);
inline constexpr int steps_of_autograder_proof = 4;

/// What is wrong with a results.json; empty if it gives `score` of `most` points.
std::string fault_of_results(const std::string& json, double score, double most);

} // namespace rigor
