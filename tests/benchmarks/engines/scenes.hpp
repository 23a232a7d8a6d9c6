// SPDX-License-Identifier: MIT
// The scenes of contact that `bench accuracy` and `bench contact` share.
#pragma once

#include "engine.hpp"

namespace rigor {

inline constexpr double standard_gravity = 9.81; // [m/s²]

/// A unit cube of 1 kg that lies on a plane which falls towards +x, at `degrees` to the horizontal.
Trial block_on_incline(double degrees, double friction);

/// How far the block of `block_on_incline` has come down the slope [m].
double way_down(const Trial& trial, const TrialMotion& motion);

/// A ball of radius 0.1 m, its lowest point 1 m above the floor.
Trial dropped_ball(double restitution);

/// Heights of the lowest point of that ball at the top of its first `n` bounces [m]: y + v²/2g where
/// |v| is least. Fewer if it bounced less often.
/// @param path  after every step
std::vector<double> bounce_heights(const std::vector<TrialMotion>& path, int n);

/// Unit cubes of 1 kg on top of each other, friction 0.5.
/// @param spread  each is off by at most this along x and z, seeded [m]
Trial cube_stack(int cubes, double spread = 0);

/// How a stack stands.
struct StackFigures {
    bool standing = true;    // every cube within half an edge of its place
    double drift = 0;        // the largest way of a cube along x and z [m]
    double sinking = 0;      // the largest way down [m]
    double penetration = 0;  // of a cube's lowest corner below the top of the one beneath [m]
    double displacement = 0; // the largest way of a cube [m]
};
StackFigures stack_figures(const Trial& trial, const TrialEngine& engine);

} // namespace rigor
