// SPDX-License-Identifier: MIT
// A4.6 and A4.7: static friction and the friction cone.
#include "colliding_pair.hpp"
#include "formulas/collision.hpp"
#include "support/close.hpp"
#include "support/in_words.hpp"
#include "support/random.hpp"
#include "support/seeds.hpp"

#include <cmath>
#include <numbers>

namespace rigor::testing::collision_friction_test {

namespace {

const Vector3d up(0, 1, 0);
constexpr double degree = std::numbers::pi / 180;

// A unit vector perpendicular to n.
Vector3d across(const Vector3d& n, double angle)
{
    const Vector3d a = n.unitOrthogonal();
    return std::cos(angle) * a + std::sin(angle) * n.cross(a);
}

} // namespace

TEST_CASE("collision: an oblique sphere that sticks", "[A4.6][collision]")
{
    // a sphere of mass 1 and r = 0.1, v = (3, -2), ε = 0.5: j_T = -3 · 2/7, jₙ = 3
    const Vector3d j = static_friction_impulse(sphere_on_floor(), Vector3d(3, -2, 0), up, 0.5);
    REQUIRE_THAT(j, IsClose(Vector3d(-6.0 / 7, 3, 0), Rounding(16)));

    // V = v + j, ω = (r × j)/I about z, with r = (0, -0.1, 0) and I = 2/5 · 0.01
    REQUIRE_THAT(3 + j.x(), IsClose(2.142857142857143, Rounding(16)));
    REQUIRE_THAT(0.1 * j.x() / 0.004, IsClose(-21.42857142857143, Rounding(16)));
}

TEST_CASE("collision: a sphere that sticks rolls on with five sevenths of its speed",
          "[A4.6][collision]")
{
    const Vector3d v(0.6, -1, -0.8);
    const Vector3d j = static_friction_impulse(sphere_on_floor(), v, up, 0);
    REQUIRE_THAT(Vector3d(v + j), IsClose(Vector3d(0.6 * 5 / 7, 0, -0.8 * 5 / 7), Rounding(16, 2)));
}

TEST_CASE("collision: a rocking block keeps seven tenths of its spin", "[A4.6][collision]")
{
    // A block 1 m wide and 2 m high, of mass 1, turns about its left edge at -1 rad/s until its
    // right edge hits the floor. The impact is perfectly plastic, and the block then turns about
    // its right edge.
    const double w = 1, h = 2, I = (w * w + h * h) / 12;
    const Vector3d r(w / 2, -h / 2, 0), omega(0, 0, -1);
    const Vector3d V = omega.cross(Vector3d(w / 2, h / 2, 0));
    Matrix3d K; // δ + r*ᵀ I⁻¹ r* for a motion in the plane
    K << 1 + r.y() * r.y() / I, -r.x() * r.y() / I, 0, //
        -r.x() * r.y() / I, 1 + r.x() * r.x() / I, 0,  //
        0, 0, 1;

    const Vector3d j = static_friction_impulse(K, V + omega.cross(r), up, 0);

    const Vector3d after = omega + r.cross(j) / I;
    REQUIRE_THAT(after.z() / omega.z(), IsClose(0.7, Rounding(32)));
}

TEST_CASE("collision: static friction stops the sliding and turns the normal velocity round",
          "[A4.6][collision]")
{
    for (unsigned seed : seeds(100)) {
        const CollidingPair pair = colliding_pair(seed);
        const auto& [body1, body2, x, n, K, v, restitution, size, condition] = pair;

        const Vector3d j = static_friction_impulse(K, v, n, restitution);

        const Vector3d after = -restitution * v.dot(n) * n;
        const double scale = size * K.norm() * condition;
        REQUIRE_THAT(Vector3d(v + K * j), IsClose(after, Rounding(16, scale)));
    }
}

TEST_CASE("collision: no impulse leaves less energy than plastic sticking", "[A4.6][collision]")
{
    for (unsigned seed : seeds(50)) {
        const CollidingPair pair = colliding_pair(seed);
        const Matrix3d& K = pair.K;
        const auto work = [&](const Vector3d& j) { return j.dot(pair.v + K * j / 2); };

        const Vector3d j = static_friction_impulse(K, pair.v, pair.n, 0);

        Random random(seed);
        const double scale = pair.size * pair.v.norm() * pair.condition * pair.condition;
        check_at_most(work(j), 0, "the work of a plastic sticking impulse", 16 * scale);
        for (int i = 0; i < 20; ++i) {
            const Vector3d other = j + 0.3 * pair.size * random.vector();
            check_at_most(work(j), work(other), "its work, by that of another impulse", 16 * scale);
        }
    }
}

TEST_CASE("collision: a bouncing rod that sticks may gain energy", "[A4.6][collision]")
{
    // A rod of mass 1 and length 1 at 45° falls at 1 m/s and spins. The velocity of its tip is
    // (1.5, -2.5) m/s, and ε = 1.
    Matrix3d K;
    K << 2.5, -1.5, 0, //
        -1.5, 2.5, 0,  //
        0, 0, 4;
    const Vector3d v(1.5, -2.5, 0);

    const Vector3d j = static_friction_impulse(K, v, up, 1);

    // a flaw of the model behind the formula: 1.25 J become 1.953125 J
    REQUIRE_THAT(j, IsClose(Vector3d(0.9375, 2.5625, 0), Rounding(64)));
    REQUIRE_THAT(1.25 + j.dot(v + K * j / 2), IsClose(1.953125, Rounding(64, 8)));
}

TEST_CASE("collision: static friction on long levers", "[A4.6][collision]")
{
    for (Random random : seeds(50)) {
        // 1/M is 1, and the lever adds up to 1e4. The test chooses j and computes the v that needs
        // j.
        const double lever = std::pow(10, random.uniform(0, 4));
        const Matrix3d R = random.rotation();
        const Matrix3d K = R * Vector3d(1, lever, 1 + lever).asDiagonal() * R.transpose();
        const Vector3d n = random.unit_vector(), j = random.vector();
        const double restitution = random.uniform(0, 1);
        const Vector3d change = K * j;
        const double v_n = -change.dot(n) / (1 + restitution);
        const Vector3d v = -change - restitution * v_n * n;

        // A solution may use an inverse matrix, whose error at worst grows with the square of the
        // condition number.
        const double condition = 1 + lever;
        REQUIRE_THAT(static_friction_impulse((K + K.transpose()) / 2, v, n, restitution),
                     IsClose(j, Rounding(16, condition * condition)));
    }
}

TEST_CASE("collision: a sticking impulse turns with the scene", "[A4.6][collision]")
{
    for (unsigned seed : seeds(50)) {
        const CollidingPair pair = colliding_pair(seed);
        const Matrix3d R = Random(seed + 1000).rotation();

        const Vector3d j = static_friction_impulse(pair.K, pair.v, pair.n, pair.restitution);
        const Vector3d turned = static_friction_impulse(R * pair.K * R.transpose(), R * pair.v,
                                                        R * pair.n, pair.restitution);
        const double scale = pair.size * pair.condition * pair.condition;
        REQUIRE_THAT(turned, IsClose(Vector3d(R * j), Rounding(32, scale)));
    }
}

TEST_CASE("collision: between two static bodies there is no sticking impulse", "[A4.6][collision]")
{
    const Vector3d j = static_friction_impulse(Matrix3d::Zero(), Vector3d(1, -1, 0), up, 0.5);
    REQUIRE_THAT(j, IsExactly(Vector3d(0, 0, 0)));
}

TEST_CASE("collision: the border of the friction cone is inside", "[A4.7][collision]")
{
    // |j_T| = 5, jₙ = 10
    const Vector3d j(3, 10, 4);
    REQUIRE_THAT(inside_friction_cone(j, up, 0.5), IsExactly(true));
    REQUIRE_THAT(inside_friction_cone(j, up, 0.51), IsExactly(true));
    REQUIRE_THAT(inside_friction_cone(j, up, 0.49), IsExactly(false));
}

TEST_CASE("collision: a normal impulse needs no friction and none is always enough",
          "[A4.7][collision]")
{
    REQUIRE_THAT(inside_friction_cone(Vector3d(0, 2, 0), up, 0), IsExactly(true));
    REQUIRE_THAT(inside_friction_cone(Vector3d(0, 0, 0), up, 0), IsExactly(true));
    REQUIRE_THAT(inside_friction_cone(Vector3d(0, 0, 0), up, 1), IsExactly(true));
    REQUIRE_THAT(inside_friction_cone(Vector3d(1e-3, 2, 0), up, 0), IsExactly(false));
    REQUIRE_THAT(inside_friction_cone(Vector3d(1, 0, 0), up, 1e6), IsExactly(false));
}

TEST_CASE("collision: no impulse is inside, whatever the signs of its zeros", "[A4.7][collision]")
{
    for (int signs = 0; signs < 64; ++signs) {
        const auto sign = [&](int bit) { return (signs >> bit & 1) != 0 ? -1.0 : 1.0; };
        const Vector3d j(sign(0) * 0, sign(1) * 0, sign(2) * 0);
        const Vector3d n = Vector3d(2 * sign(3), 3 * sign(4), 6 * sign(5)) / 7;
        CAPTURE(j, n);
        REQUIRE_THAT(inside_friction_cone(j, n, 0.5), IsExactly(true));
    }
}

TEST_CASE("collision: a pulling impulse is outside the friction cone", "[A4.7][collision]")
{
    REQUIRE_THAT(inside_friction_cone(Vector3d(0, -1, 0), up, 0.5), IsExactly(false));
    REQUIRE_THAT(inside_friction_cone(Vector3d(0.1, -1, 0), up, 0.5), IsExactly(false));
    REQUIRE_THAT(inside_friction_cone(Vector3d(0, 1, 0), Vector3d(0, -1, 0), 1e6),
                 IsExactly(false));
}

TEST_CASE("collision: friction is a cone and not a pyramid", "[A4.7][collision]")
{
    for (Random random : seeds(50)) {
        const Vector3d n = random.unit_vector();
        const double mu = random.uniform(0.05, 2), j_n = random.mass();
        for (int angle = 0; angle < 360; angle += 17) { // all around the normal
            CAPTURE(angle);
            const Vector3d T = across(n, angle * degree);
            check_that(inside_friction_cone(j_n * n + 0.99 * mu * j_n * T, n, mu),
                       "an impulse with |j_T| = 0.99 μ jₙ is inside, in each direction");
            check_that(!inside_friction_cone(j_n * n + 1.01 * mu * j_n * T, n, mu),
                       "an impulse with |j_T| = 1.01 μ jₙ is outside, in each direction");
        }
    }
}

TEST_CASE("collision: the oblique sphere sticks from a friction of 2/7 on", "[A4.7][collision]")
{
    const Vector3d j(-6.0 / 7, 3, 0); // the impulse that stops the sliding
    const double d = 1e-12;           // class B: the outcome flips within this bracket
    REQUIRE_THAT(inside_friction_cone(j, up, 2.0 / 7 * (1 + d)), IsExactly(true));
    REQUIRE_THAT(inside_friction_cone(j, up, 2.0 / 7 * (1 - d)), IsExactly(false));
}

TEST_CASE("collision: a block rests on an incline up to the angle of friction", "[A4.7][collision]")
{
    for (double theta : {5.0, 30.0, 60.0}) {
        CAPTURE(theta);
        const double mu = std::tan(theta * degree);
        // The force that holds a block of weight 1 on an incline points straight up, whatever the
        // normal is.
        const auto rests = [&](double angle) {
            const Vector3d n(std::sin(angle * degree), std::cos(angle * degree), 0);
            return inside_friction_cone(up, n, mu);
        };
        check_that(rests(theta - 0.01), "a block rests on an incline of θ − 0.01°, if μ = tan θ");
        check_that(!rests(theta + 0.01), "a block slides on an incline of θ + 0.01°, if μ = tan θ");
    }
}

} // namespace rigor::testing::collision_friction_test
