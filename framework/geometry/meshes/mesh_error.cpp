// SPDX-License-Identifier: MIT
#include "geometry/meshes/mesh_error.hpp"

#include <sstream>

namespace rigor {

std::string number_text(double number)
{
    std::ostringstream stream;
    stream << number;
    return stream.str();
}

} // namespace rigor
