// SPDX-License-Identifier: MIT
// Runs of whole scenes with the formulas of the worker under test.
#pragma once

#include "scene/run/run_scene.hpp"
#include "scene/trajectory/statistics.hpp"
#include "support/close.hpp"

#include <optional>
#include <string>

namespace rigor::testing {

/// The trajectory of a shipped scene, such as `a4-collision/rod_tip`, with every step of it.
/// @param time_step  replaces that of the scene, to measure orders of convergence [s]
/// @param changes    a JSON object of keys to replace, such as `{"contact": "simultaneous"}`
/// @throws as run_scene_with_worker
Trajectory run_scene(const std::string& name, std::optional<double> time_step = {},
                     const std::string& changes = "{}");

/// Changes that give the boxes of a shipped scene sizes and densities that are drawn from the first
/// seed, near to those in the file. So the mass properties of its bodies are no constants.
std::string other_boxes(const std::string& scene_name);

/// Changes that make a step depend on the bodies' states alone, and that keep rounding from
/// changing the number of sweeps.
inline constexpr const char* without_memory =
    R"({"optimisations": {"warm_start": false, "sleep": false, "early_exit": false}})";

/// Index of a body by its name. Throws std::out_of_range with the name if there is none.
int body_index(const Trajectory& trajectory, const std::string& name);

/// The state of a body at the end of the run.
RigidState last_state(const Trajectory& trajectory, const std::string& name);

/// Angle of the rotation between two orientations [rad], 0 … π. It is exact near 0, since it uses
/// atan2 and not acos.
double angle_between(const Quaternion& a, const Quaternion& b);

/// The number of time steps up to a frame.
inline double steps_of(const Frame& frame)
{
    return static_cast<double>(frame.step);
}

/// Checks every step of a run from the state before it: the worker under test and the oracle both
/// take that one step. A wrong step does not affect the later ones, and chaos does not matter. Both
/// run `without_memory`. The test compares X, q (up to its sign), V and L of every body, class R,
/// and names step, body and quantity.
///
/// A wrong step is left out if rounding alone decides it: if among hundreds of neighboring states
/// there is one from which the reference gets another result. Fewer than half of the steps may be
/// left out. Needs an oracle.
///
/// @param changes  a JSON object of keys to replace in the scene
void check_every_step(const std::string& scene_name, const std::string& changes = "{}");

/// Checks a whole run with deformable solids: compares the nodes of the worker under test with
/// those of the oracle, class R with `multiple` eps. It fits only motion in which small differences
/// die out, such as that of damped solids that handles pull.
void check_solids(const std::string& scene_name, double multiple,
                  const std::string& changes = "{}");

} // namespace rigor::testing
