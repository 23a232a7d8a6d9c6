// SPDX-License-Identifier: MIT
// Solution of assignment A0: the kinetic energy of a rigid body.
#include "formulas/pipeline.hpp"

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    const double M = mass;
    const Vector3d& V = velocity;
    const Matrix3d& I = inertia;
    const Vector3d& w = angular_velocity;

    // E = ½ M V·V + ½ ω·I ω
    return 0.5 * M * V.dot(V) + 0.5 * w.dot(I * w);
}

} // namespace rigor
