// SPDX-License-Identifier: MIT
// Runs of whole scenes in the worker under test.
#pragma once

#include "scene/run/run_scene.hpp"
#include "scene/trajectory/statistics.hpp"
#include "support/close.hpp"

#include <optional>
#include <string>

namespace rigor::testing {

/// The trajectory of a shipped scene, `a4-collision/rod_tip`, every step of it.
/// @param time_step  instead of the scene's own [s]; for convergence orders
/// @param changes    a JSON object of keys to replace, `{"contact": "simultaneous"}`
/// @throws as Worker::run_scene; NotFinite if a recorded number is not finite
Trajectory run_scene(const std::string& name, std::optional<double> time_step = {},
                     const std::string& changes = "{}");

/// Changes that leave a step nothing but the bodies' states to depend on, and no number of sweeps
/// that rounding decides.
inline constexpr const char* without_memory =
    R"({"skip": {"warm_start": false, "sleep": false, "early_exit": false}})";

/// Index of a body by its name. Throws std::out_of_range with the name if there is none.
int body_index(const Trajectory& trajectory, const std::string& name);

/// The state of a body at the end of the run.
RigidState last_state(const Trajectory& trajectory, const std::string& name);

/// Rotation by which two orientations differ [rad], 0 … π, exact near 0 (atan2, not acos).
double angle_between(const Quaternion& a, const Quaternion& b);

/// The time steps that led to a frame.
inline double steps_of(const Frame& frame)
{
    return static_cast<double>(frame.step);
}

/// Every step of a run, judged from the state before it: the worker under test and the oracle both take that one step.
/// One wrong step is one wrong step, and chaos does not matter. Both run `without_memory`. Compares X, q (up to sign), V and L of every body, class
/// R, and names step, body and quantity. A step is left out where rounding alone decides what the reference does (from
/// next door it goes elsewhere); that must be fewer than half of them. Needs an oracle.
/// @param changes  a JSON object of keys to replace in the scene
void check_every_step(const std::string& scene_name, const std::string& changes = "{}");

/// A run with deformable solids, from beginning to end: the nodes of the worker under test against those of the oracle,
/// class R with `multiple` eps. Only for motion that forgets: pulled by handles and damped.
void check_solids(const std::string& scene_name, double multiple);

} // namespace rigor::testing
