// SPDX-License-Identifier: MIT
// Preparation that several commands need, such as to build an implementation or to find a scene.
#pragma once

#include "grading/run_tests.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace rigor {

/// An implementation of the formulas. Its worker, which is the program that runs them, is built if
/// necessary, with a progress bar.
/// @param with  "student", "reference" or a folder
/// @throws InputError if there is no such implementation
Implementation prepared_implementation(const std::string& with);

/// Like `prepared_implementation`, for a command that runs scenes.
/// @throws InputError also if a file of the implementation does not compile; the message has the
///     compiler's errors
Implementation working_implementation(const std::string& with);

/// Builds targets of the framework that are out of date and shows a progress bar.
void prepare_targets(const std::vector<std::string>& targets);

/// The graded tests and, if possible, their oracle, which is the worker of the reference. Shows a
/// progress bar while they are built.
GradingRun prepared_grading_run();

/// Builds what all submissions share, with a progress bar: the framework's part of a worker, and
/// the objects of student/, which replace files that a submission lacks.
void prepare_submissions();

/// Runs a program of the framework and prints each line of its stdout as soon as it arrives. The
/// program's stderr goes to the stderr of this process, so that it cannot mix with JSON on stdout.
/// @return the exit status of the program
/// @throws std::runtime_error if a signal ended the program
int run_program(const std::vector<std::string>& arguments);

/// The error message if `run_program` returns an unexpected status. It says that this is a fault of
/// the framework, and how to run the program by itself.
std::string program_failed(const std::string& name, int status);

/// Makes the folder that --out names, if it is missing.
/// @param content  what will be written there, such as "the figures"
/// @throws InputError if `out` is empty, or if the folder cannot be made or written
void require_folder(const std::string& out, const std::string& content);

struct SceneFile {
    std::filesystem::path file;
    std::string name; // with its assignment, such as "a4-collision/hundred_boxes"
};

/// All scenes of the project, sorted by assignment and name.
std::vector<SceneFile> shipped_scenes();

/// The file of a scene. `text` is its path, its assignment and name such as
/// `a4-collision/hundred_boxes`, or only its name if no other assignment has a scene of this name.
/// @throws InputError if there is no such scene, with a suggestion of a similar name, or if several
///     scenes have this name
std::filesystem::path find_scene(const std::string& text);

} // namespace rigor
