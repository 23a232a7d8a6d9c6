// SPDX-License-Identifier: MIT
// Bodies that roll: down an incline, down a groove, after a push with backspin, and to and fro with
// a weight in them. The contact does no work while they roll, so energy and accelerations follow
// from the moment of inertia alone.
#include "classics/problems.hpp"

#include "geometry/meshes/generators.hpp"
#include "geometry/shapes/solid_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace rolling {

using namespace rigor;
using namespace rigor::testing;

namespace {

Vector3d gravity_on_incline(double angle)
{
    return {g * std::sin(angle), -g * std::cos(angle), 0};
}

// A box, and the same box as a mesh, also with a dent in its lower side: dented meshes have other
// contacts than convex ones.
std::vector<std::pair<const char*, Shape>> level_grounds()
{
    const Vector3d size(20, 1, 20);
    TriangleMesh dented = box_mesh(size);
    const auto lower = std::find_if(
        dented.triangles.begin(), dented.triangles.end(), [&](const std::array<int, 3>& t) {
            return std::all_of(t.begin(), t.end(),
                               [&](int v) { return dented.vertices[v].y() < 0; });
        });
    const auto [i, j, k] = *lower;
    const Vector3d middle = (dented.vertices[i] + dented.vertices[j] + dented.vertices[k]) / 3;
    const int n = static_cast<int>(dented.vertices.size());
    dented.vertices.push_back(middle + Vector3d(0, 0.3, 0));
    *lower = {i, j, n};
    dented.triangles.push_back({j, k, n});
    dented.triangles.push_back({k, i, n});
    return {{"box", Box{size}},
            {"mesh", Mesh{std::make_shared<SolidMesh>(box_mesh(size))}},
            {"dented mesh", Mesh{std::make_shared<SolidMesh>(dented)}}};
}

} // namespace

// With k = I/(M R²): a = g sin α / (1 + k) (Galilei's problem of 1638; Euler 1765).
TEST_CASE("classics: what rolls down an incline has the acceleration of its inertia", "[classics]")
{
    struct Wheel {
        const char* name;
        Shape shape;
        double radius;
    };
    const std::vector<Wheel> wheels = {{"ball", Sphere{0.3}, 0.3},
                                       {"cylinder", Cylinder{0.3, 0.4}, 0.3},
                                       {"capsule", Capsule{0.3, 0.4}, 0.3},
                                       {"torus", Torus{0.22, 0.08}, 0.3},
                                       {"ellipsoid", Ellipsoid{{0.3, 0.2, 0.3}}, 0.3}};
    for (const Wheel& wheel : wheels)
        for (const double degrees : {5., 20., 40.})
            for (const double h : {1 / 60., 1 / 240.})
                for (const double heading : {0., 0.8}) {
                    CAPTURE(wheel.name, degrees, h, heading);
                    const double angle = degrees * pi / 180, T = 1;
                    const Quaternion q = turn({0, 1, 0}, heading);
                    const Matrix3d R = rotation_matrix(q);
                    const Eigen::Quaterniond lies = eigen(q) * eigen(turn({1, 0, 0}, pi / 2));
                    RigidBody body =
                        body_of(wheel.shape, {0, wheel.radius, 0}, {0, 2}, {lies.w(), lies.vec()});
                    const double k = body.inertia(1, 1) / (body.mass * wheel.radius * wheel.radius);
                    World world =
                        solved({fixed(Plane{}, {0, 2}), body}, R * gravity_on_incline(angle));
                    run(world, static_cast<int>(std::lround(T / h)), h);
                    const double a = g * std::sin(angle) / (1 + k);
                    const RigidState& s = world.bodies[1].state;
                    CHECK_THAT(s.velocity,
                               IsClose(Vector3d(R * Vector3d(a * T, 0, 0)), Order(1e-9)));
                    CHECK_THAT(s.position,
                               IsClose(Vector3d(R * Vector3d(a * T * T / 2, wheel.radius, 0)),
                                       Order(1e-9)));
                }
}

TEST_CASE("classics: on a box or a mesh a wheel rolls down as on a plane", "[classics]")
{
    const std::vector<std::pair<const char*, Shape>> wheels = {{"ball", Sphere{0.25}},
                                                               {"cylinder", Cylinder{0.25, 0.3}},
                                                               {"capsule", Capsule{0.25, 0.3}},
                                                               {"torus", Torus{0.2, 0.05}}};
    constexpr double radius = 0.25, angle = 0.3, T = 1;
    for (const auto& [ground, shape] : level_grounds())
        for (const auto& [name, wheel] : wheels)
            for (const double h : {1 / 50., 1 / 240.})
                for (const double heading : {0., 0.8}) {
                    CAPTURE(ground, name, h, heading);
                    const Quaternion q = turn({0, 1, 0}, heading);
                    const Matrix3d R = rotation_matrix(q);
                    const Eigen::Quaterniond lies = eigen(q) * eigen(turn({1, 0, 0}, pi / 2));
                    RigidBody body =
                        body_of(wheel, {0, 0.5 + radius, 0}, {0, 2}, {lies.w(), lies.vec()});
                    const double k = body.inertia(1, 1) / (body.mass * radius * radius);
                    World world =
                        solved({fixed(shape, {0, 2}), body}, R * gravity_on_incline(angle));
                    run(world, static_cast<int>(std::lround(T / h)), h);
                    const Vector3d V(g * std::sin(angle) / (1 + k) * T, 0, 0);
                    CHECK_THAT(world.bodies[1].state.velocity,
                               IsClose(Vector3d(R * V), Order(1e-6)));
                }
}

// In a groove a ball turns about the line through its two contacts, which is d = R cos β below its
// center: a = g sin α / (1 + 2/5 R²/d²).
TEST_CASE("classics: a ball rolls more slowly down a steeper groove", "[classics]")
{
    for (const double side : {20., 45., 70.})
        for (const double radius : {0.02, 0.2})
            for (const double h : {1 / 60., 1 / 240.}) {
                CAPTURE(side, radius, h);
                const double b = side * pi / 180, angle = 0.3, T = 1;
                const Material rough{0, 5};
                World world = solved({fixed(Plane{}, rough, {0, 0, 0}, turn({1, 0, 0}, b)),
                                      fixed(Plane{}, rough, {0, 0, 0}, turn({1, 0, 0}, -b)),
                                      body_of(Sphere{radius}, {0, radius / std::cos(b), 0}, rough)},
                                     gravity_on_incline(angle));
                run(world, static_cast<int>(std::lround(T / h)), h);
                const double d = radius * std::cos(b);
                const double a = g * std::sin(angle) / (1 + 0.4 * radius * radius / (d * d));
                CHECK_THAT(world.bodies[2].state.position.x(), IsClose(a * T * T / 2, Order(1e-9)));
                CHECK_THAT(world.bodies[2].state.velocity.x(), IsClose(a * T, Order(1e-9)));
            }
}

// Coriolis (1835, "Théorie mathématique des effets du jeu de billard"): a ball thrown with backspin
// ends with (5 v - 2 R ω)/7, and so comes back if R ω > 5/2 v.
TEST_CASE("classics: a ball with enough backspin comes back", "[classics]")
{
    const double radius = 0.1, v = 1, mu = 0.2, T = 3;
    for (const double backspin : {0., 1., 2.4, 2.6, 4.})
        for (const double h : {1 / 60., 1 / 240.}) {
            CAPTURE(backspin, h);
            RigidBody ball = body_of(Sphere{radius}, {0, radius, 0}, {0, mu});
            ball.state.velocity = {v, 0, 0};
            spin(ball, {0, 0, backspin * v / radius});
            World world = solved({fixed(Plane{}, {0, mu}), ball});
            run(world, static_cast<int>(std::lround(T / h)), h);
            const double last = (5 - 2 * backspin) * v / 7, slides = (v - last) / (mu * g);
            const double x = (v + last) / 2 * slides + last * (T - slides);
            CHECK_THAT(world.bodies[1].state.velocity.x(), IsClose(last, Order(1e-9)));
            CHECK_THAT(world.bodies[1].state.position.x(), IsClose(x, Order(h * h)));
        }
}

// A ball whose center of mass is d below its middle rocks like a pendulum, with the period
// 2π √((I + M (R - d)²)/(M g d)) of small swings.
TEST_CASE("classics: a loaded ball rocks with the period of a pendulum", "[classics]")
{
    const double R = 0.3, M = 2;
    for (const double d : {0.03, 0.1, 0.2})
        for (const double moment : {0.02, 0.05})
            for (const double h : {1 / 60., 1 / 240.}) {
                CAPTURE(d, moment, h);
                const Material rough{0, 10};
                RigidBody ball = body_of(Sphere{R}, {0, 0, 0}, rough, turn({0, 0, 1}, 0.02));
                ball.parts[0].position = {0, d, 0};
                set_mass(ball, M, moment * Matrix3d::Identity());
                ball.state.position =
                    Vector3d(0, R, 0) - rotation_matrix(ball.state.orientation) * Vector3d(0, d, 0);
                World world = solved({fixed(Plane{}, rough), ball});
                const double T = 2 * pi * std::sqrt((moment + M * (R - d) * (R - d)) / (M * g * d));
                // times at which it comes to a stand on one side
                double before = 0, first = 0, last = 0;
                int swings = -1;
                for (int i = 1; swings < 5 && i * h < 8 * T; ++i) {
                    step(world, h);
                    const double w = angular_velocity(world.bodies[1]).z();
                    if (before < 0 && w >= 0) {
                        last = (i - w / (w - before)) * h;
                        if (++swings == 0) first = last;
                    }
                    before = w;
                }
                REQUIRE(swings == 5);
                // The midpoint rule makes a swing of the frequency w longer by (w h)²/12. The time
                // at which the ball turns back is interpolated, to a tenth of a step.
                const double angle = 2 * pi * h / T;
                const double bound = angle * angle / 10 * T + h / 10;
                CHECK_THAT((last - first) / swings, IsClose(T, Order(bound)));
            }
}

} // namespace rolling
