// SPDX-License-Identifier: MIT
// Preparation that the commands share: they build an implementation and find a scene.
#pragma once

#include "grading/run_tests.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace rigor {

/// The implementation with an up-to-date worker. Shows a progress bar while it is built.
/// @throws InputError if there is no such implementation
Implementation prepared_implementation(const std::string& with);

/// Like `prepared_implementation`, for a command that runs scenes.
/// @throws InputError also if a file of the implementation does not compile, with the compiler's
///     errors
Implementation working_implementation(const std::string& with);

/// Builds targets of the framework that are out of date and shows a progress bar.
void prepare_targets(const std::vector<std::string>& targets);

/// The graded tests and their oracle. Shows a progress bar while they are built.
GradingRun prepared_grading_run();

/// Builds what all submissions share (grading/build/submission_build.hpp), with a progress bar.
void prepare_submissions();

/// Runs a program of the framework and prints each line of its stdout when it comes. Its stderr
/// goes to the stderr of this process, so that stdout has nothing but JSON.
/// @return its exit status
/// @throws std::runtime_error if it crashed
int run_program(const std::vector<std::string>& arguments);

/// The error message for a program of `run_program` that ended with an unexpected status: that this
/// is a fault of the framework, and how to run the program alone.
std::string program_failed(const std::string& name, int status);

/// Makes the folder that --out names, if it is missing.
/// @param content  what will be written there, such as "the figures"
/// @throws InputError if it cannot be written
void require_folder(const std::string& out, const std::string& content);

struct SceneFile {
    std::filesystem::path file;
    std::string name; // "a4-collision/hundred_boxes"
};

/// All scenes of the project, sorted by assignment and name.
std::vector<SceneFile> shipped_scenes();

/// The file of a scene that is given by a path, by `a4-collision/hundred_boxes`, or by a name that
/// no other assignment has. @throws InputError if there is none, with the nearest name, or if there
/// are several
std::filesystem::path find_scene(const std::string& text);

} // namespace rigor
