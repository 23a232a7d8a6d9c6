// SPDX-License-Identifier: MIT
// A formula that prints without end.
#include "formulas/kinematics.hpp"

#include <cstdio>

namespace rigor {

Matrix3d cross_matrix(const Vector3d&)
{
    for (;;)
        std::puts("I am still here, and I have a lot to say.");
}

} // namespace rigor
