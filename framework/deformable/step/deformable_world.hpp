// SPDX-License-Identifier: MIT
// A world of rigid bodies and deformable solids.
#pragma once

#include "deformable/solid/deformable.hpp"
#include "rigid/bodies/world.hpp"

namespace rigor {

struct DeformableWorld {
    World rigid; // its gravity and time also apply to the solids
    std::vector<Deformable> solids;
};

} // namespace rigor
