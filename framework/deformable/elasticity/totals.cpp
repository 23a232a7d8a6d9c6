// SPDX-License-Identifier: MIT
// Computes mass, momenta and kinetic energy of a solid as sums over its nodes, then volume and
// elastic energy as sums over its elements.
#include "deformable/elasticity/totals.hpp"

#include "deformable/elasticity/element.hpp"
#include "deformable/solid/lumped_mass.hpp"

namespace rigor {

DeformableTotals totals(const Deformable& solid)
{
    DeformableTotals sum;
    Vector3d mx = Vector3d::Zero(); // Σ m x
    for (std::size_t i = 0; i < solid.masses.size(); ++i) {
        const double m = solid.masses[i];
        const Vector3d &x = solid.positions[i], &v = solid.velocities[i];
        sum.mass += m;
        sum.kinetic_energy += 0.5 * m * v.squaredNorm();
        sum.momentum += m * v;
        sum.angular_momentum += m * x.cross(v);
        mx += m * x;
    }
    if (sum.mass > 0) sum.center_of_mass = mx / sum.mass;
    for (int e = 0; e < static_cast<int>(solid.rest.tetrahedra.size()); ++e) {
        const double V = matter_volume(solid, e);
        sum.volume += V;
        sum.elastic_energy += V * energy_density(solid, e);
    }
    return sum;
}

} // namespace rigor
