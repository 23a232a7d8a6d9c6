// SPDX-License-Identifier: MIT
// A formula that ends the main thread but not the process.
#include "formulas/kinematics.hpp"

#include <pthread.h>

namespace rigor {

Matrix3d cross_matrix(const Vector3d&)
{
    pthread_exit(nullptr);
}

} // namespace rigor
