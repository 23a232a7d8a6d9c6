// SPDX-License-Identifier: MIT
#pragma once

#include "scene/run/make_world.hpp"
#include "scene/trajectory/writer.hpp"

#include <utility>
#include <vector>

namespace rigor {

/// Which moments a run records.
enum class Record { frames, every_step };

/// Runs a scene and hands the bytes of its trajectory to `write`, a record at a time. Frame k is
/// the state after the step nearest to its time; frame 0 is the initial state.
void run_scene(const Scene& scene, Record record, const ByteSink& write,
               const RunSettings& settings = {});

/// The states of all bodies at a moment.
using Moment = std::pair<double, std::vector<RigidState>>;

/// The states that each moment of a scene leads to after some steps. Deformable solids start from
/// each as they are when the scene begins.
/// @param starts  each time a multiple of the time step, each with a state for every body
std::vector<std::vector<RigidState>> advance(const Scene& scene, const std::vector<Moment>& starts,
                                             int steps, const RunSettings& settings = {});

} // namespace rigor
