// SPDX-License-Identifier: MIT
// The time step of a world with deformable solids.
#pragma once

#include "deformable/step/deformable_world.hpp"

namespace rigor {

/// One time step: motion of the nodes with contacts, plastic flow and fracture of each solid, and
/// then the step of the rigid bodies. world.rigid.counters counts the work.
///
/// In a solid with a finite strength, an element has failed if it stays inverted for longer than it
/// needs to turn back, and no handle holds it. Such an element is separated by cracks along all its
/// faces and gets its shape without stress. Mass, volume, momentum and angular momentum stay the
/// same; energy is lost.
/// @return the contacts between rigid bodies at which an impulse acted
std::vector<ContactRecord> step(DeformableWorld& world, double time_step);

} // namespace rigor
