// SPDX-License-Identifier: MIT
// Ends the program without running any destructor.
#include "formulas/kinematics.hpp"

#include <unistd.h>

namespace rigor {

Matrix3d cross_matrix(const Vector3d&)
{
    _exit(3);
}

} // namespace rigor
