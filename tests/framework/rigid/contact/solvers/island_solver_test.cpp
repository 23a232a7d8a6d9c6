// SPDX-License-Identifier: MIT
#include "rigid/contact/solvers/island_solver.hpp"

#include "framework/rigid/contact/solvers/sweep_laws.hpp"

#include <numeric>

using namespace rigor;
using namespace rigor::testing;

namespace {

// The ways to sweep: by a formula of topic `collision`, by one of topic `contact`, and by the
// engine's faster forms.
enum class Way { collision_law, simultaneous, optimised };
constexpr Way ways[] = {Way::collision_law, Way::simultaneous, Way::optimised};

void choose(HandMade& problem, Way way)
{
    problem.optimised = way == Way::optimised;
    problem.settings.contact_method =
        way == Way::simultaneous ? ContactMethod::simultaneous : ContactMethod::built_in;
}

void solve(HandMade& problem)
{
    const UninitializedVector<int> active = activate_contacts(problem, problem.island);
    solve_island(problem, problem.island, active);
}

// Balls of these masses on top of each other, with the velocity of their fall in this step.
struct Column : HandMade {
    std::vector<double> masses;

    explicit Column(std::vector<double> of_bodies) : masses(std::move(of_bodies))
    {
        for (std::size_t i = 0; i < masses.size(); ++i) {
            const double y = static_cast<double>(i);
            const int ball = add(ball_at({0, y + 0.5, 0}, masses[i], {0, -g * time_step, 0}));
            touch(ball, ball - 1, {0, y, 0}).friction = 0.5;
        }
    }

    // The impulse that contact k carries: the weight of all bodies above it.
    double load(std::size_t k) const
    {
        return g * time_step *
               std::accumulate(masses.begin() + static_cast<std::ptrdiff_t>(k), masses.end(), 0.0);
    }
};

// Balls in a square that touch their neighbors and the ground, and move about.
struct Field : HandMade {
    explicit Field(int side, int thread_count) : HandMade(thread_count)
    {
        Random random(6);
        for (int i = 0; i < side * side; ++i)
            add(ball_at({1.0 * (i % side), 0.5, 1.0 * (i / side)}, random.mass(), random.vector()));
        // The tolerance of the sweeps is in proportion to the fastest approach. With this one the
        // sweeps converge early, and it affects no other contact.
        bodies.back().velocity.y() = -1e4;
        const auto connect = [&](int body1, int body2, const Vector3d& point,
                                 const Vector3d& normal) {
            touch(body1, body2, point, normal).friction = body1 == side * side ? 0 : 0.5;
        };
        for (int i = 0; i < side * side; ++i) {
            const Vector3d X = bodies[i + 1].position;
            connect(i + 1, 0, {X.x(), 0, X.z()}, {0, 1, 0});
            if (i % side > 0) connect(i + 1, i, {X.x() - 0.5, 0.5, X.z()}, {1, 0, 0});
            if (i >= side) connect(i + 1, i + 1 - side, {X.x(), 0.5, X.z() - 0.5}, {0, 0, 1});
        }
        split_into_blocks(*this, island);
    }
};

} // namespace

TEST_CASE("island solver: each contact of a column carries the weight above it", "[rigid]")
{
    for (const Way way : ways)
        for (const std::vector<double>& masses :
             {std::vector<double>{2}, std::vector<double>{1, 1, 1, 1, 1},
              std::vector<double>{5, 1, 3}, std::vector<double>{1, 1e4},
              std::vector<double>{1, 1e-4, 1e4}}) {
            Column column(masses);
            CAPTURE(static_cast<int>(way), masses.size());
            choose(column, way);
            solve(column);
            for (std::size_t k = 0; k < masses.size(); ++k) {
                CAPTURE(k);
                CHECK_THAT(column.contacts[k].contact_impulse,
                           IsClose(Vector3d(0, column.load(k), 0), Order(1e-9)));
                CHECK_THAT(column.bodies[k + 1].velocity, IsClose(Vector3d(0, 0, 0), Order(1e-9)));
            }
        }
}

TEST_CASE("island solver: Newton's method is asked where sweeps do not converge", "[rigid]")
{
    Column light({1}), heavy({1, 1e4});
    solve(light);
    solve(heavy);
    CHECK(light.counted.newton_solves == 0);
    CHECK(light.counted.contact_sweeps == 2); // the second sweep changes nothing
    CHECK(light.counted.early_exits == 1);
    CHECK(heavy.counted.newton_solves == 1);
}

TEST_CASE("island solver: a box at rest on its corners neither moves nor turns", "[rigid]")
{
    for (const Way way : ways) {
        CAPTURE(static_cast<int>(way));
        HandMade problem;
        choose(problem, way);
        Body box = ball_at({0, 0.25, 0}, 3, {0, -g * problem.time_step, 0});
        box.inverse_inertia = Vector3d(2, 3, 5).asDiagonal();
        problem.add(box);
        for (const double x : {-0.5, 1.0}) // the center of mass is not in the middle
            for (const double z : {-0.5, 0.7})
                problem.touch(1, 0, {x, 0, z}).friction = 0.5;
        solve(problem);
        Vector3d sum(0, 0, 0);
        for (const ContactConstraint& c : problem.contacts) {
            CHECK(c.contact_impulse.y() >= 0);
            sum += c.contact_impulse;
        }
        CHECK_THAT(sum, IsClose(Vector3d(0, 3 * g * 0.01, 0), Order(1e-10)));
        CHECK_THAT(problem.bodies[1].velocity, IsClose(Vector3d(0, 0, 0), Order(1e-10)));
        CHECK_THAT(problem.bodies[1].angular_velocity, IsClose(Vector3d(0, 0, 0), Order(1e-10)));
    }
}

TEST_CASE("island solver: impulses are in their cones and are all that changes the momentum",
          "[rigid]")
{
    for (const Way way : ways)
        for (Random random : seeds(20)) {
            CAPTURE(static_cast<int>(way));
            Pile pile(random);
            choose(pile, way);
            const Vector3d before = momentum(pile.bodies);
            solve(pile);
            Vector3d from_ground(0, 0, 0);
            double total = 1;
            for (const ContactConstraint& c : pile.contacts) {
                const Vector3d j = c.contact_impulse;
                const double j_n = j.dot(c.normal), j_T = (j - j_n * c.normal).norm();
                check_at_least(j_n, 0, "the normal impulse", j.norm());
                check_at_most(j_T, c.friction * j_n, "friction, by its limit", 8 * j.norm());
                if (c.body2 == 0) from_ground += j;
                total += j.norm();
            }
            CHECK_THAT(Vector3d(momentum(pile.bodies) - before),
                       IsClose(from_ground, Rounding(2000, 10 * total)));
        }
}

TEST_CASE("island solver: a row of balls that is hit moves on as one to rounding", "[rigid]")
{
    // Plain sweeps would need 60 iterations for that, and Newton's method is not used for bodies
    // that move.
    for (const Way way : ways) {
        CAPTURE(static_cast<int>(way));
        HandMade row;
        choose(row, way);
        row.settings.gravity.setZero();
        for (int i = 0; i < 5; ++i)
            row.add(ball_at({1.0 * i, 0, 0}, 2, {i == 0 ? 5.0 : 0.0, 0, 0}));
        for (int i = 1; i < 5; ++i)
            row.touch(i, i + 1, {i - 0.5, 0, 0}, {-1, 0, 0});
        solve(row);
        CHECK(row.counted.newton_solves == 0);
        CHECK(row.counted.early_exits == 1);
        for (int i = 1; i <= 5; ++i)
            CHECK_THAT(row.bodies[i].velocity, IsClose(Vector3d(1, 0, 0), Rounding(1000, 5)));
        for (int i = 1; i < 5; ++i) // what the balls beyond this contact need
            CHECK_THAT(row.contacts[i - 1].contact_impulse,
                       IsClose(Vector3d(-2.0 * (5 - i), 0, 0), Rounding(1000, 10)));
    }
}

TEST_CASE("island solver: any number of threads gives the same bits", "[rigid]")
{
    for (const Way way : ways) {
        CAPTURE(static_cast<int>(way));
        Field one(20, 1), two(20, 2), three(20, 3);
        REQUIRE(one.island.colors.size() > 1); // several threads can sweep it
        for (Field* field : {&one, &two, &three}) {
            choose(*field, way);
            solve(*field);
        }
        REQUIRE(one.counted.contact_impulses > 1000);
        REQUIRE(one.counted.early_exits == 1);
        for (const Field* other : {&two, &three}) {
            for (std::size_t i = 0; i < one.bodies.size(); ++i)
                REQUIRE(moves_alike(other->bodies[i], one.bodies[i]));
            for (std::size_t k = 0; k < one.contacts.size(); ++k)
                REQUIRE(other->contacts[k].contact_impulse == one.contacts[k].contact_impulse);
            CHECK(other->counted.contact_sweeps == one.counted.contact_sweeps);
        }
    }
}

TEST_CASE("island solver: without early exit the result is the same", "[rigid]")
{
    for (const Way way : ways) {
        CAPTURE(static_cast<int>(way));
        Column with({5, 1, 3}), without({5, 1, 3});
        choose(with, way);
        choose(without, way);
        without.settings.optimisations.early_exit = false;
        solve(with);
        solve(without);
        CHECK(with.counted.early_exits > 0);
        CHECK(without.counted.early_exits == 0);
        CHECK(without.counted.contact_sweeps > with.counted.contact_sweeps);
        for (int k = 0; k < 3; ++k)
            CHECK_THAT(without.contacts[k].contact_impulse,
                       IsClose(with.contacts[k].contact_impulse, Order(1e-10)));
    }
}
