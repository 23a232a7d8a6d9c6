// SPDX-License-Identifier: MIT
// Gives the copies of cracked elements shares of the volume that are infinite or far below 0, and
// corners that are neither real nor virtual. Masses and the surface follow from them. Two points
// are earned: scenes that crack along faces do not call the formula.
// topic: fracture
// tasks: A7.8
// beside: virtual_nodes
// expect: 2 not_finite|failed
#include "formulas/fracture.hpp"

#include <climits>
#include <limits>

namespace rigor {

EmbeddedMesh virtual_nodes(const TetrahedralMesh& mesh, const std::vector<ElementCrack>& cracks)
{
    static int calls = 0;
    EmbeddedMesh embedded = right_virtual_nodes(mesh, cracks);
    const double shares[] = {-1e300, std::numeric_limits<double>::quiet_NaN(), 1e300};
    embedded.fractions.back() = shares[calls++ % 3];
    for (int& corner : embedded.real.front())
        corner = corner == 1 ? 1 : INT_MAX;
    return embedded;
}

} // namespace rigor
