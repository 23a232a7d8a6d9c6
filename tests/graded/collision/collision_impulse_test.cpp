// SPDX-License-Identifier: MIT
// A4.9: the impulse of a collision, which is zero or makes the contact stick or slide.
#include "formulas/collision.hpp"
#include "sliding_pair.hpp"
#include "support/close.hpp"
#include "support/in_words.hpp"
#include "support/random.hpp"
#include "support/seeds.hpp"

#include <cmath>

namespace rigor::testing {

namespace {

// Class B: whether the body slides on flips between critical · (1 - d) and critical · (1 + d),
// where `critical` is its critical friction.
void check_flip(const Matrix3d& K, const Skid& skid, double critical)
{
    const double d = 1e-9;
    const auto slides_on = [&](double friction) {
        const Vector3d j = collision_impulse(K, skid.v(), skid.n, skid.restitution, friction);
        return (skid.v() + K * j).dot(skid.T) > 1e-3 * d;
    };
    check_that(slides_on(critical * (1 - d)),
               "the body slides on just below its critical friction");
    check_that(!slides_on(critical * (1 + d)), "the body sticks just above its critical friction");
}

// Checks that a rod whose tip skids slides below its critical friction and sticks above it. In the
// plane of n and T, K is ((a, b), (b, c))/M, with the determinant 4/M²:
//
//     slides:  jₙ = M kick / (a - μ b)           j_T = μ jₙ, against T
//     sticks:  jₙ = M (c kick + b along) / 4     j_T = M (a along + b kick) / 4, against T
//
// At the critical friction both impulses are equal and the sticking one pushes, so a - μ b > 0.
void check_rod(double t, const Skid& skid, double share)
{
    const Matrix3d K = skidding_rod(t, skid);
    const double s2 = 1 + t * t, a = 4 - 3 * t * t / s2, b = 3 * t / s2, c = 4 - 3 / s2;
    const double push = skid.mass * (c * skid.kick() + b * skid.along) / 4;
    const double rub = skid.mass * (a * skid.along + b * skid.kick()) / 4;
    const auto impulse = [&](double friction) {
        return collision_impulse(K, skid.v(), skid.n, skid.restitution, friction);
    };
    const double critical = rub / push, low = share * critical;
    CAPTURE(t, critical);
    const double left = a - low * b, j_n = skid.mass * skid.kick() / left;
    // the division by a - μ b magnifies rounding by (a + μ b)/(a - μ b)
    const double size = 2 * skid.mass * skid.v().norm() / left;
    REQUIRE_THAT(impulse(low), IsClose(Vector3d(j_n * (skid.n - low * skid.T)),
                                       Rounding(64, (1 + low) * size * (a + low * b) / left)));
    for (const double high : {1.05 * critical, 4 * critical, 1e6})
        REQUIRE_THAT(impulse(high), IsClose(Vector3d(push * skid.n - rub * skid.T),
                                            Rounding(64, 4 * 2 * skid.mass * skid.v().norm())));
    check_flip(K, skid, critical);
}

} // namespace

TEST_CASE("collision: bodies that separate are left alone", "[A4.9][collision]")
{
    REQUIRE_THAT(collision_impulse(sphere_on_floor(), Vector3d(3, 2, 0), up, 0.5, 0.3),
                 IsExactly(Vector3d(0, 0, 0)));
    // bodies that slide along each other, neither approaching nor separating, get no impulse either
    REQUIRE_THAT(collision_impulse(sphere_on_floor(), Vector3d(3, 0, 0), up, 0.5, 0.3),
                 IsExactly(Vector3d(0, 0, 0)));
    for (unsigned seed : seeds(50)) {
        const CollidingPair pair = colliding_pair(seed);
        REQUIRE_THAT(collision_impulse(pair.K, -pair.v, pair.n, pair.restitution, 0.3),
                     IsExactly(Vector3d(0, 0, 0)));
    }
}

TEST_CASE("collision: what skids slides below its critical friction and sticks above it",
          "[A4.9][collision]")
{
    // a sphere, whose critical friction is 2/7
    const Matrix3d K = sphere_on_floor();
    const Vector3d v(3, -2, 0);
    REQUIRE_THAT(collision_impulse(K, v, up, 0.5, 0.1),
                 IsClose(Vector3d(-0.3, 3, 0), Rounding(16)));
    for (double friction : {0.3, 1.0, 1e6})
        REQUIRE_THAT(collision_impulse(K, v, up, 0.5, friction),
                     IsClose(Vector3d(-6.0 / 7, 3, 0), Rounding(16)));
    check_flip(K, {1, 3, 2}, 2.0 / 7);

    // with other speeds the limit is 2/7 of the sliding speed over the change of the normal speed
    for (Random random : seeds(5)) {
        const Skid skid = random_skid(random);
        const auto impulse = [&, K = skidding_sphere(skid)](double friction) {
            return collision_impulse(K, skid.v(), skid.n, skid.restitution, friction);
        };
        const double limit = 2.0 / 7 * skid.along / skid.kick(), j_n = skid.mass * skid.kick();
        const auto with_friction = [&](double friction) {
            return IsClose(Vector3d(j_n * (skid.n - friction * skid.T)), skid.rounding());
        };
        const double low = random.uniform(0, 0.9) * limit;
        REQUIRE_THAT(impulse(low), with_friction(low));
        for (double high : {1.05 * limit, 4 * limit, 1e6})
            REQUIRE_THAT(impulse(high), with_friction(limit));
        check_flip(skidding_sphere(skid), skid, limit);
    }

    // A rod at 45° has the critical friction 1, where jₙ = |j_T| = 3. Where it slides, jₙ depends
    // on μ: at half of that friction jₙ is 3/(5/2 - 1/2 · 3/2).
    const Skid rod = {1, 3, 2};
    REQUIRE_THAT(collision_impulse(skidding_rod(1, rod), rod.v(), up, 0.5, 0.5),
                 IsClose(Vector3d(-6.0 / 7, 12.0 / 7, 0), Rounding(64)));
    check_rod(1, rod, 0.5);
    for (Random random : seeds(5)) {
        const double t = random.uniform(0.5, 2), share = random.uniform(0, 0.9);
        check_rod(t, random_skid(random), share);
    }
}

TEST_CASE("collision: inside the cone it sticks and outside it slides", "[A4.9][collision]")
{
    int stuck = 0, slid = 0;
    for (unsigned seed : seeds(300)) {
        const CollidingPair pair = colliding_pair(seed);
        const auto& [body1, body2, x, n, K, v, restitution, size, condition] = pair;
        const double friction = Random(seed + 1000).uniform(0, 1);
        const double inside = margin(pair, friction);
        // rounding may decide a case that is too close to a border
        if (std::abs(inside) < 1e-6 || !slides_easily(pair, friction)) continue;

        const Vector3d j = collision_impulse(K, v, n, restitution, friction);

        if (inside > 0) {
            ++stuck;
            const Vector3d after = -restitution * v.dot(n) * n;
            REQUIRE_THAT(Vector3d(v + K * j),
                         IsClose(after, Rounding(16, size * K.norm() * condition)));
        } else {
            ++slid;
            check_sliding(pair, friction, j);
        }
    }
    check_that(stuck > 10 && slid > 10, "more than ten cases of either kind could be judged");
}

TEST_CASE("collision: an impulse of a collision pushes and stays in the cone", "[A4.9][collision]")
{
    for (unsigned seed : seeds(100)) {
        const CollidingPair pair = colliding_pair(seed);
        const Vector3d& n = pair.n;
        for (double friction : {0.0, 0.3, 3.0, 1e6}) {
            CAPTURE(friction);
            const Vector3d j = collision_impulse(pair.K, pair.v, n, pair.restitution, friction);
            const double scale = 64 * (1 + friction) * j.norm() + impulse_scale(pair);
            check_at_least(j.dot(n), 0, "jₙ", scale);
            check_at_most(tangential(j, n).norm(), friction * j.dot(n), "|j_T|, by μ jₙ", scale);
        }
    }
}

TEST_CASE("collision: turn the scene 17 degrees about the normal and the result turns with it",
          "[A4.9][collision]")
{
    int cases = 0;
    for (unsigned seed : seeds(100)) {
        const CollidingPair pair = colliding_pair(seed);
        const auto& [body1, body2, x, n, K, v, restitution, size, condition] = pair;
        const double friction = 0.4;
        if (std::abs(margin(pair, friction)) < 1e-6 || !slides_easily(pair, friction)) continue;
        ++cases;
        const Matrix3d R = turn(17, n);
        const Vector3d j = collision_impulse(K, v, n, restitution, friction);
        REQUIRE_THAT(collision_impulse(R * K * R.transpose(), R * v, n, restitution, friction),
                     IsClose(Vector3d(R * j), Rounding(64, impulse_scale(pair))));
    }
    check_that(cases > 20, "more than 20 random cases could be judged");
}

TEST_CASE("collision: a sphere never gains energy from the floor", "[A4.9][collision]")
{
    const Matrix3d K = sphere_on_floor();
    for (Random random : seeds(100)) {
        const Vector3d v = random.vector();
        const double restitution = random.uniform(0, 1), friction = random.uniform(0, 1);
        const Vector3d j = collision_impulse(K, v, up, restitution, friction);
        check_at_most(j.dot(v + K * j / 2), 0, "the work of the impulse", 16);
    }
}

TEST_CASE("collision: a jammed contact outside the cone is not blown apart", "[A4.9][collision]")
{
    const Vector3d j = collision_impulse(jamming_contact(), Vector3d(2, -2, 0), up, 0.5, 2.25);
    REQUIRE_THAT(j, IsClose(Vector3d(-3.6, 2, 2.7), Rounding(64)));
}

TEST_CASE("collision: between two static bodies there is no impulse", "[A4.9][collision]")
{
    for (double friction : {0.0, 0.3})
        REQUIRE_THAT(collision_impulse(Matrix3d::Zero(), Vector3d(1, -1, 0), up, 0.5, friction),
                     IsExactly(Vector3d(0, 0, 0)));
}

TEST_CASE("collision: without restitution an impulse may add energy", "[A4.9][collision]")
{
    // jₙ = 2/(4 - 1.75 · 2) = 4, and j·v + ½ j·K j = -22 + 49.5 > 0 (Kane 1984)
    Matrix3d K;
    K << 3, 2, 2, 2, 4, 1, 2, 1, 2;
    REQUIRE_THAT(collision_impulse(K, {2, -2, 0}, {0, 1, 0}, 0, 1.75),
                 IsClose(Vector3d(-7, 4, 0), Rounding(64, 8)));
}

} // namespace rigor::testing
