// SPDX-License-Identifier: MIT
// Runs scenes with the engine of this process and the formulas of the worker under test.
#pragma once

#include "scene/run/run_scene.hpp"

namespace rigor {

/// Runs a scene as `run_scene` does, with the formulas of the worker under test.
/// @throws NotImplemented, FormulaMissing, WorkerFailure, NotFinite; OracleFailure if the reference
///     replaces formulas and fails; std::out_of_range as in answer_sizes.hpp; std::domain_error as
///     `step` does
void run_scene_with_worker(const Scene& scene, Record record, const ByteSink& write);

} // namespace rigor
