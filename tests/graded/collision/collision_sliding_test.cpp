// SPDX-License-Identifier: MIT
// A4.8: sliding friction, and contacts that jam.
#include "formulas/collision.hpp"
#include "sliding_pair.hpp"
#include "support/close.hpp"
#include "support/in_words.hpp"
#include "support/random.hpp"
#include "support/seeds.hpp"

#include <cmath>
#include <numbers>

namespace rigor::testing {

namespace {

// Checks that a rod jams if μ is at least the critical friction, where nᵀ K (n - μ T) is 0. With t,
// the slope of the rod, M nᵀ K n = (4 + t²)/(1 + t²) and M nᵀ K T = 3 t/(1 + t²).
void check_jam(double t, const Skid& skid)
{
    const Matrix3d K = skidding_rod(t, skid);
    const auto& [mass, along, down, restitution, T, n] = skid;
    const double critical = (4 + t * t) / (3 * t), nKn = (4 + t * t) / (1 + t * t) / mass;
    const double d = 1e-3, after = restitution * down;

    // just below, nᵀ K (n - μ T) is small, and the impulse, which is divided by it, is large
    const Vector3d below =
        sliding_friction_impulse(K, skid.v(), n, restitution, critical * (1 - d));
    REQUIRE_THAT(below.dot(n),
                 IsClose(skid.kick() / (nKn * d), Rounding(64, mass * skid.kick() / (d * d))));
    // just above, the contact sticks, since for motion in a plane the sticking impulse of a jammed
    // contact is in the cone
    const Vector3d above =
        sliding_friction_impulse(K, skid.v(), n, restitution, critical * (1 + d));
    REQUIRE_THAT(Vector3d(skid.v() + K * above),
                 IsClose(Vector3d(after * n), Rounding(64, 4 * skid.v().norm())));
}

} // namespace

TEST_CASE("collision: an oblique sphere that slides", "[A4.8][collision]")
{
    // a sphere of mass 1 and r = 0.1, v = (3, -2), ε = 0.5, μ = 0.1: jₙ = 3, j_T = -0.3
    const Vector3d j =
        sliding_friction_impulse(sphere_on_floor(), Vector3d(3, -2, 0), up, 0.5, 0.1);
    REQUIRE_THAT(j, IsClose(Vector3d(-0.3, 3, 0), Rounding(16)));
    REQUIRE_THAT(3 + j.x(), IsClose(2.7, Rounding(16)));            // V
    REQUIRE_THAT(0.1 * j.x() / 0.004, IsClose(-7.5, Rounding(16))); // ω = (r × j)/I about z

    for (Random random : seeds(5)) {
        const Skid skid = random_skid(random);
        const double friction = random.uniform(0, 0.5), j_n = skid.mass * skid.kick();
        REQUIRE_THAT(sliding_friction_impulse(skidding_sphere(skid), skid.v(), skid.n,
                                              skid.restitution, friction),
                     IsClose(Vector3d(j_n * (skid.n - friction * skid.T)), skid.rounding()));
    }
}

TEST_CASE("collision: friction takes speed from a block that slides down an incline",
          "[A4.8][collision]")
{
    // An incline of 30° with μ = 0.2 and a block of mass 2. In a time step gravity adds g h, the
    // plastic impulse of the incline takes away the normal part, and friction takes away μ times
    // that part: g (sin θ - μ cos θ) h is left.
    const double h = 0.01, theta = std::numbers::pi / 6;
    const Vector3d n(std::sin(theta), std::cos(theta), 0);
    const Vector3d downhill(std::cos(theta), -std::sin(theta), 0);
    const Vector3d v(0, -9.81 * h, 0);

    const Vector3d j = sliding_friction_impulse(Matrix3d::Identity() / 2, v, n, 0, 0.2);

    REQUIRE_THAT(Vector3d(v + j / 2),
                 IsClose(3.20585815777493 * h * downhill, Rounding(32, v.norm())));
}

TEST_CASE("collision: sliding friction is μ times the normal impulse against the sliding",
          "[A4.8][collision]")
{
    int cases = 0;
    for (unsigned seed : seeds(200)) {
        const CollidingPair pair = colliding_pair(seed);
        const double friction = Random(seed + 1000).uniform(0, 1);
        if (!slides_easily(pair, friction)) continue;
        ++cases;
        check_sliding(pair, friction,
                      sliding_friction_impulse(pair.K, pair.v, pair.n, pair.restitution, friction));
    }
    check_that(cases > 50, "more than 50 random cases could be judged");
}

TEST_CASE("collision: sliding without friction is the frictionless impulse", "[A4.8][collision]")
{
    for (unsigned seed : seeds(50)) {
        const auto [body1, body2, x, n, K, v, restitution, size, condition] = colliding_pair(seed);
        const Vector3d j = -(1 + restitution) * v.dot(n) / n.dot(K * n) * n;
        REQUIRE_THAT(sliding_friction_impulse(K, v, n, restitution, 0),
                     IsClose(j, Rounding(16, size * condition)));
    }
}

TEST_CASE("collision: what does not slide gets no sliding friction", "[A4.8][collision]")
{
    // the point moves straight down, and K couples normal and tangential motion: 1.5 · 2 / nᵀ K n
    const Vector3d j =
        sliding_friction_impulse(jamming_contact(), Vector3d(0, -2, 0), up, 0.5, 0.3);
    REQUIRE_THAT(j, IsClose(Vector3d(0, 0.75, 0), Rounding(8)));
    // a point at rest gets no impulse either
    REQUIRE_THAT(sliding_friction_impulse(jamming_contact(), Vector3d::Zero(), up, 0.5, 0.3),
                 IsExactly(Vector3d(0, 0, 0)));

    // motion straight along any normal, where rounding leaves a tangential speed of some eps
    for (unsigned seed : seeds(50)) {
        const CollidingPair pair = colliding_pair(seed);
        const Vector3d& n = pair.n;
        const Vector3d expected = 3 / n.dot(pair.K * n) * n;
        REQUIRE_THAT(sliding_friction_impulse(pair.K, -2 * n, n, 0.5, 0.3),
                     IsClose(expected, Rounding(16, expected.norm() * pair.condition)));
    }
}

TEST_CASE("collision: between two static bodies there is no sliding impulse", "[A4.8][collision]")
{
    const Matrix3d none = Matrix3d::Zero();
    REQUIRE_THAT(sliding_friction_impulse(none, Vector3d(1, -1, 0), up, 0.5, 0.3),
                 IsExactly(Vector3d(0, 0, 0)));
    REQUIRE_THAT(sliding_friction_impulse(none, Vector3d(0, -1, 0), up, 0.5, 0.3),
                 IsExactly(Vector3d(0, 0, 0)));
}

TEST_CASE("collision: a jammed contact gets the sticking impulse shortened to the cone",
          "[A4.8][collision]")
{
    const Vector3d v(2, -2, 0);
    const auto jammed = [&](double friction) {
        return sliding_friction_impulse(jamming_contact(), v, up, 0.5, friction);
    };
    // just before the contact jams, where nᵀ K (n - μ T) = 1, the formula still holds
    REQUIRE_THAT(jammed(1.5), IsClose(Vector3d(-4.5, 3, 0), Rounding(16)));
    // at μ = 2 the contact jams: |j_T| = 5 is shortened to μ · 2
    REQUIRE_THAT(jammed(2), IsClose(Vector3d(-3.2, 2, 2.4), Rounding(64)));
    REQUIRE_THAT(jammed(2.25), IsClose(Vector3d(-3.6, 2, 2.7), Rounding(64)));
    // from μ = 2.5 on, j_T needs no shortening
    REQUIRE_THAT(jammed(3), IsClose(Vector3d(-4, 2, 3), Rounding(64)));
    REQUIRE_THAT(jammed(1e6), IsClose(Vector3d(-4, 2, 3), Rounding(64)));
}

TEST_CASE("collision: a jammed contact is not pulled", "[A4.8][collision]")
{
    // the sticking impulse would be (-9, -3, 9)
    Matrix3d K;
    K << 2, 1, 2, //
        1, 5, 3,  //
        2, 3, 3;
    const Vector3d v(3, -2, 0);
    for (double friction : {5.0, 8.0, 1e6})
        for (const double speed : {1.0, 1e-3, 1e-6, 1e-12}) {
            CAPTURE(friction, speed);
            REQUIRE_THAT(sliding_friction_impulse(K, speed * v, up, 0.5, friction),
                         IsExactly(Vector3d(0, 0, 0)));
        }
}

TEST_CASE("collision: Painleve's rod jams from a friction of 4/3 on", "[A4.8][collision]")
{
    // nᵀ K (n - μ T) = 8/5 - μ 6/5
    check_jam(2, Skid());
    for (Random random : seeds(5)) {
        const double t = random.uniform(1.5, 3);
        check_jam(t, random_skid(random));
    }
}

TEST_CASE("collision: whatever the friction a sliding impulse is in the cone", "[A4.8][collision]")
{
    const auto check = [](const CollidingPair& pair, double friction) {
        const Vector3d& n = pair.n;
        const Vector3d j = sliding_friction_impulse(pair.K, pair.v, n, pair.restitution, friction);
        const double scale = 64 * (1 + friction) * j.norm() + impulse_scale(pair);
        check_at_least(j.dot(n), 0, "jₙ", scale);
        check_at_most(tangential(j, n).norm(), friction * j.dot(n), "|j_T|, by μ jₙ", scale);
    };
    CollidingPair rod = {{}, {}, {}, up, skidding_rod(2, {}), Vector3d(1, -1, 0), 0.5, 1, 1};
    check(rod, 4.0 / 3); // nᵀ K (n - μ T) is 0 up to rounding
    for (unsigned seed : seeds(50)) {
        const CollidingPair pair = colliding_pair(seed);
        for (double friction : {0.0, 0.3, 1.0, 3.0, 30.0, 1e6}) {
            CAPTURE(friction);
            check(pair, friction);
        }
    }
}

TEST_CASE("collision: a large friction makes a small coupling count", "[A4.8][collision]")
{
    // nᵀ K (n - μ T) = 1 - μ K_nT = 1/2
    for (int power = 0; power <= 40; power += 4) {
        const double friction = std::ldexp(1, power);
        CAPTURE(friction);
        Matrix3d K = Matrix3d::Identity();
        K(0, 1) = K(1, 0) = 0.5 / friction;
        const Vector3d j = sliding_friction_impulse(K, {1, -1, 0}, {0, 1, 0}, 0, friction);
        REQUIRE_THAT(j, IsClose(Vector3d(-2 * friction, 2, 0), Rounding(64, 2 * friction)));
        REQUIRE_THAT(j.y(), IsClose(2.0, Rounding(64, 2)));
    }
}

TEST_CASE("collision: a sliding impulse turns with the scene", "[A4.8][collision]")
{
    for (unsigned seed : seeds(50)) {
        const CollidingPair pair = colliding_pair(seed);
        const auto& [body1, body2, x, n, K, v, restitution, size, condition] = pair;
        const double friction = 0.4;
        if (!slides_easily(pair, friction)) continue;
        const Vector3d j = sliding_friction_impulse(K, v, n, restitution, friction);
        for (const Matrix3d& R : {turn(17, n), Random(seed + 1000).rotation()})
            REQUIRE_THAT(sliding_friction_impulse(R * K * R.transpose(), R * v, R * n, restitution,
                                                  friction),
                         IsClose(Vector3d(R * j), Rounding(64, impulse_scale(pair))));
    }
}

} // namespace rigor::testing
