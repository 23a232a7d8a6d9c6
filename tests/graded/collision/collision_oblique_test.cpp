// SPDX-License-Identifier: MIT
// A4: normals, torques and gradients along simple directions beside the axes, such as diagonals,
// and zeros of either sign.
#include "formulas/collision.hpp"
#include "sliding_pair.hpp"
#include "support/in_words.hpp"
#include "support/seeds.hpp"

namespace collision_oblique_test {

using namespace rigor;
using namespace rigor::testing;

namespace {

// All vectors with the components -2 to 2, without the zero vector.
std::vector<Vector3d> small_vectors()
{
    std::vector<Vector3d> result;
    for (int i = 0; i < 125; ++i)
        result.emplace_back(i % 5 - 2, i / 5 % 5 - 2, i / 25 - 2);
    std::erase(result, Vector3d(0, 0, 0));
    return result;
}

} // namespace

TEST_CASE("collision: a gradient of any simple direction", "[A4.2][collision]")
{
    for (const Vector3d& gradient : small_vectors()) {
        CAPTURE(gradient);
        LevelSet grid = {{0, 0, 0}, 1, {2, 2, 2}, {}};
        for (int i = 0; i < 8; ++i)
            grid.distances.push_back(gradient.dot(Vector3d(i & 1, i >> 1 & 1, i >> 2)));
        REQUIRE_THAT(level_set_normal(grid, {0.25, 0.5, 0.75}),
                     IsClose(gradient.normalized(), Rounding(16)));
    }
}

TEST_CASE("collision: slow sliding counts or not, along any normal", "[A4.8][collision]")
{
    // |v - vₙ n| ≤ 1e-12 |v| is the frictionless impulse. The rounding of v is 1e-4 of the
    // slip, and so is that of the direction of the friction.
    const double friction = 0.25;
    for (const Vector3d& direction : small_vectors())
        for (const double slip : {0.6e-12, 0.9e-12, 1.1e-12, 1.6e-12}) {
            CAPTURE(direction, slip);
            const Vector3d n = direction.normalized(), T = n.unitOrthogonal();
            const Vector3d v = slip * T - n;
            const Vector3d j =
                sliding_friction_impulse(4 * Matrix3d::Identity(), v, n, 0.5, friction);
            const double j_n = j.dot(n), j_T = tangential(j, n).norm();
            REQUIRE_THAT(j_n, IsClose(1.5 / 4, Order(1e-3)));
            const bool slides = slip > 1e-12;
            check_that(std::abs(j_T - (slides ? friction * j_n : 0)) < 1e-3 * friction * j_n,
                       slides ? "the friction is μ jₙ, since the bodies slide"
                              : "no friction, since the bodies slide too slowly");
        }
}

TEST_CASE("collision: a torque about which a body does not turn changes L", "[A4.10][collision]")
{
    for (int axis = 0; axis < 3; ++axis)
        for (const double inverse : {0., 12.})
            for (Random random : seeds(5)) {
                CAPTURE(axis, inverse);
                Body body = random.body();
                body.inverse_inertia =
                    inverse * (Matrix3d::Identity() -
                               Vector3d::Unit(axis) * Vector3d::Unit(axis).transpose());
                const Vector3d arm = 2 * Vector3d::Unit((axis + 1) % 3),
                               j = 3 * Vector3d::Unit((axis + 2) % 3);
                body.position = {1, -2, 4}; // the lever arm is exact
                const Body after = apply_impulse(body, body.position + arm, j);
                REQUIRE_THAT(after.angular_momentum,
                             IsClose(Vector3d(body.angular_momentum + 6 * Vector3d::Unit(axis)),
                                     Rounding(8, 10)));
                REQUIRE_THAT(after.angular_velocity,
                             IsClose(body.angular_velocity, Rounding(8, 4)));
            }
}

TEST_CASE("collision: a zero depth of either sign is the same depth", "[A4.11][collision]")
{
    for (const double first : {0.0, -0.0})
        for (const double second : {0.0, -0.0}) {
            CAPTURE(std::signbit(first), std::signbit(second));
            const std::vector<ContactPoint> contacts = {{{0, 0, 0}, up, first, {1, -1, 0}},
                                                        {{1, 0, 0}, up, second, {1, -1, 0}}};
            REQUIRE_THAT(deepest_approaching_point(contacts), IsExactly(std::optional<int>(0)));
        }
}

TEST_CASE("collision: what hardly approaches counts along a diagonal", "[A4.11][collision]")
{
    // The two components of n that are not zero have the same size, so v·n = ∓d/√2 is exact.
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {1., -1.})
            for (int power = 1; power <= 50; ++power) {
                CAPTURE(axis, side, power);
                const double d = std::ldexp(1, -power);
                const Vector3d a = Vector3d::Unit(axis), b = side * Vector3d::Unit((axis + 1) % 3);
                const Vector3d n = (a - b) * std::sqrt(0.5);
                const std::vector<ContactPoint> contacts = {{{0, 0, 0}, n, 2, a + (1 - d) * b},
                                                            {{1, 0, 0}, n, 1, a + (1 + d) * b}};
                REQUIRE_THAT(deepest_approaching_point(contacts), IsExactly(std::optional<int>(1)));
            }
}

} // namespace collision_oblique_test
