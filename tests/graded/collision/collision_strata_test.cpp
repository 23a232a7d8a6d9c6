// SPDX-License-Identifier: MIT
// A4: short levers, contacts whose K is small in one direction, negative restitutions as topic
// `contact` uses them, contacts without friction, and level sets far from the surface.
#include "formulas/collision.hpp"
#include "sliding_pair.hpp"
#include "support/in_words.hpp"
#include "support/seeds.hpp"

namespace collision_strata_test {

using namespace rigor;
using namespace rigor::testing;

namespace {

// A symmetric matrix with the eigenvalue `soft` along n, and 1 and 2 perpendicular to n.
Matrix3d soft_along(const Vector3d& n, double soft)
{
    const Vector3d t = n.unitOrthogonal(), b = n.cross(t);
    return soft * n * n.transpose() + t * t.transpose() + 2 * b * b.transpose();
}

// Restitutions that topic `contact` asks for, and those of collisions.
constexpr double restitutions[] = {-1, -0.99, -0.9, -0.5, -0.1, 0, 0.5, 1};

} // namespace

TEST_CASE("collision: the shortest lever softens a contact", "[A4.4][collision]")
{
    // K - δ/M is quadratic in the lever. All numbers are exact, and the mass is almost infinite.
    const Vector3d X(1, 2, 3), r(1, -0.5, 0.25);
    Matrix3d I_inv;
    I_inv << 3, 1, 0, 1, 2, 0.5, 0, 0.5, 4;
    const Matrix3d whole = impulse_matrix(0x1p-200, I_inv, X, X + r);
    for (int power = 1; power <= 40; ++power) {
        CAPTURE(power);
        const double s = std::ldexp(1, -power);
        REQUIRE_THAT(impulse_matrix(0x1p-200, I_inv, X, X + s * r),
                     IsClose(Matrix3d(s * s * whole), Rounding(16, s * s * whole.norm())));
    }
}

TEST_CASE("collision: an impulse with a short lever turns the body", "[A4.10][collision]")
{
    const Vector3d j(1, 2, -1), r(1, -0.5, 0.25);
    for (int power = 1; power <= 40; ++power) {
        CAPTURE(power);
        const double s = std::ldexp(1, -power);
        Body body;
        body.inverse_mass = 1;
        body.inverse_inertia = 2 * Matrix3d::Identity();
        body.position = {1, 2, 3};
        const Body after = apply_impulse(body, body.position + s * r, j);
        const Vector3d L = s * r.cross(j);
        REQUIRE_THAT(after.angular_momentum, IsClose(L, Rounding(16, L.norm())));
        REQUIRE_THAT(after.angular_velocity, IsClose(Vector3d(2 * L), Rounding(16, 2 * L.norm())));
    }
}

TEST_CASE("collision: a frictionless impulse reverses any normal velocity", "[A4.5][collision]")
{
    // n·(v + K j) = -ε v·n, however small nᵀ K n is and however nearly v is perpendicular to n
    for (Random random : seeds(5))
        for (int power = 0; power <= 40; ++power)
            for (const double restitution : restitutions) {
                const Vector3d n = Vector3d::Unit(power % 3), t = n.unitOrthogonal();
                const double soft = std::ldexp(1, -(power / 2)), v_n = -std::ldexp(1, -power);
                CAPTURE(soft, v_n, restitution);
                const Matrix3d K = soft_along(n, soft);
                const Vector3d v = v_n * n + random.uniform(0.5, 1) * t;
                const Vector3d j = frictionless_impulse(K, v, n, restitution);
                REQUIRE_THAT((v + K * j).dot(n),
                             IsClose(-restitution * v_n, Rounding(32, std::abs(v_n))));
                REQUIRE_THAT(tangential(j, n), IsClose(Vector3d(0, 0, 0), Rounding(32, j.norm())));
            }
}

TEST_CASE("collision: a sticking impulse stops any sliding", "[A4.6][collision]")
{
    // v + K j = -ε vₙ n, also where K is small along one direction, or is nearly diagonal
    for (Random random : seeds(5))
        for (int power = 1; power <= 32; ++power)
            for (const double restitution : restitutions) {
                CAPTURE(power, restitution);
                const Vector3d n = random.unit_vector(), v = random.vector();
                const Matrix3d soft = soft_along(Vector3d::Unit(power % 3), std::ldexp(1, -power)),
                               nearly = Vector3d(1, 2, 3).asDiagonal();
                Matrix3d coupling = Matrix3d::Ones();
                coupling.diagonal().setZero();
                for (const Matrix3d& K :
                     {soft, Matrix3d(nearly + std::ldexp(1, -power) * coupling)}) {
                    const Vector3d j = static_friction_impulse(K, v, n, restitution);
                    REQUIRE_THAT(Vector3d(v + K * j),
                                 IsClose(Vector3d(-restitution * v.dot(n) * n), Rounding(128, 4)));
                }
            }
}

TEST_CASE("collision: an impulse that pulls is outside of the widest cone", "[A4.7][collision]")
{
    for (int power = 1; power <= 44; ++power) {
        CAPTURE(power);
        const double mu = std::ldexp(1, power + 8), pull = std::ldexp(1, -power);
        CAPTURE(mu, pull);
        check_that(!inside_friction_cone({1, -pull, 0}, {0, 1, 0}, mu),
                   "the impulse (1, -pull, 0), which pulls, is outside, n = (0, 1, 0)");
        check_that(inside_friction_cone({1, pull, 0}, {0, 1, 0}, mu),
                   "the impulse (1, pull, 0) is inside, n = (0, 1, 0)");
    }
}

TEST_CASE("collision: the border of a wide cone is sharp", "[A4.7][collision]")
{
    for (int power = 1; power <= 44; ++power) {
        CAPTURE(power);
        const double mu = std::ldexp(1, power);
        CAPTURE(mu);
        check_that(!inside_friction_cone({mu * (1 + 0x1p-20), 1, 0}, {0, 1, 0}, mu),
                   "an impulse whose |j_T| is a little more than μ jₙ is outside");
        check_that(inside_friction_cone({mu * (1 - 0x1p-20), 1, 0}, {0, 1, 0}, mu),
                   "an impulse whose |j_T| is a little less than μ jₙ is inside");
    }
}

TEST_CASE("collision: the border of the friction cone from both sides", "[A4.7][collision]")
{
    // |j_T| is μ jₙ times 1 ± 2^-k; the tangential part is along an axis, or (3, 4) of length 5
    for (int power = 1; power <= 47; ++power)
        for (int axis = 0; axis < 3; ++axis)
            for (const double sign : {1.0, -1.0})
                for (const bool is_along_axis : {true, false}) {
                    CAPTURE(power, axis, sign, is_along_axis);
                    const double share = 1 + sign * std::ldexp(1, -power);
                    const Vector3d n = Vector3d::Unit(axis), t = Vector3d::Unit((axis + 1) % 3),
                                   b = Vector3d::Unit((axis + 2) % 3);
                    const Vector3d j_T = is_along_axis ? Vector3d(5 * t) : Vector3d(3 * t - 4 * b);
                    REQUIRE_THAT(inside_friction_cone(share * j_T + 4 * n, n, 1.25),
                                 IsExactly(sign < 0));
                    REQUIRE_THAT(inside_friction_cone(share * j_T - 4 * n, -n, 1.25),
                                 IsExactly(sign < 0));
                }
}

TEST_CASE("collision: bodies that move almost alike", "[A4.3][collision]")
{
    for (Random random : seeds(5))
        for (int power = 1; power <= 44; ++power) {
            CAPTURE(power);
            Body body1 = random.body(), body2 = body1;
            body2.velocity += std::ldexp(1, -power) * random.vector();
            REQUIRE_THAT(relative_velocity(body1, body2, random.vector()),
                         IsClose(Vector3d(body1.velocity - body2.velocity), Rounding(64, 4)));
        }
}

TEST_CASE("collision: a jammed contact pushes while its bodies separate", "[A4.8][collision]")
{
    // the sticking impulse for v = (2, 1, 0) and ε = 0 is (-2.4, 0.4, 2.2)
    const Vector3d j = sliding_friction_impulse(jamming_contact(), {2, 1, 0}, {0, 1, 0}, 0, 2.0);
    const Vector3d shortened = 0.8 * Vector3d(-2.4, 0, 2.2).normalized();
    REQUIRE_THAT(j, IsClose(Vector3d(shortened + 0.4 * up), Rounding(256, 4)));
}

TEST_CASE("collision: bodies that separate without friction are left alone", "[A4.9][collision]")
{
    for (Random random : seeds(10)) {
        const CollidingPair pair = colliding_pair(static_cast<unsigned>(random.bits() % 1000));
        const Vector3d j = collision_impulse(pair.K, -pair.v, pair.n, pair.restitution, 0);
        REQUIRE_THAT(j, IsExactly(Vector3d(0, 0, 0)));
    }
}

TEST_CASE("collision: high friction holds what slides fast", "[A4.9][collision]")
{
    // K = δ: the sticking impulse is (-s, 1, 0), inside of the cone for μ > s
    for (const double slide : {0.5, 2.0, 5.0, 50.0, 1e6}) {
        CAPTURE(slide);
        const Vector3d v(slide, -1, 0), n(0, 1, 0);
        const Matrix3d K = Matrix3d::Identity();
        REQUIRE_THAT(collision_impulse(K, v, n, 0, 1.01 * slide),
                     IsClose(Vector3d(-slide, 1, 0), Rounding(16)));
        REQUIRE_THAT(collision_impulse(K, v, n, 0, 0.99 * slide),
                     IsClose(Vector3d(-0.99 * slide, 1, 0), Rounding(64)));
    }
}

TEST_CASE("collision: a sliding impulse with any restitution", "[A4.8][collision]")
{
    for (unsigned seed : seeds(50))
        for (const double restitution : restitutions) {
            CollidingPair pair = colliding_pair(seed);
            pair.restitution = restitution;
            CAPTURE(restitution);
            if (slides_easily(pair, 0.3))
                check_extreme_sliding(
                    pair, 0.3, sliding_friction_impulse(pair.K, pair.v, pair.n, restitution, 0.3));
        }
}

TEST_CASE("collision: with any restitution friction acts in the cone", "[A4.9][collision]")
{
    // This includes ε = -1, which removes nothing of the approach: K couples normal and tangential
    // motion, so the impulse that stops the sliding may push.
    int sticking = 0;
    for (unsigned seed : seeds(100))
        for (const double restitution : restitutions)
            for (const double friction : {0.1, 0.5, 2.0, 8.0}) {
                CollidingPair pair = colliding_pair(seed);
                pair.restitution = restitution;
                CAPTURE(restitution, friction);
                const Vector3d j = collision_impulse(pair.K, pair.v, pair.n, restitution, friction);
                const double inside = margin(pair, friction); // above 0: sticks
                if (inside > 1e-3) {
                    const Vector3d after = -restitution * pair.v.dot(pair.n) * pair.n;
                    sticking += restitution == -1;
                    REQUIRE_THAT(Vector3d(pair.v + pair.K * j),
                                 IsClose(after, Rounding(64, impulse_scale(pair) * pair.K.norm())));
                } else if (inside < -1e-3 && slides_easily(pair, friction)) {
                    check_extreme_sliding(pair, friction, j);
                }
            }
    check_that(sticking > 0, "one contact at least sticks with a restitution of -1");
}

TEST_CASE("collision: sliding just beside the speed that counts as none", "[A4.8][collision]")
{
    // |v - vₙ n| ≤ 1e-12 |v| is the frictionless impulse; here |v| is 1
    const double friction = 0.25, sliding = 1.5 / (4 - 2 * friction), straight = 1.5 / 4;
    for (int power = 1; power <= 40; ++power)
        for (const double sign : {1.0, -1.0}) {
            CAPTURE(power, sign);
            const Vector3d v(1e-12 * (1 + sign * std::ldexp(1, -power)), -1, 0);
            const Vector3d expected =
                sign > 0 ? Vector3d(-friction * sliding, sliding, 0) : Vector3d(0, straight, 0);
            REQUIRE_THAT(sliding_friction_impulse(jamming_contact(), v, {0, 1, 0}, 0.5, friction),
                         IsClose(expected, Rounding(64, 1)));
        }
}

TEST_CASE("collision: the normal of a level set far from its surface", "[A4.2][collision]")
{
    // φ = far + 0.6 x + 0.8 z, with slopes rounded to multiples of 2^-20, so that φ is exact
    const double x = std::floor(0.6 * 0x1p20) / 0x1p20, z = std::floor(0.8 * 0x1p20) / 0x1p20;
    LevelSet grid = {{0, 0, 0}, 1, {2, 2, 2}, {}};
    for (const double far : {0x1p10, 0x1p20, 0x1p30, -0x1p30}) {
        CAPTURE(far);
        grid.distances.clear();
        for (int i = 0; i < 8; ++i)
            grid.distances.push_back(far + (i & 1) * x + (i >> 2) * z);
        REQUIRE_THAT(level_set_normal(grid, {0.5, 0.25, 0.75}),
                     IsClose(Vector3d(x, 0, z).normalized(), Rounding(64, std::abs(far))));
    }
}

TEST_CASE("collision: the last digits of the distances have a direction", "[A4.2][collision]")
{
    // far + s (x + 2 y + 2 z), whose slope 3 s goes down to a few of the last digits of `far`. In
    // the middle of the cell all sums are exact.
    for (const double far : {1.0, -1.0, 0x1p40, -0x1p-40})
        for (int power = 0; power <= 50; ++power) {
            CAPTURE(far, power);
            LevelSet grid = {{0, 0, 0}, 1, {2, 2, 2}, {}};
            for (int i = 0; i < 8; ++i)
                grid.distances.push_back(
                    far * (1 + std::ldexp((i & 1) + (i & 2) + (i >> 2) * 2, -power)));
            const Vector3d n = (far > 0 ? 1 : -1) * Vector3d(1, 2, 2) / 3;
            REQUIRE_THAT(level_set_normal(grid, {0.5, 0.5, 0.5}), IsClose(n, Rounding(64, 1)));
        }
}

} // namespace collision_strata_test
