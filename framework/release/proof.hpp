// SPDX-License-Identifier: MIT
// Shows that what is handed out works, by building and running it as its users do.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace rigor {

/// Called at the start of each step of a proof with a sentence about it. A step takes minutes.
using OnProofStep = std::function<void(const std::string& step)>;

/// What the proof of a students' tree has found.
struct TreeProof {
    int tasks = 0;     // visible tasks; each stub was `not_implemented`
    double points = 0; // points of the visible tasks; the reference got all of them
};

/// Builds a students' tree and grades in it the stubs, which must get no point because no task is
/// implemented, and the reference, which must get every point of the visible tasks.
/// @param tree       the students' tree, where it is built
/// @param reference  the folder with the reference's files
/// @param on_step    called `steps_of_tree_proof` times
/// @throws std::runtime_error that says what is wrong with the tree
TreeProof prove_students_tree(const std::filesystem::path& tree,
                              const std::filesystem::path& reference, const OnProofStep& on_step);
inline constexpr int steps_of_tree_proof = 2;

/// What is wrong with the output of `rigor check --json`; empty if every visible task has the
/// expected status and points and no hidden task has points.
/// @param solved  true: every point of the visible tasks is expected; false: none is
/// @param proof   gets the number and the points of the visible tasks
std::string fault_of_tree(const std::string& json, bool solved, TreeProof& proof);

/// Writes the reference as a student would hand it in: one source for each topic, and the headers.
void write_solved_files(const std::filesystem::path& reference,
                        const std::filesystem::path& folder);

} // namespace rigor
