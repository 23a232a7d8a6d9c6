// SPDX-License-Identifier: MIT
// The scene of `bench pile`, which each engine can run: unit cubes are dropped into an open box. At
// the end their penetration is measured, in the same way for all engines.
#pragma once

#include "geometry/shapes/pose.hpp"
#include "rigid/bodies/world.hpp"

#include <functional>
#include <string>
#include <vector>

namespace rigor {

inline constexpr double pile_step = 1.0 / 60; // [s]
inline constexpr double pile_friction = 0.5;  // for every pair
inline constexpr double pile_density = 1000;  // [kg/m³]
inline constexpr double pile_gravity = -9.81; // along y [m/s²]

/// A box that does not move.
struct Wall {
    Vector3d center = Vector3d::Zero(), size = Vector3d::Zero(); // [m]
};

/// The start of the unit cubes, and the open box around them.
struct PileStart {
    std::vector<Pose> cubes;
    std::vector<Quaternion> orientations; // the same, for engines that keep quaternions
    std::vector<Wall> walls;              // the floor first
    double half_width = 0;                // half the inner width of the box along x and z [m]
};

/// A grid of side³ cubes at a distance of 1.5 m. Each layer is shifted at random by up to 0.5 m
/// along x and z, so that columns do not fall straight onto themselves. Each cube is shifted at
/// random by up to 0.1 m and rotated by up to 15°. No cube touches another. Every engine gets the
/// same bits.
PileStart pile_start(int side, unsigned seed = 1);

/// The result of an engine.
struct PileRun {
    std::vector<double> step_seconds; // one for each step; setup is not counted
    std::vector<Pose> cubes;          // at the end
    double asleep = 0;                // fraction of the cubes that sleep at the end
};

/// The penetration depths of the cubes of a pile, with each other and with the walls. The depth of
/// two boxes is the shortest displacement that separates them, the smallest overlap along the 15
/// axes of Gottschalk, Lin and Manocha (1996).
struct PileMeasure {
    double mean = 0,
           largest = 0; // over all pairs closer than 1 cm; without overlap the depth is 0 [m]
    int pairs = 0;      // number of pairs closer than 1 cm
    int escaped = 0;    // cubes whose center is outside of the box, or is not finite
    double height = 0;  // height of the center of mass [m]
};
PileMeasure measure_pile(const PileStart& start, const std::vector<Pose>& cubes);

/// The options of a run.
struct PileOptions {
    int steps = 300, threads = 1;
    bool sleep = true;
};

/// Our engine, with the formulas of the reference, `ContactMethod::simultaneous`, and all skips
/// except sleep, which `options` sets.
PileRun pile_rigor(const PileStart& start, const PileOptions& options);
World pile_world(const PileStart& start, const PileOptions& options);

/// The other engines with their default settings; the friction of a pair is `pile_friction`. Bullet
/// puts resting bodies to sleep unless `options` forbids it. ODE uses dWorldQuickStep and never
/// does.
PileRun pile_bullet(const PileStart& start, const PileOptions& options);
PileRun pile_ode(const PileStart& start, const PileOptions& options);

/// Calls `run` in a forked process, so that no run sees the memory that another one left behind.
///
/// @throws std::runtime_error if the process did not finish its run
PileRun in_fresh_process(const std::function<PileRun()>& run);

} // namespace rigor
