// SPDX-License-Identifier: MIT
#include "geometry/mesh_files/surface_files.hpp"

#include "geometry/mesh_files/obj.hpp"
#include "geometry/mesh_files/off.hpp"
#include "geometry/mesh_files/stl.hpp"

#include <algorithm>
#include <cctype>
#include <string>

namespace rigor {

SurfaceText read_surface(std::string_view bytes, std::string_view file_name)
{
    std::string ending(
        file_name.substr(file_name.size() - std::min<std::size_t>(4, file_name.size())));
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (ending == ".off") return read_off(bytes);
    if (ending == ".stl") return read_stl(bytes);
    return read_obj(bytes);
}

} // namespace rigor
