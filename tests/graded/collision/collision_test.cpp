// SPDX-License-Identifier: MIT
// A4.3 to A4.5: relative velocity, impulse matrix and frictionless impulse.
#include "colliding_pair.hpp"
#include "formulas/collision.hpp"
#include "support/close.hpp"
#include "support/random.hpp"
#include "support/seeds.hpp"

#include <cmath>
#include <numbers>

namespace rigor::testing {

namespace {

// A body with the position X and the velocities V and ω. Its mass has no effect on velocities.
Body moving(const Vector3d& X, const Vector3d& V, const Vector3d& omega)
{
    Body body;
    body.inverse_mass = 1;
    body.inverse_inertia = Matrix3d::Identity();
    body.position = X;
    body.velocity = V;
    body.angular_velocity = omega;
    body.angular_momentum = omega;
    return body;
}

// A thin rod of mass 1 and length 1 that leans at 45°, with its lower tip at the origin. No impulse
// can turn it about its own axis d: I⁻¹ = 12 (δ - d dᵀ).
struct Rod {
    Vector3d d = Vector3d(1, 1, 0) / std::sqrt(2.0);
    Vector3d X = d / 2;
    Matrix3d I_inverse = 12 * (Matrix3d::Identity() - d * d.transpose());
};

// Upper bound of the terms of the velocity at x [m/s].
double speed(const Body& body, const Vector3d& x)
{
    return body.velocity.norm() + body.angular_velocity.norm() * (x.norm() + body.position.norm());
}

} // namespace

TEST_CASE("collision: the relative velocity is that of body 1 less that of body 2",
          "[A4.3][collision]")
{
    // The point is the top of a wheel of radius 2 m that turns at 3 rad/s about z. The cart moves
    // at 1 m/s along x.
    const Body wheel = moving({0, 1, 0}, {0, 0, 0}, {0, 0, 3});
    const Body cart = moving({5, 5, 5}, {1, 0, 0}, {0, 0, 0});
    const Vector3d top(0, 3, 0);

    REQUIRE_THAT(relative_velocity(wheel, cart, top), IsClose(Vector3d(-7, 0, 0), Rounding(8)));
    REQUIRE_THAT(relative_velocity(cart, wheel, top), IsClose(Vector3d(7, 0, 0), Rounding(8)));
}

TEST_CASE("collision: a rolling wheel does not slide on the ground", "[A4.3][collision]")
{
    const Body wheel = moving({3, 0.5, 0}, {2, 0, 0}, {0, 0, -4});
    const Body ground; // static, at rest
    REQUIRE_THAT(relative_velocity(wheel, ground, Vector3d(3, 0, 0)),
                 IsClose(Vector3d(0, 0, 0), Rounding(8, 2)));
    REQUIRE_THAT(relative_velocity(wheel, ground, Vector3d(3, 1, 0)),
                 IsClose(Vector3d(4, 0, 0), Rounding(8)));
}

TEST_CASE("collision: two parts of one moving body have no relative velocity", "[A4.3][collision]")
{
    for (Random random : seeds(100)) {
        const Body body1 = random.body();
        Body body2 = random.body(); // another mass and place; it is carried along by body 1
        body2.velocity = velocity_at(body1, body2.position);
        body2.angular_velocity = body1.angular_velocity;
        const Vector3d x = random.vector();

        const double scale = speed(body1, x) + speed(body2, x);
        REQUIRE_THAT(relative_velocity(body1, body2, x),
                     IsClose(Vector3d(0, 0, 0), Rounding(16, scale)));
    }
}

TEST_CASE("collision: the relative velocity of any two bodies", "[A4.3][collision]")
{
    for (Random random : seeds(100)) {
        const Body body1 = random.body(), body2 = random.body();
        const Vector3d x = random.vector();

        const double scale = speed(body1, x) + speed(body2, x);
        REQUIRE_THAT(relative_velocity(body1, body2, x),
                     IsClose(velocity_at(body1, x) - velocity_at(body2, x), Rounding(16, scale)));
    }
}

TEST_CASE("collision: the impulse matrix of a leaning rod at its tip", "[A4.4][collision]")
{
    // x - X = -½ d, so K = δ + 3 (δ - d dᵀ) = 4 δ - 3 d dᵀ
    const Rod rod;
    Matrix3d expected;
    expected << 2.5, -1.5, 0, //
        -1.5, 2.5, 0,         //
        0, 0, 4;
    REQUIRE_THAT(impulse_matrix(1, rod.I_inverse, rod.X, Vector3d::Zero()),
                 IsClose(expected, Rounding(16)));
}

TEST_CASE("collision: the impulse matrix of a sphere on the floor", "[A4.4][collision]")
{
    // I = 2/5 M r² for any size and mass, so K is 7/2 along the floor and 1 across it, divided by M
    for (double r : {1e-3, 0.1, 50.0})
        for (double M : {1e-3, 1.0, 1e4}) {
            CAPTURE(r, M);
            const Matrix3d I_inverse = Matrix3d::Identity() / (0.4 * M * r * r);
            const Matrix3d K = impulse_matrix(1 / M, I_inverse, Vector3d(0, r, 0), {0, 0, 0});
            REQUIRE_THAT(K, IsClose(Matrix3d(sphere_on_floor() / M), Rounding(16)));
        }
}

TEST_CASE("collision: at the center of mass an impulse only pushes", "[A4.4][collision]")
{
    Random random(1);
    const Vector3d X = random.vector();
    REQUIRE_THAT(impulse_matrix(0.25, random.positive_definite(), X, X),
                 IsClose(Matrix3d(0.25 * Matrix3d::Identity()), Rounding(8)));
}

TEST_CASE("collision: the impulse matrix of a static body is zero", "[A4.4][collision]")
{
    REQUIRE_THAT(impulse_matrix(0, Matrix3d::Zero(), Vector3d(1, 2, 3), Vector3d(3, 2, 2)),
                 IsExactly(Matrix3d(Matrix3d::Zero())));
    INFO("whatever its inertia");
    for (Random random : seeds(5))
        REQUIRE_THAT(
            impulse_matrix(0, random.positive_definite(), random.vector(), random.vector()),
            IsExactly(Matrix3d(Matrix3d::Zero())));
}

TEST_CASE("collision: K maps an impulse to the change of velocity at its point",
          "[A4.4][collision]")
{
    for (Random random : seeds(100)) {
        const Body body = random.body();
        const Vector3d x = random.vector(), j = random.vector();

        const Matrix3d K =
            impulse_matrix(body.inverse_mass, body.inverse_inertia, body.position, x);

        const Vector3d change = velocity_at(kicked(body, x, j), x) - velocity_at(body, x);
        const double r = x.norm() + body.position.norm();
        const double scale =
            speed(body, x) + body.inverse_mass + r * r * body.inverse_inertia.norm();
        REQUIRE_THAT(Vector3d(K * j), IsClose(change, Rounding(32, scale)));
    }
}

TEST_CASE("collision: K is symmetric and at least the inverse mass", "[A4.4][collision]")
{
    for (Random random : seeds(100)) {
        const Body body = random.body();
        const Vector3d x = random.vector(), j = random.unit_vector();

        const Matrix3d K =
            impulse_matrix(body.inverse_mass, body.inverse_inertia, body.position, x);

        REQUIRE_THAT(Matrix3d(K.transpose()), IsClose(K, Rounding(32)));
        check_at_least(j.dot(K * j), body.inverse_mass, "jᵀ K j for a unit j, by 1/M",
                       8 * K.norm());
    }
}

TEST_CASE("collision: a rod tip on a frictionless floor", "[A4.5][collision]")
{
    // a rod of mass 1 and length 1 at 45° falls at 1 m/s: nᵀ K n = 2.5, jₙ = 1.5/2.5
    Matrix3d K;
    K << 2.5, -1.5, 0, -1.5, 2.5, 0, 0, 0, 4;
    REQUIRE_THAT(frictionless_impulse(K, Vector3d(0, -1, 0), Vector3d(0, 1, 0), 0.5),
                 IsClose(Vector3d(0, 0.6, 0), Rounding(8)));
}

TEST_CASE("collision: Newton's cradle passes its speed on one ball at a time", "[A4.5][collision]")
{
    // three balls of mass 2 on the x-axis; body 1 is the right one of a pair, so n = eₓ
    const Matrix3d K = (0.5 + 0.5) * Matrix3d::Identity();
    double V[3] = {1, 0, 0};
    for (int i = 0; i < 2; ++i) {
        const Vector3d v(V[i + 1] - V[i], 0, 0);
        const Vector3d j = frictionless_impulse(K, v, Vector3d::UnitX(), 1);
        V[i + 1] += j.x() / 2;
        V[i] -= j.x() / 2;
    }
    REQUIRE_THAT(Vector3d(V[0], V[1], V[2]), IsClose(Vector3d(0, 0, 1), Rounding(8)));
}

TEST_CASE("collision: without friction the normal velocity becomes -ε times itself",
          "[A4.5][collision]")
{
    for (unsigned seed : seeds(100)) {
        const auto [body1, body2, x, n, K, v, restitution, size, condition] = colliding_pair(seed);

        const Vector3d j = frictionless_impulse(K, v, n, restitution);

        const Vector3d after = v + K * j;
        const double scale = size * K.norm() * condition;
        REQUIRE_THAT(after.dot(n), IsClose(-restitution * v.dot(n), Rounding(16, scale)));
        // the terms of j have the size of v, of which vₙ may be a small part
        const double terms = (1 + restitution) * v.norm() / n.dot(K * n);
        REQUIRE_THAT(j, IsClose(Vector3d(j.dot(n) * n), Rounding(16, terms * condition)));
    }
}

TEST_CASE("collision: a frictionless impulse takes the energy that restitution says",
          "[A4.5][collision]")
{
    for (unsigned seed : seeds(100)) {
        const auto [body1, body2, x, n, K, v, restitution, size, condition] = colliding_pair(seed);

        const Vector3d j = frictionless_impulse(K, v, n, restitution);

        // ΔE = -½ (1 - ε²) vₙ² / (nᵀ K n) if both bodies are free or one of them is at rest. It is
        // the work of j at the mean of the velocities before and after.
        const double work = j.dot(v + K * j / 2);
        const double v_n = v.dot(n);
        const double expected = -(1 - restitution * restitution) * v_n * v_n / n.dot(K * n) / 2;
        const double scale = size * v.norm() * condition * condition;
        REQUIRE_THAT(work, IsClose(expected, Rounding(16, scale)));
        if (body2.is_static()) continue; // if it moves, it does work on body 1
        const double before = energy(body1) + energy(body2);
        const double after = energy(kicked(body1, x, j)) + energy(kicked(body2, x, -j));
        check_at_most(after, before, "the kinetic energy after, by that before",
                      16 * (before + scale));
    }
}

TEST_CASE("collision: a frictionless impulse turns with the scene", "[A4.5][collision]")
{
    for (unsigned seed : seeds(50)) {
        const auto [body1, body2, x, n, K, v, restitution, size, condition] = colliding_pair(seed);
        const Matrix3d R = Random(seed + 1000).rotation();

        const Vector3d j = frictionless_impulse(K, v, n, restitution);
        const Vector3d turned =
            frictionless_impulse(R * K * R.transpose(), R * v, R * n, restitution);
        REQUIRE_THAT(turned, IsClose(Vector3d(R * j), Rounding(32, size * condition)));
    }
}

TEST_CASE("collision: between two static bodies there is no frictionless impulse",
          "[A4.5][collision]")
{
    const Vector3d j =
        frictionless_impulse(Matrix3d::Zero(), Vector3d(1, -1, 0), Vector3d(0, 1, 0), 0.5);
    REQUIRE_THAT(j, IsExactly(Vector3d(0, 0, 0)));
}

} // namespace rigor::testing
