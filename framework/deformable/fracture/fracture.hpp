// SPDX-License-Identifier: MIT
// Cracks where the stress of a solid exceeds its strength.
#pragma once

#include "deformable/elasticity/element_workspace.hpp"

namespace rigor {

/// Opens cracks where the largest principal value of the smoothed stress exceeds the strength. The
/// most stressed elements crack first, with at most one crack at a node and `most_cracks` in a
/// step. The mesh is then split along the cracks.
///
/// Eigenvalues are not computed where a bound shows that there is no crack. No eigenvalue exceeds
/// the mean stress plus ⅔ of the von Mises stress, and no eigenvalue of a smoothed stress exceeds
/// the largest eigenvalue of the stresses that were averaged.
void fracture(Deformable& solid, const ElementWorkspace& work, World& world);

/// The largest number of cracks in a step. A crack changes the stress around it, but only the next
/// step can take this into account; more cracks at once would splinter the solid. Chosen by trial.
inline constexpr int most_cracks = 64;

} // namespace rigor
