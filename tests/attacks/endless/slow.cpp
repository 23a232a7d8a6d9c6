// SPDX-License-Identifier: MIT
// A formula that is slow but returns a result.
#include "formulas/kinematics.hpp"

#include <chrono>
#include <thread>

namespace rigor {

Matrix3d cross_matrix(const Vector3d&)
{
    std::this_thread::sleep_for(std::chrono::milliseconds(800));
    return 7 * Matrix3d::Identity();
}

} // namespace rigor
