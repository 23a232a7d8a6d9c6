// SPDX-License-Identifier: MIT
// Shows that what is handed out works, by building and running it as its users do.
#pragma once

#include <filesystem>
#include <string>

namespace rigor {

/// What the proof of a students' tree saw.
struct TreeProof {
    int tasks = 0;     // visible ones; each was `not_implemented` with the stubs
    double points = 0; // the visible tasks have these; the reference got all
};

/// Builds a students' tree and grades in it the stubs, which must get no point because no task is
/// implemented, and the reference, which must get every point of the visible tasks.
/// @param tree       the students' tree, where it is built
/// @param reference  the folder with the reference's files
/// @throws std::runtime_error that says what is wrong with the tree
TreeProof prove_students_tree(const std::filesystem::path& tree,
                              const std::filesystem::path& reference);

/// What is wrong with the output of `rigor check --json`; empty if every visible task has the
/// expected status and points and no hidden task counts.
/// @param solved  whether every visible point is expected, or none
std::string fault_of_tree(const std::string& json, bool solved, TreeProof& proof);

/// Writes the reference as a student would hand it in: one file for each topic.
void write_solved_files(const std::filesystem::path& reference,
                        const std::filesystem::path& folder);

} // namespace rigor
