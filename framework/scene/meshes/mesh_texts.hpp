// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace rigor {

/// A scene's text with the texts of all mesh files that it names under "meshes", so that the scene
/// is whole wherever it is sent. Lines keep their numbers; a text that names no file stays as it
/// is.
///
/// @param scene_file  that the mesh files' paths start from
/// @throws Mistake at the line that names a file which is not there, InputError at a line of a mesh
std::string with_mesh_texts(const std::string& text, const std::filesystem::path& scene_file);

} // namespace rigor
