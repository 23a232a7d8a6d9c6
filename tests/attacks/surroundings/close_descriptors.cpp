// SPDX-License-Identifier: MIT
// A formula that closes all file descriptors and then returns a result.
#include "formulas/kinematics.hpp"

#include <unistd.h>

namespace rigor {

Matrix3d cross_matrix(const Vector3d&)
{
    for (int fd = 0; fd < 1024; ++fd)
        close(fd);
    return 7 * Matrix3d::Identity();
}

} // namespace rigor
