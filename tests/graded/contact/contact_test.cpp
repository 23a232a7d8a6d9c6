// SPDX-License-Identifier: MIT
// A5.1 and A5.2: contacts resolved one at a time, by impulses that are weak in the first
// iterations.
#include "contact_laws.hpp"
#include "support/seeds.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rigor::testing {

namespace {

constexpr int most = std::numeric_limits<int>::max(), least = std::numeric_limits<int>::min();

// A ball of 1 kg that hits the floor.
ContactCase ball_on_floor(const Vector3d& V, double friction, double separation_speed = 0)
{
    ContactCase result{{Body(), ball(1, V)}, {touch(1, 0, 0.01, {0, 0, 0}, friction)}};
    result.contacts[0].separation_speed = separation_speed;
    return result;
}

// The rod falls flat at 1 m/s, with both its ends on the floor.
ContactCase falling_rod(double left_depth, double right_depth)
{
    return {{Body(), rod(-up)},
            {touch(1, 0, left_depth, {-1, 0, 0}), touch(1, 0, right_depth, {1, 0, 0})}};
}

ContactResult resolved(const ContactCase& problem, int n)
{
    return resolve_contacts(problem.bodies, problem.contacts, n);
}

// Checks the upward impulses at the two ends of the rod.
void check_ends(const ContactResult& result, double left, double right, const View& view = {})
{
    const Tolerance tolerance = Rounding(32, view.mass * view.speed);
    check_count(result.impulses.size(), 2, "impulses, one for each contact");
    REQUIRE_THAT(result.impulses[0], IsClose(view.impulse(left * up), tolerance));
    REQUIRE_THAT(result.impulses[1], IsClose(view.impulse(right * up), tolerance));
}

// Two blocks fall at 1 m/s, one on top of the other. Checks what one iteration does to them.
void check_two_blocks(double lower, double upper, const View& view = {})
{
    const double shared = lower * upper / (lower + upper);
    const Tolerance rounding = Rounding(16, view.mass * view.speed * std::max(lower, upper));
    const auto velocity = [&](double speed) {
        return IsClose(view.velocity(-speed * up), Rounding(16, view.speed));
    };
    ContactCase blocks = stack({lower, upper});
    blocks.contacts[0].depth = 0.02;
    const ContactResult upwards = resolved(turned(blocks, view), 1);
    REQUIRE_THAT(upwards.impulses,
                 IsClose(std::vector<Vector3d>{view.impulse(lower * up), view.impulse(shared * up)},
                         rounding));
    REQUIRE_THAT(upwards.bodies[1].velocity, velocity(shared / lower));
    REQUIRE_THAT(upwards.bodies[2].velocity, velocity(shared / lower));
    // if the upper contact comes first, its blocks do not approach yet, and it is not visited again
    blocks.contacts[0].depth = 0.005;
    const ContactResult downwards = resolved(turned(blocks, view), 1);
    REQUIRE_THAT(downwards.impulses,
                 IsClose(std::vector<Vector3d>{view.impulse(lower * up), 0 * up}, rounding));
    REQUIRE_THAT(downwards.bodies[2].velocity, velocity(1));
}

} // namespace

TEST_CASE("contact: in ten iterations restitution rises from -0.9 to 0", "[A5.1][contact]")
{
    const double expected[] = {-0.9, -0.8, -0.7, -0.6, -0.5, -0.4, -0.3, -0.2, -0.1, 0};
    for (int k = 0; k < 10; ++k) {
        CAPTURE(k);
        REQUIRE_THAT(contact_restitution(k, 10), IsClose(expected[k], Rounding(4, 1)));
    }
    REQUIRE_THAT(contact_restitution(0, 4), IsClose(-0.75, Rounding(4, 1)));
    REQUIRE_THAT(contact_restitution(0, 2), IsClose(-0.5, Rounding(4, 1)));
}

TEST_CASE("contact: the last iteration stops what approaches", "[A5.1][contact]")
{
    for (int n : {1, 2, 3, 7, 10, 49, 1000, most})
        REQUIRE_THAT(contact_restitution(n - 1, n), IsExactly(0.0));
}

TEST_CASE("contact: restitution rises by equal steps and stays from -1 to 0", "[A5.1][contact]")
{
    for (int n : {2, 3, 10, 97})
        for (int k = 0; k + 1 < n; ++k) {
            CAPTURE(k, n);
            const double here = contact_restitution(k, n), next = contact_restitution(k + 1, n);
            REQUIRE_THAT(next - here, IsClose(1.0 / n, Rounding(8, 1)));
            check_at_least(here, -1, "ε");
            check_at_most(here, 0, "ε");
        }
}

TEST_CASE("contact: restitution outside of the iterations", "[A5.1][contact]")
{
    for (int k : {-1, -7, least}) {
        CAPTURE(k);
        REQUIRE_THAT(contact_restitution(k, 10), IsClose(-0.9, Rounding(4, 1)));
        REQUIRE_THAT(contact_restitution(k, 1), IsExactly(0.0));
    }
    for (int k : {10, 11, most})
        REQUIRE_THAT(contact_restitution(k, 10), IsExactly(0.0));
    for (int n : {0, -1, least})
        for (int k : {least, -1, 0, 1, most})
            REQUIRE_THAT(contact_restitution(k, n), IsExactly(0.0));
}

TEST_CASE("contact: one ball on the floor is stopped in any number of iterations",
          "[A5.2][contact]")
{
    for (int n : {1, 2, 10, 33}) {
        CAPTURE(n);
        // the ball sticks: an impulse of -0.3/3.5 across the normal stops its lowest point
        const ContactResult stuck = resolved(ball_on_floor({0.3, -2, 0}, 0.5), n);
        REQUIRE_THAT(stuck.impulses,
                     IsClose(std::vector{Vector3d(-0.3 / 3.5, 2, 0)}, Rounding(64, 2)));
        REQUIRE_THAT(stuck.bodies[1].velocity,
                     IsClose(Vector3d(0.3 - 0.3 / 3.5, 0, 0), Rounding(64, 2)));
        // the ball slides: friction is 0.1 times the push in each iteration, and so in total
        const ContactResult sliding = resolved(ball_on_floor({3, -2, 0}, 0.1), n);
        REQUIRE_THAT(sliding.impulses, IsClose(std::vector{Vector3d(-0.2, 2, 0)}, Rounding(64, 2)));
    }
}

TEST_CASE("contact: the deepest end of a rod is stopped first", "[A5.2][contact]")
{
    // One iteration with ε = 0. The left end comes first: an impulse of 1/4 stops it and pushes the
    // other end down by 2/4 to 1.5 m/s. Then the other end gets 1.5/4.
    check_ends(resolved(falling_rod(0.02, 0.01), 1), 0.25, 0.375);
    check_ends(resolved(falling_rod(0.01, 0.02), 1), 0.375, 0.25);
    // with equal depths the first contact of the list comes first
    check_ends(resolved(falling_rod(0.01, 0.01), 1), 0.25, 0.375);
    // a gap is less than any depth, and all contacts may have gaps
    check_ends(resolved(falling_rod(-0.02, -0.01), 1), 0.375, 0.25);
    // depths differ however little they do
    for (int power = 1; power <= 52; ++power) {
        CAPTURE(power);
        const double deeper = 1 + std::ldexp(1, -power);
        check_ends(resolved(falling_rod(deeper, 1), 1), 0.25, 0.375);
        check_ends(resolved(falling_rod(1, deeper), 1), 0.375, 0.25);
    }
}

TEST_CASE("contact: a contact closes when its body only turns differently", "[A5.2][contact]")
{
    // A dumbbell with M = 1 and I = 1 turns at 1 rad/s about z. The two last contacts brake it by
    // opposite impulses, so that V is 0 after each iteration. In the second iteration the end at
    // x = 1 rises at 0.5 m/s only, and the first contact asks for 0.75 m/s.
    Body dumbbell = block(1, {0, 0, 0});
    dumbbell.inverse_inertia = Matrix3d::Identity();
    dumbbell.angular_velocity = dumbbell.angular_momentum = {0, 0, 1};
    ContactCase problem = {{Body(), dumbbell},
                           {touch(1, 0, 0.03, {1, 0, 0}), touch(1, 0, 0.02, {0, 1, 0}),
                            touch(1, 0, 0.01, {0, -1, 0})}};
    problem.contacts[0].separation_speed = 0.75;
    problem.contacts[1].normal = {1, 0, 0};
    problem.contacts[2].normal = {-1, 0, 0};
    const ContactResult result = resolved(problem, 2);
    REQUIRE_THAT(result.impulses,
                 IsClose(std::vector<Vector3d>{{0, 0.125, 0}, {0.5625, 0, 0}, {-0.5625, 0, 0}},
                         Rounding(16, 1)));
}

TEST_CASE("contact: a gentle sweep shares the load more evenly", "[A5.2][contact]")
{
    // Two iterations. With ε = -1/2 an impulse of 1/8 halves the left end's speed and brings the
    // other to 1.25 m/s, which gets 0.625/4. With ε = 0 the left end has 0.8125 m/s. After it is
    // stopped, the right end has 1.03125 m/s.
    const ContactResult result = resolved(falling_rod(0.02, 0.01), 2);
    check_ends(result, 0.328125, 0.4140625);
    REQUIRE_THAT(velocity_at(result.bodies[1], {-1, 0, 0}),
                 IsClose(Vector3d(0, -0.515625, 0), Rounding(32, 1)));
    REQUIRE_THAT(velocity_at(result.bodies[1], {1, 0, 0}),
                 IsClose(Vector3d(0, 0, 0), Rounding(32, 1)));
}

TEST_CASE("contact: ten gentle iterations on a rod", "[A5.2][contact]")
{
    const auto [first, second] = impulses_on_both_ends(10);
    const ContactResult result = resolved(falling_rod(0.01, 0.02), 10);
    check_ends(result, second, first);
    // what is left of the 1 m/s of the end that is stopped first; with n = 1 it is 0.75 m/s
    REQUIRE_THAT(velocity_at(result.bodies[1], {1, 0, 0}),
                 IsClose(Vector3d(0, -0.0162932134258535, 0), Rounding(64, 1)));

    // other points of the rod, seen from elsewhere
    for (Random random : seeds(5)) {
        const View view = random_view(random);
        const double a = random.uniform(-1, -0.6), b = random.uniform(0.6, 1);
        const auto [at_a, at_b] = impulses_on_both_ends(10, a, b);
        const ContactCase problem = turned(rod_on_both_ends(a, b), view);
        const ContactResult there = resolved(problem, 10);
        check_ends(there, at_a, at_b, view);
        const double v = -1 + (1 + 3 * a * a) * at_a + (1 + 3 * a * b) * at_b;
        REQUIRE_THAT(velocity_at(there.bodies[1], problem.contacts[0].point),
                     IsClose(view.velocity(v * up), Rounding(64, view.speed)));
    }
}

TEST_CASE("contact: a contact sees what those before it have done", "[A5.2][contact]")
{
    check_two_blocks(1, 1);
    for (Random random : seeds(5)) {
        const double lower = random.uniform(0.5, 2), upper = random.uniform(0.5, 2);
        check_two_blocks(lower, upper, random_view(random));
    }
}

TEST_CASE("contact: what separates or slides along is left alone", "[A5.2][contact]")
{
    for (const Vector3d& V : {Vector3d(0.3, 2, 0), Vector3d(0.3, 0, 0)}) {
        const ContactCase problem = ball_on_floor(V, 0.5);
        const ContactResult result = resolved(problem, 10);
        REQUIRE_THAT(result.bodies, IsExactly(problem.bodies));
        REQUIRE_THAT(result.impulses, IsExactly(std::vector<Vector3d>{{0, 0, 0}}));
    }
}

TEST_CASE("contact: a contact ends with the separation speed it asks for", "[A5.2][contact]")
{
    for (int n : {1, 2, 10}) {
        CAPTURE(n);
        const auto upwards = [n](double V, double s) {
            const ContactResult result = resolved(ball_on_floor({0, V, 0}, 0, s), n);
            REQUIRE_THAT(result.impulses[0].y(),
                         IsClose(result.bodies[1].velocity.y() - V, Rounding(64, 4)));
            return result.bodies[1].velocity.y();
        };
        REQUIRE_THAT(upwards(-1, 0.25), IsClose(0.25, Rounding(64, 2)));    // it is pushed apart
        REQUIRE_THAT(upwards(-1, -0.25), IsClose(-0.25, Rounding(64, 2)));  // it may close a gap
        REQUIRE_THAT(upwards(0.125, 0.25), IsClose(0.25, Rounding(64, 2))); // it is not fast enough
        REQUIRE_THAT(upwards(-0.25, -0.5), IsExactly(-0.25));               // it is slow enough
        REQUIRE_THAT(upwards(0.5, 0.25), IsExactly(0.5));                   // it is fast enough
    }
}

TEST_CASE("contact: friction is bounded by the whole push", "[A5.2][contact]")
{
    // It takes a push of 2.5 N s to leave at 0.5 m/s. 0.4 times 2.5 is more than the 6/7 that stop
    // the sliding, but 0.4 times the push of 2 N s that would stop the fall alone is less.
    const ContactResult result = resolved(ball_on_floor({3, -2, 0}, 0.4, 0.5), 1);
    REQUIRE_THAT(result.impulses,
                 IsClose(std::vector{Vector3d(-6.0 / 7, 2.5, 0)}, Rounding(64, 3)));
}

TEST_CASE("contact: without iterations or contacts nothing changes", "[A5.2][contact]")
{
    const ContactCase problem = random_case(1, false);
    for (int n : {0, -1, least}) {
        const ContactResult result = resolved(problem, n);
        REQUIRE_THAT(result.bodies, IsExactly(problem.bodies));
        REQUIRE_THAT(result.impulses,
                     IsExactly(std::vector<Vector3d>(problem.contacts.size(), {0, 0, 0})));
    }
    REQUIRE_THAT(resolve_contacts(problem.bodies, {}, 10).bodies, IsExactly(problem.bodies));
    check_count(resolve_contacts(problem.bodies, {}, 10).impulses.size(), 0, "impulses");
    check_count(resolve_contacts({}, {}, 10).bodies.size(), 0, "bodies");
}

TEST_CASE("contact: between two static bodies nothing happens", "[A5.2][contact]")
{
    Random random(1);
    const Bodies bodies = {static_body(random), static_body(random)}; // moving as conveyor belts do
    for (int sign : {-1, 1}) {
        BodyContact c = touch(0, 1, 0.1);
        c.normal = sign * up;
        const ContactResult result = resolve_contacts(bodies, {c}, 10);
        REQUIRE_THAT(result.bodies, IsExactly(bodies));
        REQUIRE_THAT(result.impulses, IsExactly(std::vector<Vector3d>{{0, 0, 0}}));
    }
}

} // namespace rigor::testing
