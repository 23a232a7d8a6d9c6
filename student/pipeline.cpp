// SPDX-License-Identifier: MIT
// Assignment A0. Read: assignments/a0-pipeline/README.md, then framework/formulas/pipeline.hpp.
// Check: ./rigor check pipeline
#include "formulas/pipeline.hpp"

namespace rigor {

// A0.1  E = ½ M V·V + ½ ω·I ω
double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    throw NotImplemented("pipeline::kinetic_energy");
}

} // namespace rigor
