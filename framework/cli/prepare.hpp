// SPDX-License-Identifier: MIT
// What commands do before their own work: build an implementation, find a scene.
#pragma once

#include "grading/run_tests.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace rigor {

/// The implementation, its worker built if it was stale, with a progress bar.
/// @param asked  see `build_implementation`
/// @throws InputError if there is no such implementation
Implementation prepared_implementation(const std::string& with,
                                       const std::vector<std::string>& asked = {});

/// The same for a command that needs a worker. @throws InputError also with the compiler's words if it does not compile
Implementation working_implementation(const std::string& with);

/// Targets of ours, built if they are stale, with a progress bar.
void prepare_targets(const std::vector<std::string>& targets);

/// The graded tests and their oracle, built if they are stale, with a progress bar.
GradingRun prepared_grading_run();

/// Runs a program of ours: its lines of stdout become ours as they come. Its stderr is ours, so that
/// JSON is alone on stdout.
/// @return its exit status @throws std::runtime_error if it crashed
int run_program(const std::vector<std::string>& arguments);

struct SceneFile {
    std::filesystem::path file;
    std::string name; // "a4-collision/hundred_boxes"
};

/// All scenes that ship, by assignment and name.
std::vector<SceneFile> shipped_scenes();

/// A scene's file: a path, `a4-collision/hundred_boxes`, or a name that no other assignment has.
/// @throws InputError with the nearest name
std::filesystem::path find_scene(const std::string& text);

} // namespace rigor
