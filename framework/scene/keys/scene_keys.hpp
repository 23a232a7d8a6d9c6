// SPDX-License-Identifier: MIT
#pragma once

#include "scene/description/scene.hpp"
#include "scene/language/keys.hpp"

namespace rigor {

/// @throws InputError `file:line: expected …, found …`
Scene load_scene(const std::filesystem::path& file);
Scene parse_scene(const std::string& text, const std::string& file_name);

/// Every key of the language, object by object, for the documentation and its test.
std::vector<KeyMeaning> scene_language();

} // namespace rigor
