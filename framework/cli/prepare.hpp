// SPDX-License-Identifier: MIT
// What commands do before their own work: build an implementation, find a scene.
#pragma once

#include "grading/implementation.hpp"

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
