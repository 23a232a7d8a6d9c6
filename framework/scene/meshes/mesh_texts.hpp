// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace rigor {

/// The text of a scene, with the texts of all mesh files that it names added under "meshes". The
/// scene is then complete wherever it is sent. Lines keep their numbers. A text that names no file,
/// or has the key "meshes" already, is returned unchanged.
///
/// @param scene_file  file of the scene; the paths of the mesh files are relative to its folder
/// @throws Mistake for an error in the text of the scene, such as the name of a missing file
/// @throws InputError for an error in a mesh file, with its line
std::string with_mesh_texts(const std::string& text, const std::filesystem::path& scene_file);

} // namespace rigor
