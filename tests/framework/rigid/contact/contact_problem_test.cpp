// SPDX-License-Identifier: MIT
#include "rigid/contact/contact_problem.hpp"

#include "framework/rigid/contact/hand_made.hpp"
#include "support/seeds.hpp"

using namespace rigor;
using namespace rigor::testing;

namespace {

Matrix3d formula_matrix(const Body& body, const Vector3d& x)
{
    return impulse_matrix(body.inverse_mass, body.inverse_inertia, body.position, x);
}

// A bound on how much an impulse of 1 N s at x changes V and ω of a body.
double strength(const Body& body, const Vector3d& x)
{
    return body.inverse_mass +
           body.inverse_inertia.norm() * (1 + (x - body.position).squaredNorm());
}

// An island with these numbers of bodies and of pairs of touching bodies.
Island island_with(int bodies, int pairs)
{
    Island island;
    island.bodies.resize(bodies);
    island.pairs.resize(pairs);
    return island;
}

} // namespace

TEST_CASE("contact problem: K and its eigenvalue belong to the bodies that can move", "[rigid]")
{
    for (const bool optimised : {false, true})
        for (Random random : seeds(20)) {
            CAPTURE(optimised);
            HandMade problem;
            problem.optimised = optimised;
            const int a = problem.add(random.body()), b = problem.add(random.body());
            const Vector3d x = random.vector(), n = random.unit_vector();
            const Matrix3d K_a = formula_matrix(problem.bodies[a], x),
                           K_b = formula_matrix(problem.bodies[b], x);
            const ContactConstraint on_ground = problem.touch(a, 0, x, n),
                                    between = problem.touch(a, b, x, n);
            CHECK_THAT(on_ground.K, IsClose(K_a, Rounding(64)));
            CHECK_THAT(between.K, IsClose(Matrix3d(K_a + K_b), Rounding(64)));
            CHECK_THAT(between.normal_K, IsClose(n.dot(between.K * n), Rounding(16)));

            // One eigenvalue of P K P is 0; the other two are those of K in the tangent plane. The
            // engine computes the larger one from their difference, which is a root of squares: if
            // the difference is small, its rounding error is large.
            const Matrix3d P = Matrix3d::Identity() - n * n.transpose();
            const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(P * between.K * P);
            const Vector3d values = solver.eigenvalues();
            const double scale = between.K.squaredNorm() / (values[2] - values[1]);
            CHECK_THAT(between.tangential_K, IsClose(values[2], Rounding(64, scale)));
        }
}

TEST_CASE("contact problem: two static bodies have no impulse matrix", "[rigid]")
{
    for (const bool optimised : {false, true}) {
        HandMade problem;
        problem.optimised = optimised;
        const int fixed = problem.add(Body());
        const ContactConstraint& c = problem.touch(fixed, 0, {1, 2, 3});
        CHECK(c.K == Matrix3d::Zero());
        CHECK(c.normal_K == 0);
        CHECK(c.tangential_K == 0);
    }
}

TEST_CASE("contact problem: an impulse conserves momentum and changes v by K j", "[rigid]")
{
    for (const bool optimised : {false, true})
        for (Random random : seeds(20)) {
            CAPTURE(optimised);
            HandMade problem;
            problem.optimised = optimised;
            const int a = problem.add(random.body()), b = problem.add(random.body());
            const Vector3d x = random.vector(), j = random.vector();
            const ContactConstraint c = problem.touch(a, b, x, random.unit_vector());
            const std::vector<Body> before = problem.bodies;
            const Vector3d v = problem.velocity_at(c, x);
            const Tolerance rounding =
                Rounding(32, 8 + 2 * strength(before[a], x) + 2 * strength(before[b], x));
            CHECK_THAT(v, IsClose(relative_velocity(before[a], before[b], x), Rounding(16, 8)));
            problem.apply(c, x, j);
            const std::vector<Body>& after = problem.bodies;
            CHECK_THAT(after[a], IsClose(apply_impulse(before[a], x, j), rounding));
            CHECK_THAT(after[b], IsClose(apply_impulse(before[b], x, -j), rounding));
            CHECK_THAT(momentum(after), IsClose(momentum(before), Rounding(32, 40)));
            CHECK_THAT(angular_momentum(after),
                       IsClose(angular_momentum(before), Rounding(32, 40)));
            CHECK_THAT(problem.velocity_at(c, x), IsClose(Vector3d(v + c.K * j), rounding));
            // A state that is given is used instead of the problem's own.
            CHECK(problem.velocity_between(before, c, x) == v);
        }
}

TEST_CASE("contact problem: an impulse leaves a static body as it is", "[rigid]")
{
    for (const bool optimised : {false, true})
        for (const bool is_first : {false, true}) {
            CAPTURE(optimised, is_first);
            HandMade problem;
            problem.optimised = optimised;
            const int ball = problem.add(ball_at({0, 1, 0}, 2));
            const ContactConstraint c =
                is_first ? problem.touch(0, ball, {1, 0, 0}) : problem.touch(ball, 0, {1, 0, 0});
            problem.apply(c, c.point, {1, 2, 3});
            CHECK(moves_alike(problem.bodies[0], Body()));
            const double sign = is_first ? -1 : 1;
            CHECK(problem.bodies[ball].velocity == sign * Vector3d(0.5, 1, 1.5));
        }
}

TEST_CASE("contact problem: the gap at the end of the step includes what rotation passes by",
          "[rigid]")
{
    HandMade problem;
    problem.time_step = 0.25;
    ContactConstraint c;
    c.gap = 0.5;
    CHECK(problem.predicted_gap(c, -2) == 0);
    c.gap_correction = 0.125;
    CHECK(problem.predicted_gap(c, -3) == -0.125);
}

TEST_CASE("contact problem: up is opposite to gravity and y without it", "[rigid]")
{
    ContactProblem problem;
    CHECK(problem.up() == Vector3d(0, 1, 0));
    problem.settings.gravity = {0, 0, 4};
    CHECK(problem.up() == Vector3d(0, 0, -1));
}

TEST_CASE("contact problem: the bodies of an island come in its order", "[rigid]")
{
    HandMade problem;
    for (int i = 1; i <= 4; ++i)
        problem.add(ball_at({1.0 * i, 0, 0}, i));
    Island island;
    CHECK(problem.bodies_of(island).empty());
    island.bodies = {4, 2};
    const std::vector<Body> bodies = problem.bodies_of(island);
    REQUIRE(bodies.size() == 2);
    CHECK(bodies[0].position.x() == 4);
    CHECK(bodies[1].position.x() == 2);
}

TEST_CASE("contact problem: contacts of pairs are counted", "[rigid]")
{
    CHECK(contact_count({}) == 0);
    const std::vector<ContactPair> pairs = {{0, 4}, {4, 5}, {9, 9}, {5, 8}};
    CHECK(contact_count(pairs) == 8);
}

TEST_CASE("contact problem: a stack is no pile and bodies that touch many others are one",
          "[rigid]")
{
    CHECK_FALSE(is_pile(island_with(0, 0)));
    CHECK_FALSE(is_pile(island_with(8, 28)));    // few bodies, although each touches all others
    CHECK_FALSE(is_pile(island_with(100, 100))); // a stack on the ground
    CHECK_FALSE(is_pile(island_with(256, 256)));
    CHECK(is_pile(island_with(257, 257)));   // too many to be solved like a stack
    CHECK(is_pile(island_with(27, 54 + 9))); // a cube of 3 × 3 × 3 bodies on the ground
}
