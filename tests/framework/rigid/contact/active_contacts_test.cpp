// SPDX-License-Identifier: MIT
#include "rigid/contact/active_contacts.hpp"

#include "framework/rigid/contact/hand_made.hpp"

using namespace rigor;
using namespace rigor::testing;

namespace {

using Indices = UninitializedVector<int>;

} // namespace

TEST_CASE("active contacts: bodies touch at the end of the step and not before", "[rigid]")
{
    HandMade problem;
    const int ball = problem.add(ball_at({0, 0.5, 0}, 2));
    problem.touch(ball, 0, {0, 0, 0}).gap = 0.03;
    problem.touch(ball, 0, {0, 0, 0}).gap = 0;
    problem.touch(ball, 0, {0, 0, 0}).gap = -0.03;
    CHECK(activate_contacts(problem, problem.island) == Indices{0, 1, 2});
    CHECK(problem.contacts[0].target_speed == -0.03 / 0.01);
    CHECK_THAT(problem.predicted_gap(problem.contacts[0], problem.contacts[0].target_speed),
               IsClose(0.0, Rounding(2, 0.03)));
    // With gravity an overlap is left to the position correction.
    CHECK(problem.contacts[1].target_speed == 0);
    CHECK(problem.contacts[2].target_speed == 0);
}

// Where faces rest on each other, their corners have slightly different gaps. If each had to close,
// the sweeps would pass the load from corner to corner, and the pile would creep.
TEST_CASE("active contacts: in a pile a tiny gap counts as closed", "[rigid]")
{
    HandMade problem;
    std::vector<int> balls;
    for (std::size_t i = 0; i <= few_bodies; ++i)
        balls.push_back(problem.add(ball_at({static_cast<double>(i), 0.5, 0}, 2)));
    const double tiny = 2 * penetration_slop * 0.5;
    for (const int ball : balls)
        problem.touch(ball, 0, {0, 0, 0}).gap = tiny;
    activate_contacts(problem, problem.island);
    REQUIRE_FALSE(is_pile(problem.island));
    CHECK(problem.contacts[0].target_speed == -tiny / 0.01);

    for (const int ball : balls)
        problem.touch(ball, 0, {0, 0, 0}).gap = 1.001 * tiny;
    activate_contacts(problem, problem.island);
    REQUIRE(is_pile(problem.island));
    CHECK(problem.contacts[0].target_speed == 0);
    CHECK(problem.contacts.back().target_speed == -1.001 * tiny / 0.01);
}

TEST_CASE("active contacts: a point that rotation carries past may come nearer", "[rigid]")
{
    HandMade problem;
    const int wheel = problem.add(ball_at({0, 0.5, 0}, 2));
    for (const double gap : {0.03, 0.0, -0.03}) {
        ContactConstraint& c = problem.touch(wheel, 0, {0, 0, 0});
        c.gap = gap;
        c.gap_correction = 0.02;
    }
    activate_contacts(problem, problem.island);
    CHECK_THAT(problem.contacts[0].target_speed, IsClose(-5.0, Rounding(4)));
    CHECK(problem.contacts[1].target_speed == -0.02 / 0.01);
    CHECK(problem.contacts[2].target_speed == -0.02 / 0.01);
}

TEST_CASE("active contacts: without gravity a speed removes a fifth of the overlap", "[rigid]")
{
    HandMade problem;
    problem.settings.gravity.setZero();
    const int ball = problem.add(ball_at({0, 0.5, 0}, 2));
    problem.touch(ball, 0, {0, 0, 0}).gap = -0.01;   // 0.5 mm are left, a thousandth of the radius
    problem.touch(ball, 0, {0, 0, 0}).gap = -0.0005; // nothing is corrected
    problem.touch(ball, 0, {0, 0, 0}).gap = -0.4;    // no faster than one radius per second
    CHECK(activate_contacts(problem, problem.island) == Indices{0, 1, 2});
    CHECK_THAT(problem.contacts[0].target_speed, IsClose(0.2 * 0.0095 / 0.01, Rounding(8)));
    CHECK(problem.contacts[1].target_speed == 0);
    CHECK(problem.contacts[2].target_speed == 0.5);
}

TEST_CASE("active contacts: those that no impulse can change are left out", "[rigid]")
{
    HandMade problem;
    CHECK(activate_contacts(problem, problem.island).empty());
    const int wall = problem.add(Body()), ball = problem.add(ball_at({0, 0.5, 0}, 2));
    problem.touch(wall, 0, {0, 0, 0}).gap = 0.01;
    CHECK(activate_contacts(problem, problem.island).empty());
    problem.touch(ball, wall, {0, 0, 0});
    problem.touch(wall, 0, {1, 0, 0});
    problem.touch(0, ball, {1, 0, 0});
    CHECK(activate_contacts(problem, problem.island) == Indices{1, 3});
    CHECK(problem.contacts[0].target_speed == 0); // it was left alone
}

TEST_CASE("active contacts: pairs keep their order for any number of threads", "[rigid]")
{
    for (const int threads : {1, 2, 3}) {
        CAPTURE(threads);
        HandMade problem(threads);
        const int ball = problem.add(ball_at({0, 0.5, 0}, 2)), wall = problem.add(Body());
        const int n = 2000;
        Indices expected;
        for (int i = 0; i < n; ++i)
            problem.touch(i % 3 ? ball : wall, 0, {0, 0, 0}).gap = i;
        // From the last pair to the first, as if that were the lowest.
        std::reverse(problem.island.pairs.begin(), problem.island.pairs.end());
        for (int i = n - 1; i >= 0; --i)
            if (i % 3) expected.push_back(i);
        REQUIRE(activate_contacts(problem, problem.island) == expected);
        for (int i : expected)
            REQUIRE(problem.contacts[i].target_speed == (i > 0 ? -i / problem.time_step : 0));
    }
}
