// SPDX-License-Identifier: MIT
// The case of `bench pile`, run by whoever can: unit cubes dropped into an open box, and how they
// lie at the end.
#pragma once

#include "geometry/shapes/pose.hpp"
#include "rigid/bodies/world.hpp"

#include <functional>
#include <string>
#include <vector>

namespace rigor {

inline constexpr double pile_step = 1.0 / 60; // [s]
inline constexpr double pile_friction = 0.5;  // of every pair
inline constexpr double pile_density = 1000;  // [kg/m³]
inline constexpr double pile_gravity = -9.81; // along y [m/s²]

/// A box that does not move.
struct Wall {
    Vector3d center = Vector3d::Zero(), size = Vector3d::Zero(); // [m]
};

/// Where unit cubes start, and the open box around them.
struct PileStart {
    std::vector<Pose> cubes;
    std::vector<Quaternion> orientations; // the same, for engines that keep quaternions
    std::vector<Wall> walls;              // the floor first
    double half_width = 0;                // of the room inside, along x and z [m]
};

/// A grid of side³ cubes, 1.5 m from one to the next; at random each layer is shifted by up to 0.5 m
/// along x and z, so that no column stands on itself, each cube by up to 0.1 m, and turned by up to
/// 15°. None touches another. The same bits for every engine.
PileStart pile_start(int side, unsigned seed = 1);

/// What an engine made of it.
struct PileRun {
    std::vector<double> step_seconds; // of every step; setting up is not counted
    std::vector<Pose> cubes;          // at the end
    double asleep = 0;                // share of the cubes that sleep at the end
};

/// How deep the cubes of a pile sink into each other and into the walls, in every engine by the same
/// measure: the depth of two boxes is the shortest way that parts them (the least overlap along the 15
/// axes of Gottschalk, Lin and Manocha 1996).
struct PileMeasure {
    double mean = 0,
           largest = 0; // over all pairs closer than 1 cm; those that do not overlap count 0 [m]
    int pairs = 0;      // closer than 1 cm
    int escaped = 0;    // cubes whose center is outside of the room, or that are not numbers
    double height = 0;  // of the center of mass [m]
};
PileMeasure measure_pile(const PileStart& start, const std::vector<Pose>& cubes);

/// Who runs it, and how.
struct PileOptions {
    int steps = 300, threads = 1;
    bool sleep = true;
};

/// All formulas are the reference's; contacts by `ContactMethod::simultaneous`, all skips on but sleep.
PileRun pile_rigor(const PileStart& start, const PileOptions& options);
World pile_world(const PileStart& start, const PileOptions& options);

/// The others' defaults; friction so that it is `pile_friction` for a pair. Bullet puts resting bodies to
/// sleep unless it is told not to; ODE steps with dWorldQuickStep and does not.
PileRun pile_bullet(const PileStart& start, const PileOptions& options);
PileRun pile_ode(const PileStart& start, const PileOptions& options);

/// `run` in a process of its own, a copy of this one as it is now: so that no run sees what another one
/// left behind.
///
/// @throws std::runtime_error if it did not come to its end
PileRun in_fresh_process(const std::function<PileRun()>& run);

} // namespace rigor
