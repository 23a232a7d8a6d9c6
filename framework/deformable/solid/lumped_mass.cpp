// SPDX-License-Identifier: MIT
// Computes the volume of the material in each element, and lumps a quarter of the element's mass at
// each of its four nodes.
#include "deformable/solid/lumped_mass.hpp"

#include "geometry/tetrahedra/tetrahedra.hpp"

namespace rigor {

std::vector<double> lumped_masses(const Deformable& solid)
{
    std::vector<double> masses(solid.rest.vertices.size(), 0.0);
    for (int e = 0; e < static_cast<int>(solid.rest.tetrahedra.size()); ++e)
        for (const int v : solid.rest.tetrahedra[e])
            masses[v] += solid.material.density * matter_volume(solid, e) / 4;
    return masses;
}

double matter_volume(const Deformable& solid, int element)
{
    const double V = tetrahedron_volume(solid.rest, element);
    return solid.embedded.fractions.empty() ? V : solid.embedded.fractions[element] * V;
}

} // namespace rigor
