// SPDX-License-Identifier: MIT
// A5.5: all contacts at once. These tests are about single sweeps and exact answers.
#include "contact_laws.hpp"
#include "support/seeds.hpp"

#include <algorithm>
#include <cmath>

namespace rigor::testing::contact_simultaneous_test {

namespace {

ContactResult resolved(const ContactCase& problem, int sweeps)
{
    return resolve_simultaneously(problem.bodies, problem.contacts, sweeps);
}

ContactCase ball_on_floor(const Vector3d& V, double friction, const Vector3d& guess = {0, 0, 0})
{
    ContactCase result{{Body(), ball(1, V)}, {touch(1, 0, 0, {0, 0, 0}, friction)}};
    result.contacts[0].impulse = guess;
    return result;
}

void check_impulses(const ContactResult& result, std::vector<Vector3d> expected,
                    const View& view = {})
{
    for (Vector3d& j : expected)
        j = view.impulse(j);
    REQUIRE_THAT(result.impulses, IsClose(expected, Rounding(64, 4 * view.mass * view.speed)));
}

// A rod of mass 1 and length 1 leans in the plane z = 0 along the unit vector d, its tip at the
// origin. There, K is 4 δ - 3 d dᵀ.
ContactCase leaning_rod(const Vector3d& d)
{
    Body leaning = block(1, -up, d / 2);
    leaning.inverse_inertia = 12 * (Matrix3d::Identity() - d * d.transpose());
    return {{Body(), leaning}, {touch(1, 0, 0, {0, 0, 0}, 1)}};
}

// Upward speed of a ball on the floor after a few sweeps, if the contact asks for a separation
// speed.
double upwards(double V, double separation_speed)
{
    ContactCase problem = ball_on_floor({0, V, 0}, 0);
    problem.contacts[0].separation_speed = separation_speed;
    return resolved(problem, 3).bodies[1].velocity.y();
}

} // namespace

TEST_CASE("contact: one sweep stops a ball on the floor", "[A5.5][contact]")
{
    for (int sweeps : {1, 2, 10}) {
        CAPTURE(sweeps);
        // K is diag(3.5, 1, 3.5) and λ = 3.5, so the ball sticks
        const ContactResult stuck = resolved(ball_on_floor({3, -2, 0}, 0.5), sweeps);
        check_impulses(stuck, {{-6.0 / 7, 2, 0}});
        REQUIRE_THAT(stuck.bodies[1].velocity, IsClose(Vector3d(15.0 / 7, 0, 0), Rounding(64, 2)));
    }
    // The ball slides at 3 m/s along x and 4 m/s along z. To stop this takes a friction impulse of
    // 5/3.5 N s, which is more than μ jₙ.
    check_impulses(resolved(ball_on_floor({3, -2, 4}, 0.5), 1), {{-0.6, 2, -0.8}});
    check_impulses(resolved(ball_on_floor({3, -2, 4}, 0.1), 1), {{-0.12, 2, -0.16}});
    check_impulses(resolved(ball_on_floor({3, -2, 4}, 0), 1), {{0, 2, 0}});
}

TEST_CASE("contact: friction follows the impulse along the normal at any separation speed",
          "[A5.5][contact]")
{
    // The ball slides as above. It is stopped as far as the contact asks, by jₙ = s + 2.
    for (const double s : {-3.0, -2.0, -1.75, -1.0, -0.5, -0.125, 0.0, 0.125, 0.5})
        for (const double friction : {0.1, 0.5}) {
            CAPTURE(s, friction);
            ContactCase problem = ball_on_floor({3, -2, 4}, friction);
            problem.contacts[0].separation_speed = s;
            const double j_n = std::max(s + 2, 0.0), j_t = friction * j_n;
            check_impulses(resolved(problem, 1), {{-0.6 * j_t, j_n, -0.8 * j_t}});
        }
}

TEST_CASE("contact: λ is the larger of two eigenvalues that are nearly equal", "[A5.5][contact]")
{
    // At 0.1 (δ, 0, δ/2) the lever arm of the ball is r = 0.1 (δ, -1, δ/2), and 1/I is 250. So
    // nᵀ K n = 1 + 2.5 · 1.25 δ², and λ = 1 + 250 r², across r and n.
    for (int power = 1; power <= 30; ++power) {
        CAPTURE(power);
        const double delta = std::ldexp(1, -power), squared = 1.25 * delta * delta;
        ContactCase problem = ball_on_floor({0.3, -2, 0.4}, 0.5);
        problem.contacts[0].point = {0.1 * delta, 0, 0.05 * delta};
        const double j_n = 2 / (1 + 2.5 * squared), lambda = 3.5 + 2.5 * squared;
        check_impulses(resolved(problem, 1), {{-0.3 / lambda, j_n, -0.4 / lambda}});
    }
}

TEST_CASE("contact: a ball that leaves the floor gets no impulse", "[A5.5][contact]")
{
    const ContactCase problem = ball_on_floor({3, 2, 0}, 0.5);
    const ContactResult result = resolved(problem, 10);
    check_impulses(result, {{0, 0, 0}});
    REQUIRE_THAT(result.bodies, IsClose(problem.bodies, Rounding(16, 4)));
}

TEST_CASE("contact: the ends of a rod in turn", "[A5.5][contact]")
{
    // An impulse of 1/4 stops the first end and brings the other to 1.5 m/s; 1.5/4 stops the other
    // end and brings the first to 0.75 m/s; and so on. In each sweep the difference from 1/2 falls
    // to a quarter.
    ContactCase problem{{Body(), rod(-up)},
                        {touch(1, 0, 0.01, {-1, 0, 0}), touch(1, 0, 0.02, {1, 0, 0})}};
    check_impulses(resolved(problem, 1), {0.25 * up, 0.375 * up});
    check_impulses(resolved(problem, 2), {0.4375 * up, 0.46875 * up});
    check_impulses(resolved(problem, 3), {0.484375 * up, 0.4921875 * up});
    check_impulses(resolved(problem, 60), {0.5 * up, 0.5 * up});
    // depth does not matter, the order of the list does
    std::swap(problem.contacts[0], problem.contacts[1]);
    check_impulses(resolved(problem, 2), {0.4375 * up, 0.46875 * up});

    // other points of the rod, seen from elsewhere
    for (Random random : seeds(5)) {
        const View view = random_view(random);
        const double a = random.uniform(-1, -0.6), b = random.uniform(0.6, 1);
        problem = rod_on_both_ends(a, b);
        problem.contacts[0].depth = random.uniform(0, 0.02);
        problem = turned(problem, view);
        double at_a = 0, at_b = 0;
        for (int sweeps = 1; sweeps <= 5; ++sweeps) {
            CAPTURE(sweeps);
            // an impulse j at x adds (1 + 3 x y) j to the speed at y
            at_a = (1 - (1 + 3 * a * b) * at_b) / (1 + 3 * a * a);
            at_b = (1 - (1 + 3 * a * b) * at_a) / (1 + 3 * b * b);
            check_impulses(resolved(problem, sweeps), {at_a * up, at_b * up}, view);
        }
    }
}

TEST_CASE("contact: friction is stepped by the larger eigenvalue across the normal",
          "[A5.5][contact]")
{
    // A rod leans at 45°. K is (2.5 -1.5 0; -1.5 2.5 0; 0 0 4), and λ = 4.
    const ContactCase problem = leaning_rod(Vector3d(1, 1, 0).normalized());

    // jₙ = 1/2.5; then the tip slides at -0.6 m/s, and 0.6/4 is less than jₙ
    check_impulses(resolved(problem, 1), {{0, 0.4, 0}});
    check_impulses(resolved(problem, 2), {{0.15, 0.4, 0}});
    // then both the normal and the tangential velocity of the tip are -0.225 m/s:
    // 0.4 + 0.225/2.5 = 0.49 and 0.15 + 0.225/4 = 0.20625
    check_impulses(resolved(problem, 3), {{0.20625, 0.49, 0}});
    // in the end the tip sticks: j = K⁻¹ (0, 1, 0)
    check_impulses(resolved(problem, 200), {{0.375, 0.625, 0}});
    REQUIRE_THAT(velocity_of(resolved(problem, 200).bodies, problem.contacts[0]),
                 IsClose(Vector3d(0, 0, 0), Rounding(256, 1)));

    // a rod that leans at another angle, seen from elsewhere; λ is still 4
    for (Random random : seeds(5)) {
        const View view = random_view(random);
        const double angle = random.uniform(0.5, 1);
        const Vector3d d(std::cos(angle), std::sin(angle), 0);
        const Matrix3d K = 4 * Matrix3d::Identity() - 3 * d * d.transpose();
        const ContactCase there = turned(leaning_rod(d), view);
        Vector3d j(0, 0, 0);
        for (int sweeps = 1; sweeps <= 10; ++sweeps) {
            CAPTURE(sweeps);
            const Vector3d v = K * j - up;
            j.y() = std::max(0.0, j.y() - v.y() / K(1, 1));
            j.x() = std::clamp(j.x() - v.x() / 4, -j.y(), j.y());
            check_impulses(resolved(there, sweeps), {j}, view);
        }
    }
}

TEST_CASE("contact: how far a push moves its contact along the normal has no part in friction",
          "[A5.5][contact]")
{
    // A plate can turn in its own plane z = 0 only. K is (1.75 -0.75 0; -0.75 1.75 0; 0 0 1), so λ
    // = 1.75. The value 2.5 would be the eigenvalue of a direction that is half along the normal.
    Body plate = block(1, -up, {0.5, 0.5, 0});
    plate.inverse_inertia.diagonal() = Vector3d(0, 0, 3);
    const ContactCase problem{{Body(), plate}, {touch(1, 0, 0, {0, 0, 0}, 1)}};

    check_impulses(resolved(problem, 1), {{0, 4.0 / 7, 0}});
    check_impulses(resolved(problem, 2), {{12.0 / 49, 4.0 / 7, 0}});
    check_impulses(resolved(problem, 3), {{12.0 / 49, 232.0 / 343, 0}});
    check_impulses(resolved(problem, 200), {{0.3, 0.7, 0}});
}

TEST_CASE("contact: friction is shortened by the new push", "[A5.5][contact]")
{
    // the guess pushes four times too hard and lies on the border of the cone
    const ContactResult result = resolved(ball_on_floor({3, -2, 0}, 0.1, {-0.8, 8, 0}), 1);
    check_impulses(result, {{-0.2, 2, 0}});
    REQUIRE_THAT(result.bodies[1].velocity, IsClose(Vector3d(2.8, 0, 0), Rounding(64, 8)));
}

TEST_CASE("contact: friction is shortened even if nothing slides", "[A5.5][contact]")
{
    // With the guess the ball has the velocity (0, s, 0), and the new push is 4 - s.
    for (const double s : {1.0, 3.0, 3.9}) {
        CAPTURE(s);
        ContactCase problem{{Body(), block(1, {-1, s - 4, 0})}, {touch(1, 0, 0, {0, 0, 0}, 0.25)}};
        problem.contacts[0].impulse = {1, 4, 0};
        check_impulses(resolved(problem, 1), {{(4 - s) / 4, 4 - s, 0}});
    }
}

TEST_CASE("contact: friction counts however slowly the contact slides", "[A5.5][contact]")
{
    for (int power = 2; power <= 60; power += 2) {
        CAPTURE(power);
        const double slow = std::ldexp(1, -power);
        const ContactResult result = resolved(ball_on_floor({slow, -2, 0}, 0.5), 1);
        REQUIRE_THAT(result.impulses[0].x(), IsClose(-slow / 3.5, Rounding(16)));
    }
}

TEST_CASE("contact: a push that was too hard is taken back", "[A5.5][contact]")
{
    ContactResult result = resolved(ball_on_floor({0, -1, 0}, 0, 10 * up), 1);
    check_impulses(result, {up});
    REQUIRE_THAT(result.bodies[1].velocity, IsClose(Vector3d(0, 0, 0), Rounding(64, 10)));
    // the total impulse never pulls
    result = resolved(ball_on_floor({0, 3, 0}, 0, 10 * up), 1);
    check_impulses(result, {{0, 0, 0}});
    REQUIRE_THAT(result.bodies[1].velocity, IsClose(Vector3d(0, 3, 0), Rounding(64, 10)));
    result = resolved(ball_on_floor({1, 3, 0}, 0.5, {1, -10, 2}), 1);
    check_impulses(result, {{0, 0, 0}});

    for (Random random : seeds(5)) {
        const View view = random_view(random);
        const double speed = random.uniform(0.5, 3), guess = random.uniform(2, 5);
        for (double V : {-speed, speed}) {
            result = resolved(turned(ball_on_floor({0, V, 0}, 0, guess * up), view), 1);
            check_impulses(result, {std::max(0.0, -V) * up}, view);
            REQUIRE_THAT(result.bodies[1].velocity, IsClose(view.velocity(std::max(0.0, V) * up),
                                                            Rounding(64, 10 * view.speed)));
        }
        result = resolved(turned(ball_on_floor({1, speed, 0}, 0.5, {1, -guess, 2}), view), 1);
        check_impulses(result, {{0, 0, 0}}, view);
    }
}

TEST_CASE("contact: a simultaneous contact ends with the separation speed it asks for",
          "[A5.5][contact]")
{
    REQUIRE_THAT(upwards(-1, 0.25), IsClose(0.25, Rounding(64, 2)));    // it is pushed apart
    REQUIRE_THAT(upwards(-1, -0.25), IsClose(-0.25, Rounding(64, 2)));  // it may close a gap
    REQUIRE_THAT(upwards(0.125, 0.25), IsClose(0.25, Rounding(64, 2))); // it is not fast enough
    REQUIRE_THAT(upwards(-0.25, -0.5), IsClose(-0.25, Rounding(8)));    // it is slow enough
    REQUIRE_THAT(upwards(0.5, 0.25), IsClose(0.5, Rounding(8)));        // it is fast enough
}

TEST_CASE("contact: each contact of a stack carries all that lies above it", "[A5.5][contact]")
{
    const ContactCase problem = stack({3, 1, 2});
    const ContactResult result = resolved(problem, 400);
    check_impulses(result, {6 * up, 3 * up, 2 * up});
    for (int i = 1; i <= 3; ++i)
        REQUIRE_THAT(result.bodies[i].velocity, IsClose(Vector3d(0, 0, 0), Rounding(64, 6)));
}

TEST_CASE("contact: started from the exact answer every sweep leaves it there", "[A5.5][contact]")
{
    ContactCase problem = stack({3, 1, 2});
    for (int i = 0; i < 3; ++i)
        problem.contacts[i].impulse = std::array{6.0, 3.0, 2.0}[i] * up;
    for (int sweeps : {0, 1, 2, 50}) {
        CAPTURE(sweeps);
        const ContactResult result = resolved(problem, sweeps);
        check_impulses(result, {6 * up, 3 * up, 2 * up});
        for (int i = 1; i <= 3; ++i)
            REQUIRE_THAT(result.bodies[i].velocity, IsClose(Vector3d(0, 0, 0), Rounding(64, 6)));
    }
}

TEST_CASE("contact: a seesaw tilts as if its blocks were glued on", "[A5.5][contact]")
{
    const ContactResult result = resolved(seesaw(), 400);
    REQUIRE_THAT(result.bodies, IsClose(tilting_seesaw(), Rounding(64, 10)));
    // 10 kg fell at 1 m/s; now their momentum is -6 · 4/9 + 2 · 4/9
    REQUIRE_THAT(result.impulses,
                 IsClose(std::vector<Vector3d>{74.0 / 9 * up, 10.0 / 3 * up, 26.0 / 9 * up},
                         Rounding(64, 10)));
}

TEST_CASE("contact: three balls in a row end together", "[A5.5][contact]")
{
    // The first ball runs into two at rest. These contacts are plastic.
    ContactCase row{{block(1, {1, 0, 0}), block(1), block(1)}, {touch(1, 0, 0), touch(2, 1, 0)}};
    for (BodyContact& c : row.contacts)
        c.normal = Vector3d::UnitX();
    // the first contact is resolved alone, then the second
    const ContactResult once = resolved(row, 1);
    REQUIRE_THAT(once.impulses,
                 IsClose(std::vector<Vector3d>{{0.5, 0, 0}, {0.25, 0, 0}}, Rounding(64, 1)));
    const ContactResult result = resolved(row, 100);
    REQUIRE_THAT(result.impulses,
                 IsClose(std::vector<Vector3d>{{2.0 / 3, 0, 0}, {1.0 / 3, 0, 0}}, Rounding(64, 1)));
    for (const Body& body : result.bodies)
        REQUIRE_THAT(body.velocity, IsClose(Vector3d(1.0 / 3, 0, 0), Rounding(64, 1)));
}

TEST_CASE("contact: a block that slides in a groove", "[A5.5][contact]")
{
    // Walls at 45°: each pushes with 1/√2 to hold the falling block, and the friction of both along
    // the groove is √2 μ, which is more than that of a floor.
    const auto along_the_groove = [](double friction) {
        ContactCase groove{
            {Body(), block(1, {0, -1, 0.3})},
            {touch(1, 0, 0, {0, 0, 0}, friction), touch(1, 0, 0, {0, 0, 0}, friction)}};
        groove.contacts[0].normal = Vector3d(1, 1, 0).normalized();
        groove.contacts[1].normal = Vector3d(-1, 1, 0).normalized();
        return resolved(groove, 2000);
    };
    const ContactResult sliding = along_the_groove(0.1);
    REQUIRE_THAT(sliding.bodies[1].velocity,
                 IsClose(Vector3d(0, 0, 0.3 - 0.1 * std::sqrt(2.0)), Rounding(64, 1)));
    REQUIRE_THAT(sliding.impulses,
                 IsClose(std::vector<Vector3d>{{0.5, 0.5, -0.1 / std::sqrt(2.0)},
                                               {-0.5, 0.5, -0.1 / std::sqrt(2.0)}},
                         Rounding(64, 1)));
    // class B: it stops where √2 μ = 0.3
    const double critical = 0.3 / std::sqrt(2.0), d = 0.02;
    const double below = along_the_groove(critical * (1 - d)).bodies[1].velocity.z();
    const double above = along_the_groove(critical * (1 + d)).bodies[1].velocity.z();
    REQUIRE_THAT(below, IsClose(0.3 * d, Rounding(64, 1)));
    REQUIRE_THAT(above, IsClose(0.0, Rounding(64, 1)));
}

TEST_CASE("contact: without sweeps only the guess acts", "[A5.5][contact]")
{
    ContactCase problem = ball_on_floor({0, -1, 0}, 0.1, {3, -2, 1});
    for (int sweeps : {0, -1}) {
        const ContactResult result = resolved(problem, sweeps);
        REQUIRE_THAT(result.impulses, IsExactly(std::vector<Vector3d>{{3, -2, 1}}));
        REQUIRE_THAT(result.bodies[1].velocity, IsClose(Vector3d(3, -3, 1), Rounding(16)));
        check_bookkeeping(problem, result, 1);
    }
}

TEST_CASE("contact: simultaneously between two static bodies nothing happens", "[A5.5][contact]")
{
    Random random(1);
    const Bodies bodies = {static_body(random), static_body(random)};
    BodyContact c = touch(0, 1, 0.1, {0, 0, 0}, 0.5);
    c.impulse = Vector3d(1, 2, 3);
    for (int sweeps : {0, 1, 10}) {
        const ContactResult result = resolve_simultaneously(bodies, {c}, sweeps);
        REQUIRE_THAT(result.bodies, IsExactly(bodies));
        REQUIRE_THAT(result.impulses, IsExactly(std::vector<Vector3d>{{0, 0, 0}}));
    }
}

TEST_CASE("contact: simultaneously without contacts nothing changes", "[A5.5][contact]")
{
    const Bodies bodies = random_case(1, true).bodies;
    REQUIRE_THAT(resolve_simultaneously(bodies, {}, 10).bodies, IsExactly(bodies));
    check_count(resolve_simultaneously(bodies, {}, 10).impulses.size(), 0, "impulses");
    check_count(resolve_simultaneously({}, {}, 10).bodies.size(), 0, "bodies");
}

} // namespace rigor::testing::contact_simultaneous_test
