// SPDX-License-Identifier: MIT
// A formula that overwrites all memory that it shares with the client.
#include "find_channel.hpp"
#include "formulas/kinematics.hpp"

namespace rigor {

Matrix3d cross_matrix(const Vector3d&)
{
    Channel& channel = find_channel();
    std::memset(static_cast<void*>(&channel), 0xff, sizeof channel);
    return Matrix3d::Zero();
}

} // namespace rigor
