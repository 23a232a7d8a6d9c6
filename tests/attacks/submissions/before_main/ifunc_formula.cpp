// SPDX-License-Identifier: MIT
// A formula that a resolver chooses while the program starts. It is right, so it counts.
// expect: 1 passed
#include "formulas/pipeline.hpp"

extern "C" double chosen(double mass, const rigor::Vector3d& velocity,
                         const rigor::Matrix3d& inertia, const rigor::Vector3d& angular_velocity)
{
    return 0.5 * mass * velocity.squaredNorm() +
           0.5 * angular_velocity.dot(inertia * angular_velocity);
}

extern "C" void* choose()
{
    return reinterpret_cast<void*>(&chosen);
}

namespace rigor {

[[gnu::ifunc("choose")]] double kinetic_energy(double, const Vector3d&, const Matrix3d&,
                                               const Vector3d&);

} // namespace rigor
