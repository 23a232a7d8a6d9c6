// SPDX-License-Identifier: MIT
// A world of rigid bodies and deformable solids.
#pragma once

#include "deformable/solid/deformable.hpp"
#include "rigid/bodies/world.hpp"

namespace rigor {

struct SolidAtHeight {
    double height;     // height of the mean of its nodes [m]
    std::size_t solid; // index into `solids`
};

struct DeformableWorld {
    World rigid; // its gravity and time also apply to the solids
    std::vector<Deformable> solids;
    std::vector<SolidAtHeight> from_top; // memory of `step`: the order of its last step
};

} // namespace rigor
