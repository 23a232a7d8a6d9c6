// SPDX-License-Identifier: MIT
// A4: inputs whose parts have very different sizes: levers much longer than a body, a K that is
// very small or very large in one direction, bodies that hardly approach, heavy bodies that turn
// easily. Also long lists of contacts that are equally deep.
#include "formulas/collision.hpp"
#include "sliding_pair.hpp"
#include "support/close.hpp"
#include "support/random.hpp"
#include "support/seeds.hpp"

#include <cmath>

namespace collision_extremes_test {

using namespace rigor;
using namespace rigor::testing;

namespace {

constexpr double restitutions[] = {-0.5, 0, 0.5, 1};

// The permutation that moves the axes x, y, z on by `turns` places: by 1, x becomes y, y becomes z
// and z becomes x.
Matrix3d cyclic(int turns)
{
    Matrix3d P = Matrix3d::Zero();
    for (int i = 0; i < 3; ++i)
        P((i + turns) % 3, i) = 1;
    return P;
}

} // namespace

TEST_CASE("collision: a lever along the normal makes a contact soft across it alone",
          "[A4.5][collision]")
{
    // nᵀ K n = 2, however large K is perpendicular to n
    for (int axis = 0; axis < 3; ++axis)
        for (int power = 0; power <= 200; power += 4)
            for (const double restitution : restitutions) {
                CAPTURE(axis, power, restitution);
                const Vector3d n = Vector3d::Unit(axis);
                Matrix3d K = std::ldexp(1, power) * Matrix3d::Identity();
                K(axis, axis) = 2;
                const Vector3d v(-1, -2, -4);
                const Vector3d j = frictionless_impulse(K, v, n, restitution);
                REQUIRE_THAT(j,
                             IsClose(Vector3d(-(1 + restitution) * v[axis] / 2 * n), Rounding(8)));
            }
}

TEST_CASE("collision: a contact that is soft in one direction sticks", "[A4.6][collision]")
{
    // K is diagonal, so each component of v is stopped by its own impulse
    for (int axis = 0; axis < 3; ++axis)
        for (int power = -46; power <= 46; ++power)
            for (const double restitution : restitutions) {
                CAPTURE(axis, power, restitution);
                Vector3d k(1, 2, 4);
                k[axis] *= std::ldexp(1, power);
                const Vector3d v(1, -2, 4), n(0, 1, 0);
                const Vector3d wanted = -v - restitution * v.y() * n;
                const Vector3d j = static_friction_impulse(k.asDiagonal(), v, n, restitution);
                for (int i = 0; i < 3; ++i) {
                    CAPTURE(i);
                    REQUIRE_THAT(
                        j[i], IsClose(wanted[i] / k[i], Rounding(16, std::abs(wanted[i] / k[i]))));
                }
            }
}

TEST_CASE("collision: bodies that hardly approach stick where K couples the directions",
          "[A4.9][collision]")
{
    // However small the approach is, the sticking impulse stops the sliding. Since n is along an
    // axis, v·n has no rounding error. The sticking impulse for v = (2, 0, 0) is (-2, 2, 0).
    Matrix3d K;
    K << 3, 2, 0, 2, 2, 0, 0, 0, 2;
    for (int turns = 0; turns < 3; ++turns)
        for (const int power : {10, 20, 30, 40, 50, 60, 100, 300, 1000}) {
            CAPTURE(turns, power);
            const Matrix3d P = cyclic(turns);
            const Vector3d v(2, -std::ldexp(1, -power), 0), n(0, 1, 0);
            const Vector3d j = collision_impulse(P * K * P.transpose(), P * v, P * n, 0.5, 2);
            REQUIRE_THAT(Vector3d(P.transpose() * j),
                         IsClose(Vector3d(-2, 2, 0), Order(32 * std::ldexp(1, -power) + 0x1p-45)));
        }
}

TEST_CASE("collision: a jam whose sticking impulse hardly pushes", "[A4.8][collision]")
{
    // jₙ is 2^-power, and |j_T| is 1.25. If the friction is large enough, j needs no shortening.
    const Matrix3d K = jamming_contact();
    for (int turns = 0; turns < 3; ++turns)
        for (int power = 1; power <= 36; ++power)
            for (const double friction : {0x1p4, 0x1p20, 0x1p40}) {
                CAPTURE(turns, power, friction);
                const Matrix3d P = cyclic(turns);
                const double j_n = std::ldexp(1, -power), j_T = std::hypot(1, 0.75);
                const Vector3d stick(-1, j_n, 0.75), v = -K * stick; // with ε = 0
                const Vector3d T = tangential(v, up).normalized();
                if (up.dot(K * (up - friction * T)) > 0) continue;
                const double share = std::min(1.0, friction * j_n / j_T);
                const Vector3d expected(-share, j_n, 0.75 * share);
                const Vector3d j =
                    sliding_friction_impulse(P * K * P.transpose(), P * v, P * up, 0, friction);
                // an error of j_n is magnified by j_T/j_n where the impulse is shortened
                const double scale = 30 * (share < 1 ? share / j_n : 1);
                REQUIRE_THAT(Vector3d(P.transpose() * j), IsClose(expected, Rounding(64, scale)));
            }
}

TEST_CASE("collision: a heavy body turns as easily as its inertia lets it", "[A4.10][collision]")
{
    // 1/M goes from 2^-60 to 2^60 [1/kg], while I⁻¹ stays 2 [1/(kg m²)]
    const Vector3d j(1, 2, -1), r(1, -0.5, 0.25);
    for (int power = -60; power <= 60; ++power)
        for (const double speed : {0.0, 1.0}) {
            CAPTURE(power, speed);
            Body body;
            body.inverse_mass = std::ldexp(1, power);
            body.inverse_inertia = 2 * Matrix3d::Identity();
            body.velocity = speed * Vector3d(3, 1, 2);
            const Body after = apply_impulse(body, body.position + r, j);
            const Vector3d V = body.velocity + body.inverse_mass * j, L = r.cross(j);
            REQUIRE_THAT(after.velocity, IsClose(V, Rounding(8, V.norm())));
            REQUIRE_THAT(after.angular_momentum, IsClose(L, Rounding(16)));
            REQUIRE_THAT(after.angular_velocity, IsClose(Vector3d(2 * L), Rounding(16)));
        }
}

TEST_CASE("collision: of many equally deep contacts the first counts", "[A4.11][collision]")
{
    for (const int count : {2, 5, 17, 40, 200, 1500})
        for (Random random : seeds(6)) {
            CAPTURE(count);
            std::vector<ContactPoint> contacts(static_cast<std::size_t>(count));
            std::optional<int> expected;
            for (int i = 0; i < count; ++i) {
                ContactPoint& contact = contacts[static_cast<std::size_t>(i)];
                contact.depth = 0.25 * (random_index(random, 4) - 2);
                contact.normal = random.unit_vector();
                const double speed = random.uniform(0.1, 1);
                contact.relative_velocity =
                    (random_index(random, 3) == 0 ? speed : -speed) * contact.normal;
                if (contact.relative_velocity.dot(contact.normal) >= 0) continue;
                if (!expected ||
                    contact.depth > contacts[static_cast<std::size_t>(*expected)].depth)
                    expected = i;
            }
            REQUIRE_THAT(deepest_approaching_point(contacts), IsExactly(expected));
        }
}

} // namespace collision_extremes_test
