// SPDX-License-Identifier: MIT
#pragma once

#include "deformable/solid/deformable.hpp"
#include "rigid/world.hpp"

namespace rigor {

/// Rigid bodies and deformable solids.
struct DeformableWorld {
    World rigid; // its gravity and time are those of all
    std::vector<Deformable> solids;
};

} // namespace rigor
