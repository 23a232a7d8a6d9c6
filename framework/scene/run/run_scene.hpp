// SPDX-License-Identifier: MIT
#pragma once

#include "scene/run/make_world.hpp"
#include "scene/trajectory/writer.hpp"

#include <utility>
#include <vector>

namespace rigor {

/// The steps after which a run records its state: those of the frames, or every step.
enum class Record { frames, every_step };

/// Runs a scene and passes the bytes of its trajectory to `write`, one record at a time. With
/// `Record::frames`, frame k is the state after the step whose end is nearest to the time
/// k/frames_per_second; frame 0 is the initial state.
void run_scene(const Scene& scene, Record record, const ByteSink& write,
               const RunSettings& settings = {});

/// A time [s] and the states of all bodies at that time.
using Moment = std::pair<double, std::vector<RigidState>>;

/// For each moment of `starts`, the states after `steps` time steps. At each of these moments all
/// bodies are awake, nothing is known of earlier contacts, and deformable solids are in their
/// initial state.
/// @param starts  each time is a multiple of the time step, and each moment has a state for every
///     body
std::vector<std::vector<RigidState>> advance(const Scene& scene, const std::vector<Moment>& starts,
                                             int steps, const RunSettings& settings = {});

} // namespace rigor
