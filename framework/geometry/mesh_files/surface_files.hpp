// SPDX-License-Identifier: MIT
// Triangle meshes from files in the formats OBJ, OFF and STL.
#pragma once

#include "geometry/mesh_files/surface_text.hpp"

namespace rigor {

/// Reads a mesh. The end of the file's name determines the format: OFF for `.off`, STL for `.stl`,
/// otherwise OBJ.
///
/// @throws MeshError
SurfaceText read_surface(std::string_view bytes, std::string_view file_name);

} // namespace rigor
