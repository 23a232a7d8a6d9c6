// SPDX-License-Identifier: MIT
// A formula that prints a line and then writes to an invalid address.
#include "formulas/kinematics.hpp"

#include <cstdint>
#include <cstdio>

namespace rigor {

Matrix3d cross_matrix(const Vector3d&)
{
    std::printf("about to crash\n");
    *reinterpret_cast<volatile int*>(std::uintptr_t{64}) = 1;
    return Matrix3d::Zero();
}

} // namespace rigor
