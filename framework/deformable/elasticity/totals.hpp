// SPDX-License-Identifier: MIT
// Mass, volume, energies and momenta of a solid.
#pragma once

#include "deformable/solid/deformable.hpp"

namespace rigor {

struct DeformableTotals {
    double mass = 0, volume = 0; // mass [kg], volume of the material at rest [m³]
    double kinetic_energy = 0, elastic_energy = 0; // [J]
    Vector3d momentum = Vector3d::Zero();          // [kg m/s]
    Vector3d angular_momentum = Vector3d::Zero();  // about the origin [kg m²/s]
    Vector3d center_of_mass = Vector3d::Zero();    // [m]
};
DeformableTotals totals(const Deformable& solid);

} // namespace rigor
