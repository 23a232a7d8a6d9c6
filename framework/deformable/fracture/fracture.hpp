// SPDX-License-Identifier: MIT
// Cracks where the stress of a solid exceeds its strength.
#pragma once

#include "deformable/elasticity/element_workspace.hpp"

namespace rigor {

/// Opens cracks where the largest principal value of the smoothed stress exceeds the strength. The
/// most stressed elements crack first. In one step a solid gets at most one crack at each node, and
/// at most `most_cracks` in all. The mesh is then split along the cracks.
///
/// With the optimization `stress_bound`, eigenvalues are not computed where a bound shows that
/// there is no crack. No eigenvalue exceeds the mean stress plus ⅔ of the von Mises stress, and no
/// eigenvalue of a smoothed stress exceeds the largest eigenvalue of the stresses that were
/// averaged.
void fracture(Deformable& solid, const ElementWorkspace& work, World& world);

/// The largest number of cracks of a solid in one step. A crack changes the stress around it, but
/// only the next step can take this change into account. More cracks at once would break the solid
/// into too many pieces. The value was chosen by trial.
inline constexpr int most_cracks = 64;

} // namespace rigor
