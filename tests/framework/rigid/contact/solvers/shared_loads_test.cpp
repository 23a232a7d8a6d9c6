// SPDX-License-Identifier: MIT
// The loads of a body that lies on several driven bodies that turn. The expected loads are those of
// equally stiff springs below a rigid body, from the three equations of balance.
#include "framework/rigid/worlds.hpp"
#include "support/catch.hpp"
#include "support/seeds.hpp"

#include <algorithm>
#include <vector>

namespace shared_loads_test {

using namespace rigor;
using namespace rigor::testing;

namespace {

constexpr double mass = 12, radius = 0.05, step_length = 0.01;

// The loads of springs at these places, which bear `mass` at `center` [N]. The springs get shorter
// by a + b x + c z, so the loads are linear in x and z.
std::vector<double> loads_of_springs(const std::vector<Vector3d>& places, const Vector3d& center)
{
    Matrix3d A = Matrix3d::Zero();
    for (const Vector3d& x : places) {
        const Vector3d row(1, x.x(), x.z());
        A += row * row.transpose();
    }
    const Vector3d shortened = A.inverse() * mass * g * Vector3d(1, center.x(), center.z());
    std::vector<double> loads;
    for (const Vector3d& x : places)
        loads.push_back(shortened.dot(Vector3d(1, x.x(), x.z())));
    return loads;
}

// A ball that turns about the vertical, so that it does not drag what lies on its top.
RigidBody turning_ball(const Vector3d& X, double friction)
{
    Drive drive;
    drive.first_position = X;
    drive.angular_velocity = {0, 3, 0};
    RigidBody ball = fixed(Sphere{radius}, {0, friction}, X);
    ball.drive = std::make_shared<const Drive>(drive);
    ball.state = driven_state(drive, 0);
    return ball;
}

// A board on balls at these places, in this order of the world's bodies.
World board_on(const std::vector<Vector3d>& places, const Vector3d& center, double friction)
{
    std::vector<RigidBody> bodies;
    for (const Vector3d& x : places)
        bodies.push_back(turning_ball(x, friction));
    RigidBody board =
        body_of(Box{{4, 0.1, 4}}, center + Vector3d(0, radius + 0.05, 0), {0, friction});
    set_mass(board, mass, board.inertia * (mass / board.mass));
    bodies.push_back(board);
    World world = world_of(std::move(bodies));
    world.settings.formulas_are_reference = true;
    return world;
}

// The loads that the step found, by the indices of the balls [N].
std::vector<double> loads_of(World& world, std::size_t balls)
{
    std::vector<double> loads(balls, 0.0);
    for (const ContactRecord& record : step(world, step_length)) {
        const bool is_first = record.body1 < static_cast<int>(balls);
        loads[is_first ? record.body1 : record.body2] += std::abs(record.impulse.y()) / step_length;
    }
    return loads;
}

} // namespace

TEST_CASE("rigid: a board shares its weight as equal springs do", "[rigid]")
{
    int compared = 0;
    for (Random random : seeds(1000)) {
        const int n = 3 + random_index(random, 6);
        std::vector<Vector3d> places;
        for (int i = 0; i < n; ++i)
            places.emplace_back(random.uniform(-1, 1), 0, random.uniform(-1, 1));
        const Vector3d center(random.uniform(-0.3, 0.3), 0, random.uniform(-0.3, 0.3));
        const std::vector<double> expected = loads_of_springs(places, center);
        if (*std::min_element(expected.begin(), expected.end()) < 0.02 * mass * g) continue;
        ++compared;
        World world = board_on(places, center, random.uniform(0, 1));
        for (int i = 0; i < 3; ++i) {
            const std::vector<double> found = loads_of(world, places.size());
            for (std::size_t k = 0; k < places.size(); ++k)
                REQUIRE_THAT(found[k], IsClose(expected[k], Order(1e-9 * mass * g)));
        }
    }
    REQUIRE(compared > 20);
}

} // namespace shared_loads_test
