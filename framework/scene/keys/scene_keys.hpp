// SPDX-License-Identifier: MIT
#pragma once

#include "scene/description/scene.hpp"
#include "scene/language/keys.hpp"

namespace rigor {

/// Reads a scene from a file or from a text.
/// @throws InputError, such as `file:line: expected …, found …`
Scene load_scene(const std::filesystem::path& file);
Scene parse_scene(const std::string& text, const std::string& file_name);

/// All keys of the scene language, object by object, for the documentation and its test.
std::vector<KeyMeaning> scene_language();

} // namespace rigor
