// SPDX-License-Identifier: MIT
// Returns a mesh without a vertex and without an element where an element is cut. Lists of no
// length have no wrong index, but the engine would look for the first node of the solid. Two points
// are earned: scenes that crack along faces do not call the formula.
// topic: fracture
// tasks: A7.8
// beside: split_element
// expect: 2 failed: split_element returned 0 parts of tetrahedron 0
#include "formulas/fracture.hpp"

namespace rigor {

SplitMesh split_element(const TetrahedralMesh&, int, const Vector3d&)
{
    return {};
}

} // namespace rigor
