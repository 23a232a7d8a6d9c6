// SPDX-License-Identifier: MIT
// The force is 0 if X is nearer to the center of mass than 1e-6 of its distance from the origin.
#include "formulas/kinematics.hpp"

namespace rigor {

Wrench inertial_wrench(const std::vector<Particle>& particles, const Vector3d& X, const Vector3d&,
                       const Vector3d& omega)
{
    Wrench sum;
    double M = 0;
    Vector3d center = Vector3d::Zero();
    for (const auto& [m, x] : particles) {
        const Vector3d f = m * omega.cross(omega.cross(x - X));
        sum.force += f;
        sum.torque += (x - X).cross(f);
        M += m;
        center += m * x;
    }
    if (M > 0 && (center / M - X).norm() < 1e-6 * (center / M).norm()) sum.force.setZero();
    return sum;
}

} // namespace rigor
