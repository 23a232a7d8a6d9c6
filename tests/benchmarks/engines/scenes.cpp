// SPDX-License-Identifier: MIT
// The scenes that several benchmarks share, and the figures that are measured in them.
#include "scenes.hpp"

#include "support/random.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigor {

namespace {

constexpr double ball_radius = 0.1; // [m]
constexpr unsigned stack_seed = 1;

Trial on_ground(double friction, double restitution)
{
    Trial trial;
    trial.has_ground = true;
    trial.friction = friction;
    trial.restitution = restitution;
    trial.gravity = Vector3d(0, -standard_gravity, 0);
    return trial;
}

// The depth of a unit cube's lowest corner below the top face of the unit cube beneath [m].
double depth_in(const TrialMotion& upper, const TrialMotion& lower)
{
    const Vector3d n = lower.orientation * Vector3d::UnitY();
    const Vector3d half = upper.orientation.conjugate() * n / 2;
    const double lowest = n.dot(upper.position - lower.position) - half.cwiseAbs().sum();
    return 0.5 - lowest;
}

} // namespace

Trial block_on_incline(double degrees, double friction)
{
    Trial trial = on_ground(friction, 0);
    trial.ground = Eigen::AngleAxisd(-degrees * std::numbers::pi / 180, Vector3d::UnitZ());
    TrialBody& block = trial.bodies.emplace_back(solid_cuboid(Vector3d(1, 1, 1), 1));
    block.orientation = trial.ground;
    block.position = trial.ground * Vector3d(0, 0.5, 0);
    return trial;
}

double way_down(const Trial& trial, const TrialMotion& motion)
{
    return (trial.ground * Vector3d::UnitX()).dot(motion.position - trial.bodies[0].position);
}

Trial dropped_ball(double restitution)
{
    Trial trial = on_ground(0, restitution);
    trial.bodies.push_back(solid_ball(ball_radius, 1));
    trial.bodies[0].position = Vector3d(0, 1 + ball_radius, 0);
    return trial;
}

std::vector<double> bounce_heights(const std::vector<TrialMotion>& path, int n)
{
    std::vector<double> heights;
    bool bounced = false;
    for (std::size_t i = 1; i < path.size() && std::ssize(heights) < n; ++i) {
        const double v0 = path[i - 1].velocity.y(), v1 = path[i].velocity.y();
        if (v0 < 0 && v1 > 0) bounced = true;
        if (!bounced || v0 < 0 || v1 >= 0) continue;
        const TrialMotion& top = std::abs(v0) < std::abs(v1) ? path[i - 1] : path[i];
        heights.push_back(top.position.y() - ball_radius +
                          top.velocity.y() * top.velocity.y() / (2 * standard_gravity));
        bounced = false;
    }
    return heights;
}

Trial cube_stack(int cubes, double spread)
{
    Trial trial = on_ground(0.5, 0);
    testing::Random random(stack_seed);
    for (int i = 0; i < cubes; ++i) {
        trial.bodies.push_back(solid_cuboid(Vector3d(1, 1, 1), 1));
        const double x = random.uniform(-spread, spread), z = random.uniform(-spread, spread);
        trial.bodies.back().position = Vector3d(x, 0.5 + i, z);
    }
    return trial;
}

StackFigures stack_figures(const Trial& trial, const TrialEngine& engine)
{
    StackFigures figures;
    TrialMotion beneath;
    beneath.position = Vector3d(0, -0.5, 0); // the ground as a cube
    for (int i = 0; i < std::ssize(trial.bodies); ++i) {
        const TrialMotion cube = engine.motion(i);
        const Vector3d way = cube.position - trial.bodies[i].position;
        figures.standing &= way.norm() < 0.5;
        figures.drift = std::max(figures.drift, std::hypot(way.x(), way.z()));
        figures.sinking = std::max(figures.sinking, -way.y());
        figures.penetration = std::max(figures.penetration, depth_in(cube, beneath));
        figures.displacement = std::max(figures.displacement, way.norm());
        beneath = cube;
    }
    return figures;
}

} // namespace rigor
