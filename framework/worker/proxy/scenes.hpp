// SPDX-License-Identifier: MIT
// Runs of scenes on this side, with the formulas of the worker under test.
#pragma once

#include "scene/run/run_scene.hpp"

namespace rigor {

/// As `run_scene`. @throws NotImplemented, FormulaMissing, WorkerFailure, NotFinite
void run_scene_with_worker(const Scene& scene, Record record, const ByteSink& write);

/// As `advance`. @throws as above
std::vector<std::vector<RigidState>>
advance_with_worker(const Scene& scene, const std::vector<Moment>& starts, int steps);

} // namespace rigor
