// SPDX-License-Identifier: MIT
// Opens a Unix socket, which could get a name outside of all folders.
// expect: 0 crashed: tried to open a network socket
#include "formulas/pipeline.hpp"

#include <sys/socket.h>

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    socket(AF_UNIX, SOCK_STREAM, 0);
    return 0;
}

} // namespace rigor
