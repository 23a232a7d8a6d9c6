// SPDX-License-Identifier: MIT
// A round body that rolls without slipping on a level ground keeps its speed forever: the contact
// point is at rest, and no force does work there.
#include "classics/problems.hpp"

#include "geometry/meshes/generators.hpp"

#include <cmath>
#include <numbers>
#include <tuple>
#include <vector>

namespace wheels_roll {

using namespace rigor;
using namespace rigor::testing;

namespace {

constexpr double radius = 0.25; // [m]

struct Wheel {
    const char* name;
    Shape shape;
    Vector3d axis; // in object space
};

Shape polygonal_wheel(int sides)
{
    constexpr double half = 0.15; // [m]
    return mesh_of(
        surface_of_revolution({{0, -half}, {radius, -half}, {radius, half}, {0, half}}, sides));
}

std::vector<Wheel> wheels()
{
    return {{"sphere", Sphere{radius}, {0, 1, 0}},
            {"capsule", Capsule{radius, 0.3}, {0, 1, 0}},
            {"torus", Torus{0.2, 0.05}, {0, 1, 0}},
            {"cylinder", Cylinder{radius, 0.3}, {0, 1, 0}},
            {"disk", Cylinder{radius, 0.05}, {0, 1, 0}},
            {"ellipsoid", Ellipsoid{{0.4, radius, radius}}, {1, 0, 0}}};
}

struct Ground {
    const char* name;
    Shape shape;
    double top; // [m]
};

std::vector<Ground> grounds()
{
    return {{"plane", Plane{}, 0},
            {"box", Box{{40, 1, 4}}, 0.5},
            {"mesh", mesh_of(box_mesh({40, 1, 4})), 0.5}};
}

constexpr double end = 2; // [s]

// The share of its speed that a wheel has kept at the end. Its axis is along z.
double kept_speed(const Wheel& wheel, const Ground& ground, double speed, double h)
{
    const Material rough{0, 0.6};
    const Quaternion q = wheel.axis.x() != 0 ? turn({0, 1, 0}, -std::numbers::pi / 2)
                                             : turn({1, 0, 0}, std::numbers::pi / 2);
    RigidBody body = body_of(wheel.shape, {-15, radius + ground.top, 0}, rough, q);
    body.state.velocity = {speed, 0, 0};
    spin(body, {0, 0, -speed / radius});
    World world = world_of({fixed(ground.shape, rough), body});
    world.settings.formulas_are_reference = true;
    run(world, static_cast<int>(std::lround(end / h)), h);
    return world.bodies[1].state.velocity.x() / speed;
}

// The share of its speed that a polygonal wheel with the moment of inertia c m r² keeps until the
// end. At each corner it pivots about the next one and keeps the share 1 - (1 - cos α)/(1 + c) of
// its speed, α = 2π/n (McGeer 1990, "Passive dynamic walking": the rimless wheel). With one corner
// in each length 2 r sin(α/2), v' = -k v².
double speed_share_of_polygon(int sides, double c, double speed)
{
    const double angle = 2 * std::numbers::pi / sides;
    const double side = 2 * radius * std::sin(angle / 2);
    const double k = (1 - std::cos(angle)) / (1 + c) / side;
    return 1 / (1 + k * speed * end);
}

} // namespace

TEST_CASE("classics: a wheel that rolls keeps its speed", "[classics][unsanitized]")
{
    Sweep sweep;
    constexpr double tenth_of_a_turn = std::numbers::pi / 5;
    for (const Ground& ground : grounds())
        for (const Wheel& wheel : wheels())
            for (const double h : {0.02, 0.01, 0.005, 0.0025, 0.001})
                for (const double speed : {1., 3., 6.}) {
                    if (speed * h / radius > tenth_of_a_turn) continue;
                    if (!sweep.takes_next()) continue;
                    CAPTURE(ground.name, wheel.name, h, speed);
                    CHECK_THAT(kept_speed(wheel, ground, speed, h), IsClose(1.0, Order(1e-5)));
                }
}

TEST_CASE("classics: a wheel of any size rolls on in any direction", "[classics]")
{
    const Material rough{0, 0.6};
    constexpr int steps = 150;
    for (const double r : {0.01, 1., 100.})
        for (const double length : {0.2, 1.2, 9.}) // along the axis, in radii
            for (const double angle : {0., 0.4, 2.1})
                for (const double turn_of_step : {0.05, 0.2, 0.5}) {
                    CAPTURE(r, length, angle, turn_of_step);
                    const double speed = 2 * std::sqrt(g * r), h = turn_of_step * r / speed;
                    const Vector3d ahead(std::cos(angle), 0, -std::sin(angle));
                    const Matrix3d R = rotation_matrix(turn({0, 1, 0}, angle)) *
                                       rotation_matrix(turn({1, 0, 0}, std::numbers::pi / 2));
                    const Eigen::Quaterniond q(R);
                    RigidBody body =
                        body_of(Cylinder{r, length * r}, {0, 2 * r, 0}, rough, {q.w(), q.vec()});
                    body.state.velocity = speed * ahead;
                    spin(body, speed / r * Vector3d(0, 1, 0).cross(ahead));
                    World world = world_of({fixed(Box{{200 * r, 2 * r, 200 * r}}, rough), body});
                    world.settings.formulas_are_reference = true;
                    double lowest = 2 * r;
                    for (int i = 0; i < steps; ++i) {
                        step(world, h);
                        lowest = std::min(lowest, world.bodies[1].state.position.y());
                    }
                    const double kept = world.bodies[1].state.velocity.dot(ahead) / speed;
                    CHECK_THAT(kept, IsClose(1.0, Order(1e-5)));
                    check_at_most(2 * r - lowest, 2e-6 * r, "sinking [m]");
                }
}

TEST_CASE("classics: a polygonal wheel loses no more than its corners take", "[classics]")
{
    for (const int sides : {24, 96}) {
        const Wheel wheel{"polygon", polygonal_wheel(sides), {0, 1, 0}};
        const double exact = speed_share_of_polygon(sides, 0.5, 1);
        for (const Ground& ground : grounds())
            for (const double h : {0.001, 0.0005}) {
                CAPTURE(sides, ground.name, h);
                const double kept = kept_speed(wheel, ground, 1, h);
                check_at_most(kept, 1, "share of the speed");
                check_at_least(kept, 0.9 * exact, "share of the speed");
            }
    }
}

TEST_CASE("classics: a mesh wheel rolls on at any step", "[classics][unsanitized]")
{
    Sweep sweep;
    // In a step that crosses corners, a wheel rolls like a round one and may lose nothing.
    const std::vector<std::tuple<const char*, double, double>> wheels = {{"disk", 0, 0.5},
                                                                         {"ring", 0.8, 0.82}};
    for (const auto& [name, inner, c] : wheels) // inner radius [radii], moment of inertia [m r²]
        for (const int sides : {24, 96, 360}) {
            const Shape shape = inner == 0 ? polygonal_wheel(sides)
                                           : mesh_of(ring_mesh(inner * radius, radius, 0.3, sides));
            for (const Ground& ground : grounds())
                for (const double h : {0.02, 0.01, 0.005, 0.0025})
                    for (const double speed : {1., 3.}) {
                        if (!sweep.takes_next()) continue;
                        CAPTURE(name, sides, ground.name, h, speed);
                        const double kept = kept_speed({name, shape, {0, 1, 0}}, ground, speed, h);
                        check_at_most(kept, 1.02, "share of the speed");
                        check_at_least(kept, 0.65 * speed_share_of_polygon(sides, c, speed),
                                       "share of the speed");
                    }
        }
}

} // namespace wheels_roll
