// SPDX-License-Identifier: MIT
#pragma once

#include "deformable/step/deformable_world.hpp"

namespace rigor {

/// One time step: the nodes' motion with their contacts, plastic flow, fracture; then the rigid bodies'
/// step. Work is counted in world.rigid.counters.
///
/// Of a solid with a strength, an element that is inside out for longer than it takes to turn back, and
/// that no handle holds, has failed: it comes off along all its faces, a crack, and gets back the shape that
/// it has without stress. Mass, volume, momentum and angular momentum stay; energy is lost.
/// @return the contacts among rigid bodies that got an impulse
std::vector<ContactRecord> step(DeformableWorld& world, double time_step);

} // namespace rigor
