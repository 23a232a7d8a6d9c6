// SPDX-License-Identifier: MIT
// A4: inputs at the limits of the formulas: bodies that hardly approach or separate, point masses
// and rods, static bodies that move, depths below zero.
#include "formulas/collision.hpp"
#include "sliding_pair.hpp"
#include "support/close.hpp"
#include "support/random.hpp"
#include "support/seeds.hpp"

namespace rigor::testing {

namespace {

// A point mass, which no impulse can turn, or a rod along a random axis.
Body degenerate_body(Random& random, bool is_rod)
{
    Body body = random.body();
    const Vector3d d = random.unit_vector();
    const Matrix3d across = 3 * (Matrix3d::Identity() - d * d.transpose());
    body.inverse_inertia = is_rod ? across : Matrix3d::Zero();
    return body;
}

} // namespace

TEST_CASE("collision: a static body that moves counts with its velocity", "[A4.3][collision]")
{
    for (Random random : seeds(50)) {
        const Body belt = static_body(random), body = random.body();
        const Vector3d x = random.vector();
        const Vector3d v = velocity_at(belt, x) - velocity_at(body, x);
        REQUIRE_THAT(relative_velocity(belt, body, x), IsClose(v, Rounding(64, 4)));
        REQUIRE_THAT(relative_velocity(body, belt, x), IsClose(Vector3d(-v), Rounding(64, 4)));
    }
}

TEST_CASE("collision: far from the origin the relative velocity is the same", "[A4.3][collision]")
{
    // All differences x - X are exact, but a solution may multiply ω with x and X apart.
    for (Random random : seeds(5))
        for (int power = 0; power <= 28; power += 4) {
            const Vector3d far = std::ldexp(1, power) * Vector3d(1, -3, 2);
            Body bodies[] = {random.body(), static_body(random)};
            for (Body& body : bodies)
                body.position = far + Vector3d(random_index(random, 5), 1, -2);
            const Vector3d x = far + Vector3d(2, -1, 3);
            CAPTURE(far);
            const Vector3d v = velocity_at(bodies[0], x) - velocity_at(bodies[1], x);
            REQUIRE_THAT(relative_velocity(bodies[0], bodies[1], x),
                         IsClose(v, Rounding(64, 16 * (1 + x.norm()))));
        }
}

TEST_CASE("collision: each velocity of either body counts alone", "[A4.3][collision]")
{
    // which of V₁, ω₁, V₂ and ω₂ are not zero, and which body is static, or both
    for (Random random : seeds(3))
        for (int moves = 0; moves < 16; ++moves)
            for (int statics = 0; statics < 4; ++statics)
                for (const bool at_origin : {false, true}) {
                    Body bodies[] = {random.body(), random.body()};
                    for (int i = 0; i < 2; ++i) {
                        if (statics >> i & 1) bodies[i] = static_body(random);
                        if (!(moves >> 2 * i & 1)) bodies[i].velocity.setZero();
                        if (!(moves >> 2 * i & 2)) {
                            bodies[i].angular_velocity.setZero();
                            bodies[i].angular_momentum.setZero();
                        }
                        if (at_origin) bodies[i].position.setZero();
                    }
                    const auto& [body1, body2] = bodies;
                    const Vector3d x = random.vector();
                    const Vector3d v = velocity_at(body1, x) - velocity_at(body2, x);
                    CAPTURE(moves, statics, at_origin);
                    REQUIRE_THAT(relative_velocity(body1, body2, x),
                                 IsClose(v, Rounding(64, moves == 0 ? 0 : 4)));
                }
}

TEST_CASE("collision: the impulse matrix of rods and point masses", "[A4.4][collision]")
{
    for (Random random : seeds(50))
        for (const bool is_rod : {true, false}) {
            CAPTURE(is_rod);
            const Body body = degenerate_body(random, is_rod);
            const Vector3d x = random.vector();
            const Matrix3d K =
                impulse_matrix(body.inverse_mass, body.inverse_inertia, body.position, x);
            REQUIRE_THAT(K, IsClose(response_at(body, x), Rounding(64, body.inverse_mass + 36)));
        }
}

TEST_CASE("collision: a short lever counts as what it is", "[A4.4][collision]")
{
    for (Random random : seeds(20)) {
        const Vector3d X = Vector3d::Zero(), direction = random.unit_vector();
        for (const double r : {1e-2, 1e-4, 1e-6}) {
            CAPTURE(r);
            Body body = random.body();
            body.position = X;
            body.inverse_inertia *= 1 / (r * r); // a body as small as its lever
            const Vector3d x = r * direction;
            const Matrix3d K = impulse_matrix(body.inverse_mass, body.inverse_inertia, X, x);
            REQUIRE_THAT(K, IsClose(response_at(body, x), Rounding(64)));
        }
    }
}

TEST_CASE("collision: the frictionless impulse is the formula for bodies that separate too",
          "[A4.5][collision]")
{
    for (unsigned seed : seeds(50)) {
        const auto [body1, body2, x, n, K, v, restitution, size, condition] = colliding_pair(seed);
        const Vector3d expected = (1 + restitution) * v.dot(n) / n.dot(K * n) * n;
        REQUIRE_THAT(frictionless_impulse(K, -v, n, restitution),
                     IsClose(expected, Rounding(16, size * condition)));
    }
}

TEST_CASE("collision: the sticking impulse is the formula for bodies that separate too",
          "[A4.6][collision]")
{
    for (unsigned seed : seeds(50)) {
        const auto [body1, body2, x, n, K, v, restitution, size, condition] = colliding_pair(seed);
        const Vector3d j = static_friction_impulse(K, -v, n, restitution);
        REQUIRE_THAT(Vector3d(K * j), IsClose(Vector3d(v + restitution * v.dot(n) * n),
                                              Rounding(64, size * K.norm() * condition)));
    }
}

TEST_CASE("collision: bodies that hardly approach still collide", "[A4.9][collision]")
{
    // A sphere of mass 1 slides at 3 m/s and approaches at only `delta` [m/s]. The sticking impulse
    // is outside of the cone, so jₙ = (1 + ε) delta and |j_T| = μ jₙ.
    for (const double delta : {1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12}) {
        CAPTURE(delta);
        const double j_n = 1.5 * delta;
        const Vector3d j =
            collision_impulse(sphere_on_floor(), Vector3d(3, -delta, 0), up, 0.5, 0.2);
        REQUIRE_THAT(j, IsClose(Vector3d(-0.2 * j_n, j_n, 0), Rounding(32)));
        // a sphere that falls straight down sticks
        const Vector3d slow =
            collision_impulse(sphere_on_floor(), Vector3d(0, -delta, 0), up, 0.5, 0.2);
        REQUIRE_THAT(slow, IsClose(Vector3d(0, j_n, 0), Rounding(32)));
    }
}

TEST_CASE("collision: what slides slowly against its fall slides", "[A4.8][collision]")
{
    // jamming_contact() couples directions: nᵀ K n = 4 and nᵀ K (n - μ T) = 4 - 2 μ
    const double friction = 0.5, sliding = 1.5 * 2 / (4 - 2 * friction), straight = 1.5 * 2 / 4;
    for (const double share : {1e-3, 1e-6, 1e-9, 1e-11, 1.1e-12, 0.9e-12, 1e-14}) {
        CAPTURE(share);
        const Vector3d v = 2 * Vector3d(share, -1, 0);
        const Vector3d expected =
            share > 1e-12 ? Vector3d(-friction * sliding, sliding, 0) : Vector3d(0, straight, 0);
        REQUIRE_THAT(sliding_friction_impulse(jamming_contact(), v, up, 0.5, friction),
                     IsClose(expected, Rounding(64)));
    }
}

TEST_CASE("collision: an impulse moves rods and point masses", "[A4.10][collision]")
{
    for (Random random : seeds(50))
        for (const bool is_rod : {true, false}) {
            CAPTURE(is_rod);
            const Body body = degenerate_body(random, is_rod);
            const Vector3d x = random.vector(), j = random.vector();
            const Body after = apply_impulse(body, x, j), expected = kicked(body, x, j);
            REQUIRE_THAT(after, IsClose(expected, Rounding(64, 40)));
        }
}

TEST_CASE("collision: a static body that moves keeps its motion", "[A4.10][collision]")
{
    for (Random random : seeds(20)) {
        const Body belt = static_body(random);
        REQUIRE_THAT(apply_impulse(belt, random.vector(), random.vector()), IsExactly(belt));
    }
}

TEST_CASE("collision: contacts that do not touch yet have depths below zero", "[A4.11][collision]")
{
    for (Random random : seeds(50)) {
        std::vector<ContactPoint> contacts;
        int deepest = 0;
        for (int i = 0; i < 5; ++i) {
            const Vector3d n = random.unit_vector();
            contacts.push_back({random.vector(), n, random.uniform(-2, -1), -n});
            if (contacts[i].depth > contacts[deepest].depth) deepest = i;
        }
        REQUIRE_THAT(deepest_approaching_point(contacts), IsExactly(std::optional<int>(deepest)));
    }
}

TEST_CASE("collision: the deepest of a very long list of contacts", "[A4.11][collision]")
{
    const int n = 20000;
    for (const int deepest : {0, n / 2, n - 1}) {
        CAPTURE(deepest);
        std::vector<ContactPoint> contacts(n, {{0, 0, 0}, up, 1, {1, -1, 0}});
        contacts[deepest].depth = 2;
        REQUIRE_THAT(deepest_approaching_point(contacts), IsExactly(std::optional<int>(deepest)));
    }
}

TEST_CASE("collision: a contact that hardly approaches counts", "[A4.11][collision]")
{
    for (const double speed : {1e-3, 1e-6, 1e-9, 1e-12, 1e-15}) {
        CAPTURE(speed);
        const std::vector<ContactPoint> contacts = {{{0, 0, 0}, up, 1, {1, -1, 0}},
                                                    {{1, 0, 0}, up, 2, {1, -speed, 0}},
                                                    {{2, 0, 0}, up, 3, {1, speed, 0}}};
        REQUIRE_THAT(deepest_approaching_point(contacts), IsExactly(std::optional<int>(1)));
    }
}

} // namespace rigor::testing
