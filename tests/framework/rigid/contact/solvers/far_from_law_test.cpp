// SPDX-License-Identifier: MIT
#include "rigid/contact/solvers/far_from_law.hpp"

#include "framework/rigid/contact/hand_made.hpp"

#include <numeric>

namespace far_from_law_test {

using namespace rigor;
using namespace rigor::testing;

namespace {

constexpr double mass = 3; // mass of the ball [kg]

// Whether these impulses are far from the law of contact, if they are applied.
bool is_far(HandMade& problem, const std::vector<Vector3d>& impulses)
{
    std::vector<int> active(problem.contacts.size());
    std::iota(active.begin(), active.end(), 0);
    double approach = 0;
    for (const ContactConstraint& c : problem.contacts)
        approach =
            std::max(approach, c.target_speed - problem.velocity_at(c, c.point).dot(c.normal));
    const std::vector<Body> before = problem.bodies;
    for (std::size_t k = 0; k < impulses.size(); ++k)
        problem.apply(problem.contacts[k], problem.contacts[k].point, impulses[k]);
    const bool result = is_far_from_law(problem, problem.island, active, impulses, approach);
    problem.bodies = before;
    return result;
}

// A ball on the ground, and a driven plane above it that sinks with 1 m/s. Its normal is turned by
// the angle from the vertical.
void put_between_planes(HandMade& problem, double angle)
{
    const int ball = problem.add(ball_at({0, 0.5, 0}, mass));
    Body plane;
    plane.velocity = {0, -1, 0};
    const int driven = problem.add(plane);
    const Vector3d n(std::sin(angle), -std::cos(angle), 0);
    problem.touch(ball, 0, {0, 0, 0});
    problem.touch(ball, driven, Vector3d(0, 0.5, 0) - 0.5 * n, n);
}

} // namespace

TEST_CASE("far from law: the impulse that stops a ball is not far, much larger ones are", "[rigid]")
{
    HandMade problem;
    problem.touch(problem.add(ball_at({0, 0.5, 0}, mass, {0, -2, 0})), 0, {0, 0, 0});
    const Vector3d stops(0, 2 * mass, 0);
    CHECK_FALSE(is_far(problem, {Vector3d::Zero()}));
    CHECK_FALSE(is_far(problem, {stops}));
    CHECK_FALSE(is_far(problem, {5 * stops}));
    CHECK(is_far(problem, {20 * stops}));
    // A ball that does not approach needs no impulse.
    problem.bodies[1].velocity.setZero();
    CHECK(is_far(problem, {stops}));
}

TEST_CASE("far from law: a ball that flies past may be pushed harder than it approaches", "[rigid]")
{
    HandMade problem;
    problem.touch(problem.add(ball_at({0, 0.5, 0}, mass, {2, -0.01, 0})), 0, {0, 0, 0});
    CHECK_FALSE(is_far(problem, {Vector3d(0, 2 * mass, 0)}));
    CHECK(is_far(problem, {Vector3d(0, 40 * mass, 0)}));
}

// Between parallel planes the impulses balance each other, and the lower bound of the change,
// Σ jₙ (s - vₙ)/|Δv|, is infinite.
TEST_CASE("far from law: in a jam, impulses that balance each other are far", "[rigid]")
{
    HandMade problem;
    put_between_planes(problem, 0);
    CHECK(is_far(problem, {Vector3d(0, mass, 0), Vector3d(0, -mass, 0)}));
    // A single one, as after the first sweep, is no sign of a jam.
    CHECK_FALSE(is_far(problem, {Vector3d::Zero(), Vector3d(0, -mass, 0)}));
}

// The upper plane has the speed cos α along its normal, so that the ball leaves with the speed v
// for which v sin α = cos α. The impulse of the upper plane is M v/sin α.
TEST_CASE("far from law: out of a wide wedge a ball is driven, out of a narrow one it is not",
          "[rigid]")
{
    for (const double degrees : {1., 5., 20., 45.}) {
        HandMade problem;
        const double angle = degrees * std::numbers::pi / 180;
        put_between_planes(problem, angle);
        const double v = 1 / std::tan(angle), j = mass * v / std::sin(angle);
        CAPTURE(degrees);
        CHECK(is_far(problem, {Vector3d(0, j * std::cos(angle), 0),
                               Vector3d(j * std::sin(angle), -j * std::cos(angle), 0)}) ==
              (degrees < 11));
    }
}

} // namespace far_from_law_test
