// SPDX-License-Identifier: MIT
// Mechanisms: a driven body that turns pushes another body with its side. The driven body gives the
// path of the other one, and with every halved step the error falls to a quarter.
#include "classics/problems.hpp"

#include <cmath>

namespace pushed_by_a_turning_body {

using namespace rigor;
using namespace rigor::testing;

namespace {

const Material smooth{0, 0};

// A box that is only shifted.
RigidBody slider(const Box& box, const Vector3d& X, const Vector3d& V)
{
    RigidBody body = body_of(box, X, smooth);
    let_turn_about(body, {0, 0, 0});
    body.state.velocity = V;
    return body;
}

// The errors of steps h, h/2 and h/4.
void check_second_order(const std::vector<double>& errors)
{
    CAPTURE(errors);
    check_at_most(errors[1], 0.3 * errors[0], "error by half of the step");
    check_at_most(errors[2], 0.3 * errors[1], "error by a quarter of the step");
}

} // namespace

// A ball lies at a long smooth bar that turns at ω. Along the bar, r'' = ω² r, so that a ball that
// starts with r' = ω r flies off as r = r₀ exp(ω t).
TEST_CASE("classics: a turning bar throws a ball off exponentially", "[classics]")
{
    const double first = 0.5, T = 1.2, side = 0.2;
    for (const double omega : {1.5, -1.5, 0.8}) {
        std::vector<double> errors;
        for (const int steps : {120, 240, 480}) {
            const double up = omega > 0 ? side : -side;
            RigidBody ball = body_of(Sphere{0.1}, {first, up, 0}, smooth);
            const Vector3d w(0, 0, omega);
            ball.state.velocity =
                w.cross(ball.state.position) + Vector3d(std::abs(omega) * first, 0, 0);
            World world = solved({driven(Box{{20, 0.2, 0.2}}, smooth, {0, 0, 0}, turning(w)), ball},
                                 {0, 0, 0});
            run(world, steps, T / steps);
            const Matrix3d R = rotation_matrix(turn({0, 0, 1}, omega * T));
            const double r = first * std::exp(std::abs(omega) * T);
            errors.push_back((world.bodies[1].state.position - R * Vector3d(r, up, 0)).norm());
        }
        CAPTURE(omega);
        check_second_order(errors);
    }
}

// A pin at the distance a from its axis pushes a wall: x = a cos ω t, as in a Scotch yoke. The wall
// starts at rest, at the end of its path.
TEST_CASE("classics: a pin that turns moves a wall by a cosine", "[classics]")
{
    for (const double a : {0.002, 0.2, 20.})
        for (const double omega : {5., -0.3}) {
            const double T = 1.5 / std::abs(omega);
            std::vector<double> errors;
            for (const int steps : {60, 120, 240}) {
                RigidBody pin = driven(Sphere{a / 4}, smooth, {0, 0, 0}, turning({0, 0, omega}));
                pin.parts[0].position = {a, 0, 0};
                const Box wall{{a / 2, 5 * a, a / 2}};
                World world = solved({pin, slider(wall, {a / 2, 0, 0}, {0, 0, 0})}, {0, 0, 0});
                run(world, steps, T / steps);
                const double x = world.bodies[1].state.position.x() + a / 2;
                errors.push_back(std::abs(x / a - std::cos(omega * T)));
            }
            CAPTURE(a, omega);
            check_second_order(errors);
            check_at_most(errors[0], 1e-4, "error of the longest step");
        }
}

// A round cam of radius R, whose axis is at the distance e from its center, lifts a plate that
// moves between smooth walls: y = R + e sin ω t, as long as gravity keeps the plate on the cam.
TEST_CASE("classics: a cam lifts a plate by a sine", "[classics][unsanitized]")
{
    const double R = 0.2, e = 0.1, T = 1;
    for (const double omega : {3., 8., -6.})
        for (const double mu : {0., 0.4}) {
            const Material rough{0, mu};
            std::vector<double> errors;
            for (const int steps : {200, 400, 800}) {
                RigidBody cam = driven(Cylinder{R, 0.2}, rough, {0, 0, 0}, turning({0, 0, omega}));
                cam.parts[0].position = {e, 0, 0};
                cam.parts[0].orientation = turn({1, 0, 0}, pi / 2);
                RigidBody plate = slider(Box{{1, 0.2, 0.2}}, {0, R + 0.1, 0}, {0, e * omega, 0});
                plate.material = rough;
                const Box side{{0.2, 3, 1}};
                World world = solved({cam, plate, fixed(side, smooth, {-0.6, 0.5, 0}),
                                      fixed(side, smooth, {0.6, 0.5, 0})});
                run(world, steps, T / steps);
                const double y = world.bodies[1].state.position.y() - 0.1;
                errors.push_back(std::abs(y - R - e * std::sin(omega * T)) / e);
            }
            CAPTURE(omega, mu);
            check_at_most(errors[2], 0.3 * errors[0], "error by a quarter of the step");
            check_at_most(errors[2], 5e-5, "error of the shortest step");
        }
}

} // namespace pushed_by_a_turning_body
