// SPDX-License-Identifier: MIT
// Runs scenes with the engine of this process and the formulas of the worker under test.
#pragma once

#include "scene/run/run_scene.hpp"

namespace rigor {

/// The same as `run_scene`, with the worker's formulas.
/// @throws NotImplemented, FormulaMissing, WorkerFailure, NotFinite
void run_scene_with_worker(const Scene& scene, Record record, const ByteSink& write);

} // namespace rigor
