// SPDX-License-Identifier: MIT
// Bodies that a force pulls to the ground, or to each other, and that bounce there: a ball on a
// spring bounces each half period, and each bounce leaves e² of its energy.
#include "classics/problems.hpp"

namespace bounces_on_springs {

using namespace rigor;
using namespace rigor::testing;

namespace {

// The energy of bodies that do not turn, on springs without a rest of stiffness at their ends [J].
double energy_of(const World& world)
{
    double energy = 0;
    for (const RigidBody& body : world.bodies)
        if (!body.is_static)
            energy += body.mass * (body.state.velocity.squaredNorm() / 2 -
                                   world.settings.gravity.dot(body.state.position));
    const auto end = [&](int body, const Vector3d& point) -> Vector3d {
        return body < 0 ? point : point + world.bodies[body].state.position;
    };
    for (const Spring& s : world.springs) {
        const double d = (end(s.body2, s.point2) - end(s.body1, s.point1)).norm();
        energy += s.stiffness * std::pow(d - s.rest_length, 2) / 2;
    }
    return energy;
}

} // namespace

TEST_CASE("classics: a body that a spring pulls to the ground bounces each half period",
          "[classics]")
{
    // The spring has no force where the body touches: at a distance A cos ωt from the ground until
    // the first hit, then A eⁿ |cos ωt| after n hits.
    const double A = 0.3, half = 0.1;
    Sweep sweep;
    for (const Shape& shape : {Shape(Sphere{half}), Shape(Box{{0.2, 0.2, 0.2}})})
        for (const double restitution : {1., 0.95, 0.5})
            for (const double step_angle : {0.03, 0.11, 0.4}) // ω h
                for (const double h : {1 / 60., 0.01, 1 / 480.}) {
                    if (!sweep.takes_next()) continue;
                    CAPTURE(restitution, step_angle, h);
                    const double w = step_angle / h;
                    const Material material{restitution, 0.3};
                    RigidBody body = body_of(shape, {0, half + A, 0}, material);
                    World world = solved({fixed(Box{{100, 1, 100}}, material, {0, -0.5, 0}), body},
                                         {0, 0, 0});
                    world.springs = {
                        {1, -1, {0, 0, 0}, {0, -50, 0}, body.mass * w * w, 0, 50 + half}};
                    const double first = energy_of(world);
                    double off = 0, gained = 0;
                    for (int n = 1; n * h * w < 20; ++n) {
                        step(world, h);
                        const double hits = std::floor(n * h * w / pi + 0.5);
                        const double share = std::pow(restitution, hits);
                        const double y = half + A * share * std::abs(std::cos(w * n * h));
                        off = std::max(off, std::abs(world.bodies[1].state.position.y() - y));
                        gained = std::max(gained, energy_of(world) / first - share * share);
                    }
                    check_at_most(off / A, 0.8 * std::pow(step_angle, 3),
                                  "error of the place, as a share of the swing");
                    check_at_most(gained, 1e-4, "energy beyond e² for each bounce, as a share");
                }
}

TEST_CASE("classics: two balls that a spring pulls together keep their energy", "[classics]")
{
    for (const double restitution : {1., 0.9})
        for (const double mass : {1., 7.})
            for (const double k : {10., 400.})
                for (const double h : {0.02, 0.01, 0.0025}) {
                    CAPTURE(restitution, mass, k, h);
                    const Material material{restitution, 0};
                    World world = solved({ball_of_mass(0.1, 1, {-0.3, 0, 0}, material),
                                          ball_of_mass(0.1, mass, {0.3, 0, 0}, material)},
                                         {0, 0, 0});
                    world.springs = {{0, 1, {0, 0, 0}, {0, 0, 0}, k, 0, 0.1}};
                    const double first = energy_of(world), center = (mass * 0.3 - 0.3) / (1 + mass);
                    double most = 0;
                    for (double t = 0; t < 5; t += h) {
                        step(world, h);
                        most = std::max(most, energy_of(world));
                    }
                    check_at_most(most / first, 1 + 1e-6, "energy, as a share of the first");
                    if (restitution == 1)
                        check_at_least(energy_of(world) / first, 1 - 1e-6, "energy that is left");
                    const Vector3d x1 = world.bodies[0].state.position,
                                   x2 = world.bodies[1].state.position;
                    check_at_most(std::abs((x1.x() + mass * x2.x()) / (1 + mass) - center), 1e-12,
                                  "way of the center of mass [m]");
                }
}

TEST_CASE("classics: two balls on a spring hop for ever", "[classics]")
{
    for (const double k : {100., 1000.})
        for (const double h : {0.01, 0.005, 0.0025}) {
            CAPTURE(k, h);
            const Material material{1, 0};
            World world = solved({fixed(Box{{100, 1, 100}}, material, {0, -0.5, 0}),
                                  ball_of_mass(0.1, 1, {0, 0.6, 0}, material),
                                  ball_of_mass(0.1, 1, {0, 1.1, 0}, material)});
            world.springs = {{1, 2, {0, 0, 0}, {0, 0, 0}, k, 0, 0.5}};
            const double first = energy_of(world);
            double off = 0;
            for (double t = 0; t < 10; t += h) {
                step(world, h);
                off = std::max(off, std::abs(energy_of(world) / first - 1));
            }
            check_at_most(off, 1e-5, "change of the energy, as a share");
        }
}

TEST_CASE("classics: a constant force lets a ball bounce as gravity does", "[classics]")
{
    for (const double restitution : {1., 0.8})
        for (const double h : {0.02, 0.01, 0.0025}) {
            CAPTURE(restitution, h);
            const Material material{restitution, 0};
            const RigidBody ground = fixed(Box{{100, 1, 100}}, material, {0, -0.5, 0}),
                            ball = ball_of_mass(0.1, 2, {0, 0.4, 0}, material);
            World falls = solved({ground, ball}), pushed = solved({ground, ball}, {0, 0, 0});
            AppliedForce force;
            force.body = 1;
            force.force = {0, -2 * g, 0};
            pushed.forces = {force};
            double off = 0;
            for (double t = 0; t < 2; t += h) {
                step(falls, h);
                step(pushed, h);
                off = std::max(
                    off, (falls.bodies[1].state.position - pushed.bodies[1].state.position).norm());
            }
            check_at_most(off, 1e-6, "difference of the places [m]");
        }
}

} // namespace bounces_on_springs
