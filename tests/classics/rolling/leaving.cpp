// SPDX-License-Identifier: MIT
// Where contact ends: a ladder leaves its wall, a ball the sphere it rolls down. The force of the
// contact vanishes at a height that energy decides.
#include "classics/problems.hpp"

#include <cmath>
#include <numbers>

using namespace rigor;
using namespace rigor::testing;

namespace {

// The height of a body at the last moment before it leaves another one, between two steps [m].
double leaves_at(World& world, int body, int from, double h)
{
    const double most_time = 10; // [s]
    double before = world.bodies[body].state.position.y();
    for (int i = 0; i * h < most_time; ++i) {
        const std::vector<ContactRecord> records = step(world, h);
        const bool touches =
            std::any_of(records.begin(), records.end(),
                        [&](const ContactRecord& c) { return c.body1 == from || c.body2 == from; });
        const double here = world.bodies[body].state.position.y();
        if (!touches && i > 2) return (before + here) / 2;
        before = here;
    }
    FAIL("they never part");
    return 0;
}

} // namespace

// A ladder that slides down between smooth wall and smooth floor leaves the wall at two thirds of
// its height, whatever its moment of inertia (Lamb 1914, "Dynamics").
TEST_CASE("classics: a ladder leaves the wall at two thirds of its height", "[classics]")
{
    const double length = 2, foot = 0.02;
    for (const double degrees : {75., 60., 45.}) {
        std::vector<double> errors;
        for (const double h : {1 / 100., 1 / 400., 1 / 1600.}) {
            const double a = degrees * pi / 180;
            World world = world_of(
                {fixed(Plane{}, {0, 0}),
                 fixed(Plane{}, {0, 0}, {0, 0, 0}, turn({0, 0, 1}, -pi / 2)),
                 body_of(Capsule{foot, length},
                         {foot + length / 2 * std::cos(a), foot + length / 2 * std::sin(a), 0},
                         {0, 0}, turn({0, 0, 1}, pi / 2 - a))});
            world.settings.formulas_are_reference = true;
            const double height = leaves_at(world, 2, 1, h) - foot;
            errors.push_back(std::abs(height / (length / 2 * std::sin(a)) - 2. / 3));
        }
        CAPTURE(degrees, errors);
        check_at_most(errors[0], 0.05, "error of the share");
        check_at_most(errors[2], 0.05 / 8, "error of the share");
    }
}

// A ball leaves a smooth sphere at cos θ = 2/3, and rolls off a rough one at 10/17 (Routh 1905).
TEST_CASE("classics: a ball leaves a sphere at two thirds or rolls to ten seventeenths",
          "[classics]")
{
    const double R = 1;
    for (const double radius : {0.1, 0.5})
        for (const bool is_rough : {false, true}) {
            std::vector<double> errors;
            for (const double h : {1 / 100., 1 / 400., 1 / 1600.}) {
                const Material material{0, is_rough ? 100. : 0.};
                const double start = 0.1;
                const Vector3d X = (R + radius) * Vector3d(std::sin(start), std::cos(start), 0);
                World world =
                    world_of({fixed(Sphere{R}, material), body_of(Sphere{radius}, X, material)});
                world.settings.formulas_are_reference = true;
                const double share = leaves_at(world, 1, 0, h) / X.y();
                errors.push_back(std::abs(share - (is_rough ? 10. / 17 : 2. / 3)));
            }
            CAPTURE(radius, is_rough, errors);
            check_at_most(errors[0], 0.05, "error of the share");
            check_at_most(errors[2], 0.05 / 8, "error of the share");
        }
}
