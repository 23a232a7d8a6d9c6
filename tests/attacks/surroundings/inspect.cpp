// SPDX-License-Identifier: MIT
// A formula that prints its process id, its open file descriptors and its environment.
#include "formulas/kinematics.hpp"

#include <cstdio>
#include <fcntl.h>
#include <unistd.h>

extern char** environ;

namespace rigor {

Matrix3d cross_matrix(const Vector3d&)
{
    std::printf("process %d\n", getpid());
    for (int fd = 0; fd < 1024; ++fd)
        if (fcntl(fd, F_GETFD) >= 0) std::printf("descriptor %d\n", fd);
    for (char** variable = environ; *variable; ++variable)
        std::printf("environment %s\n", *variable);
    return Matrix3d::Zero();
}

} // namespace rigor
