// SPDX-License-Identifier: MIT
// A4: points next to a node, weak gradients, heavy bodies, narrow friction cones, contacts on the
// brink of jamming, bodies that separate or slide slowly, depths that hardly differ.
#include "formulas/collision.hpp"
#include "sliding_pair.hpp"
#include "support/close.hpp"
#include "support/in_words.hpp"
#include "support/random.hpp"
#include "support/seeds.hpp"

namespace rigor::testing {

namespace {

// A grid of 3 nodes along each axis, one apart, with the value phi(x) at each.
template <class Phi> LevelSet three_cubed(Phi phi)
{
    LevelSet grid{Vector3d::Zero(), 1, {3, 3, 3}, {}};
    for (int k = 0; k < 3; ++k)
        for (int j = 0; j < 3; ++j)
            for (int i = 0; i < 3; ++i)
                grid.distances.push_back(phi(Vector3d(i, j, k)));
    return grid;
}

// 10 to each power from `from` down to `to`.
std::vector<double> powers(int from, int to)
{
    std::vector<double> result;
    for (int power = from; power >= to; --power)
        result.push_back(std::pow(10.0, power));
    return result;
}

} // namespace

TEST_CASE("collision: next to a node the distance has its slope", "[A4.1][collision]")
{
    const LevelSet ridge = three_cubed([](const Vector3d& x) { return 1 - std::abs(x.x() - 1); });
    for (const double off : powers(-1, -15))
        for (const double side : {1.0, -1.0}) {
            CAPTURE(off, side);
            const double x = 1 + side * off;
            REQUIRE_THAT(sample_level_set(ridge, {x, 0.5, 1}),
                         IsClose(1 - std::abs(x - 1), Rounding(8, 1)));
        }
}

TEST_CASE("collision: a weak gradient has a direction", "[A4.2][collision]")
{
    for (Random random : seeds(5)) {
        const Vector3d n = random.unit_vector(), p = Vector3d::Ones() + 0.9 * random.vector();
        for (const double slope : powers(0, -140)) {
            CAPTURE(slope);
            const LevelSet grid = three_cubed([&](const Vector3d& x) { return slope * n.dot(x); });
            REQUIRE_THAT(level_set_normal(grid, p), IsClose(n, Rounding(64, 4)));
        }
    }
}

TEST_CASE("collision: heavy bodies get large frictionless impulses", "[A4.5][collision]")
{
    for (const double size : powers(0, -140)) {
        CAPTURE(size);
        REQUIRE_THAT(frictionless_impulse(size * jamming_contact(), {1, -2, 0}, up, 0.5),
                     IsClose(Vector3d(0, 0.75 / size, 0), Rounding(32)));
    }
}

TEST_CASE("collision: heavy bodies get large sticking impulses", "[A4.6][collision]")
{
    for (const double size : powers(0, -90)) { // an inverse by cofactors needs the third power
        CAPTURE(size);
        REQUIRE_THAT(static_friction_impulse(size * jamming_contact(), {2, -2, 0}, up, 0.5),
                     IsClose(Vector3d(Vector3d(-4, 2, 3) / size), Rounding(1 << 10)));
    }
}

TEST_CASE("collision: narrow friction cones have a border", "[A4.7][collision]")
{
    for (Random random : seeds(30)) {
        const Vector3d n = random.unit_vector();
        const Vector3d t = tangential(random.unit_vector(), n).normalized();
        for (const double friction : powers(0, -8)) {
            CAPTURE(friction);
            // rounding moves the edge by some eps/μ, less than 1e-7
            const double off = 1e-6, size = random.mass();
            check_that(inside_friction_cone(size * (n + (1 - off) * friction * t), n, friction),
                       "an impulse just within the border is inside");
            check_that(!inside_friction_cone(size * (n + (1 + off) * friction * t), n, friction),
                       "an impulse just beyond the border is outside");
        }
    }
}

TEST_CASE("collision: without friction the cone is a line that only pushes", "[A4.7][collision]")
{
    check_that(inside_friction_cone(up, up, 0), "an impulse along the normal is inside");
    for (const double off : powers(0, -150)) {
        CAPTURE(off);
        check_that(!inside_friction_cone({off, 1, 0}, up, 0),
                   "without friction an impulse (off, 1, 0) is outside, n = (0, 1, 0)");
        check_that(!inside_friction_cone({0, -off, 0}, up, 0),
                   "an impulse (0, -off, 0) that pulls is outside");
        check_that(inside_friction_cone({0, off, 0}, up, 0),
                   "an impulse (0, off, 0) that pushes is inside");
    }
}

TEST_CASE("collision: the sliding impulse is the formula for bodies that separate too",
          "[A4.8][collision]")
{
    for (unsigned seed : seeds(50)) {
        CollidingPair pair = colliding_pair(seed);
        pair.v = -pair.v;
        if (!slides_easily(pair, 0.3)) continue;
        const auto& [body1, body2, x, n, K, v, restitution, size, condition] = pair;
        const Vector3d edge = n - 0.3 * tangential(v, n).normalized();
        const Vector3d expected = -(1 + restitution) * v.dot(n) / n.dot(K * edge) * edge;
        REQUIRE_THAT(sliding_friction_impulse(K, v, n, restitution, 0.3),
                     IsClose(expected, Rounding(64, impulse_scale(pair))));
    }
}

TEST_CASE("collision: a contact slides up to the friction at which it jams", "[A4.8][collision]")
{
    // nᵀ K (n - μ T) = 4 - 2 μ; rounding of its terms, 4 eps, is magnified by the division
    for (const double off : powers(-1, -10)) {
        CAPTURE(off);
        const double below = 2 - off, above = 2 + off, j_n = 1.5 * 2 / (4 - 2 * below);
        const Vector3d slides =
            sliding_friction_impulse(jamming_contact(), {2, -2, 0}, up, 0.5, below);
        REQUIRE_THAT(slides, IsClose(Vector3d(-below * j_n, j_n, 0),
                                     Rounding(64, 3 * j_n * 4 / (4 - 2 * below))));
        const Vector3d jams =
            sliding_friction_impulse(jamming_contact(), {2, -2, 0}, up, 0.5, above);
        const double share = above * 2 / 5; // the sticking impulse is (-4, 2, 3), its |j_T| is 5
        REQUIRE_THAT(jams, IsClose(Vector3d(-4 * share, 2, 3 * share), Rounding(1 << 10, 5)));
    }
}

TEST_CASE("collision: little friction is not none", "[A4.8][collision]")
{
    for (const double friction : powers(-1, -11)) {
        CAPTURE(friction);
        const double j_n = 1.5 * 2 / (4 - 2 * friction);
        REQUIRE_THAT(sliding_friction_impulse(jamming_contact(), {2, -2, 0}, up, 0.5, friction),
                     IsClose(Vector3d(-friction * j_n, j_n, 0), Rounding(64, j_n)));
    }
}

TEST_CASE("collision: bodies that neither approach nor separate do not collide",
          "[A4.9][collision]")
{
    for (const double x : {1.0, -1.0, 1e-9, -1e-9})
        for (const double z : {0.0, 0.5, -0.5}) {
            CAPTURE(x, z);
            REQUIRE_THAT(collision_impulse(jamming_contact(), {x, 0, z}, up, 0.5, 1000),
                         IsExactly(Vector3d(0, 0, 0)));
        }
}

TEST_CASE("collision: what slides slowly on nearly no friction slides", "[A4.9][collision]")
{
    // sticking would take 2/7 of the speed, a hundred times what this friction can give
    for (const double speed : powers(-1, -11)) {
        CAPTURE(speed);
        const double friction = speed * 2 / 7 / 1.5 / 100;
        REQUIRE_THAT(collision_impulse(sphere_on_floor(), {speed, -1, 0}, up, 0.5, friction),
                     IsClose(Vector3d(-friction * 1.5, 1.5, 0), Rounding(32, 1)));
    }
}

TEST_CASE("collision: a little deeper is deeper", "[A4.11][collision]")
{
    for (const double more : powers(-1, -15)) {
        CAPTURE(more);
        std::vector<ContactPoint> contacts(3, {{0, 0, 0}, up, 1, {0, -1, 0}});
        for (int deepest = 0; deepest < 3; ++deepest) {
            contacts[deepest].depth = 1 + more;
            REQUIRE_THAT(deepest_approaching_point(contacts),
                         IsExactly(std::optional<int>(deepest)));
            contacts[deepest].depth = 1;
        }
    }
}

} // namespace rigor::testing
