// SPDX-License-Identifier: MIT
// A formula that ends the program with _exit, without running any destructor.
#include "formulas/kinematics.hpp"

#include <unistd.h>

namespace rigor {

Matrix3d cross_matrix(const Vector3d&)
{
    _exit(3);
}

} // namespace rigor
