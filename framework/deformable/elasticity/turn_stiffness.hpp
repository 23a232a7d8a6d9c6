// SPDX-License-Identifier: MIT
// How the stress of an element resists that the element turns, for the linear system of an
// implicit step.
#pragma once

#include "formulas/types.hpp"

#include <array>

namespace rigor {

/// A term of the geometric stiffness K_g of an element: for displacements u of its four corners,
/// uᵀ K_g u = (Σ cᵢ·uᵢ)². The cᵢ say how far the displacements turn the element about one axis.
struct TurnStiffness {
    int element = 0;
    std::array<Vector3d, 4> c; // [√(N/m)]
};

} // namespace rigor
