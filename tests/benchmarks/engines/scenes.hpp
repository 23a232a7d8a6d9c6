// SPDX-License-Identifier: MIT
// The scenes with contact that `bench accuracy` and `bench contact` share.
#pragma once

#include "engine.hpp"

namespace rigor {

inline constexpr double standard_gravity = 9.81; // [m/s²]

/// A unit cube of 1 kg on a plane that slopes down towards +x, at `degrees` to the horizontal.
Trial block_on_incline(double degrees, double friction);

/// The distance that the block of `block_on_incline` has moved down the slope [m].
double way_down(const Trial& trial, const TrialMotion& motion);

/// A ball of radius 0.1 m and 1 kg, with its lowest point 1 m above the floor.
Trial dropped_ball(double restitution);

/// The heights of this ball's lowest point at the top of its first `n` bounces [m], fewer if it
/// bounced less often. The height is y + v²/2g of the sample with the smallest |v|.
///
/// @param path  the motion of the ball after every step
std::vector<double> bounce_heights(const std::vector<TrialMotion>& path, int n);

/// Unit cubes of 1 kg on top of each other, friction 0.5.
///
/// @param spread  largest random offset of each cube along x and z, from a fixed seed [m]
Trial cube_stack(int cubes, double spread = 0);

/// The state of a stack, compared with its start.
struct StackFigures {
    bool standing = true;    // every cube is within half an edge of its place
    double drift = 0;        // largest horizontal displacement of a cube [m]
    double sinking = 0;      // largest downward displacement [m]
    double penetration = 0;  // largest depth of a cube's corner in the one beneath [m]
    double displacement = 0; // largest displacement of a cube [m]
};
StackFigures stack_figures(const Trial& trial, const TrialEngine& engine);

} // namespace rigor
