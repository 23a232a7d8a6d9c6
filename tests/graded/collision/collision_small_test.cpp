// SPDX-License-Identifier: MIT
// A4: numbers that are small or large beside others of the same call. Restitution, friction and a
// component of a normal count however small they are, and there is no smallest speed.
#include "formulas/collision.hpp"
#include "sliding_pair.hpp"
#include "support/in_words.hpp"
#include "support/seeds.hpp"

#include <limits>

using namespace rigor;
using namespace rigor::testing;

namespace {

// 2^k for a random k from `low` to `high`.
double power_of_two(Random& random, int low, int high)
{
    const auto n = static_cast<std::uint64_t>(high - low + 1);
    return std::ldexp(1, low + static_cast<int>(random.bits() % n));
}

// A unit vector near an axis, with two components from 2^-40 to 1/2.
Vector3d near_an_axis(Random& random)
{
    Vector3d n(power_of_two(random, -40, -1), power_of_two(random, -40, -1), 1);
    if (random.bits() % 2 == 0) n = -n;
    const int axis = random_index(random, 3);
    return Vector3d(n[axis], n[(axis + 1) % 3], n[(axis + 2) % 3]).normalized();
}

// A contact with a normal near an axis and with a small restitution. The bodies approach each other
// and slide; K has the eigenvalues 1, 2 and 3.
CollidingPair small_pair(Random& random)
{
    CollidingPair pair;
    const Matrix3d R = random.rotation();
    pair.K = R * Vector3d(1, 2, 3).asDiagonal() * R.transpose();
    pair.n = near_an_axis(random);
    const Vector3d t = tangential(random.unit_vector(), pair.n).normalized();
    pair.v = -random.uniform(0.2, 0.5) * pair.n + random.uniform(0.6, 1) * t;
    pair.restitution = power_of_two(random, -40, 0);
    pair.size = pair.v.norm();
    pair.condition = 3;
    return pair;
}

} // namespace

TEST_CASE("collision: a small restitution bounces, along any normal", "[A4.5][collision]")
{
    for (Random random : seeds(100)) {
        const auto [body1, body2, x, n, K, v, restitution, size, condition] = small_pair(random);
        CAPTURE(n, restitution);
        const Vector3d j = frictionless_impulse(K, v, n, restitution);
        REQUIRE_THAT(tangential(j, n), IsClose(Vector3d(Vector3d::Zero()), Rounding(64, size)));
        REQUIRE_THAT((v + K * j).dot(n), IsClose(-restitution * v.dot(n), Rounding(64, 6 * size)));
    }
}

TEST_CASE("collision: a small restitution bounces where the contact sticks", "[A4.6][collision]")
{
    for (Random random : seeds(100)) {
        const auto [body1, body2, x, n, K, v, restitution, size, condition] = small_pair(random);
        CAPTURE(n, restitution);
        const Vector3d j = static_friction_impulse(K, v, n, restitution);
        const Vector3d after = -restitution * v.dot(n) * n;
        REQUIRE_THAT(Vector3d(v + K * j), IsClose(after, Rounding(64, 6 * size)));
    }
}

TEST_CASE("collision: the border of a narrow or a wide friction cone", "[A4.7][collision]")
{
    constexpr double eps = std::numeric_limits<double>::epsilon();
    for (Random random : seeds(200)) {
        const Vector3d n = near_an_axis(random);
        const Vector3d t = tangential(random.unit_vector(), n).normalized();
        const double mu = power_of_two(random, -40, 40),
                     size = random.uniform(1, 2) * power_of_two(random, -40, 40);
        // farther from the border than the rounding error of the smaller part, jₙ n or j_T
        const double d = 1e-9 + 256 * eps * std::max(mu, 1 / mu);
        CAPTURE(n, mu, size);
        const auto is_inside = [&](double share) {
            return inside_friction_cone(size * (n + share * mu * t), n, mu);
        };
        REQUIRE_THAT(is_inside(1 - d), IsExactly(true));
        REQUIRE_THAT(is_inside(1 + d), IsExactly(false));
    }
}

TEST_CASE("collision: a small friction brakes, along any normal", "[A4.8][collision]")
{
    for (Random random : seeds(100)) {
        const CollidingPair pair = small_pair(random);
        const double mu = power_of_two(random, -40, -3);
        CAPTURE(pair.n, pair.restitution, mu);
        check_sliding(pair, mu,
                      sliding_friction_impulse(pair.K, pair.v, pair.n, pair.restitution, mu));
    }
}

TEST_CASE("collision: a jammed contact is the same at any speed and in any direction",
          "[A4.8][collision]")
{
    const Vector3d v(2, -2, 0); // the sticking impulse is (-4, 2, 3), shortened to |j_T| = 2 μ
    for (Random random : seeds(60)) {
        const Matrix3d R = random.rotation();
        const double mu = random.uniform(2.05, 3),
                     speed = random.uniform(1, 2) * power_of_two(random, -40, 40);
        CAPTURE(speed, mu);
        const Vector3d expected =
            Vector3d(0, 2, 0) + std::min(1.0, 2 * mu / 5) * Vector3d(-4, 0, 3);
        const Vector3d j = sliding_friction_impulse(R * jamming_contact() * R.transpose(),
                                                    speed * (R * v), R * up, 0.5, mu);
        constexpr double condition = 30; // above 18, the largest eigenvalue of K over the smallest
        REQUIRE_THAT(Vector3d(R.transpose() * j / speed),
                     IsClose(expected, Rounding(64, condition * expected.norm())));
    }
}

TEST_CASE("collision: a small friction lets a contact slide, a large one holds it",
          "[A4.9][collision]")
{
    int slid = 0, stuck = 0;
    for (Random random : seeds(150)) {
        const CollidingPair pair = small_pair(random);
        const auto& [body1, body2, x, n, K, v, restitution, size, condition] = pair;
        const double mu = power_of_two(random, -40, 40);
        CAPTURE(n, restitution, mu);
        const Vector3d j = collision_impulse(K, v, n, restitution, mu);
        if (mu < 1 / 8.0 && margin(pair, mu) < -1e-3) {
            check_sliding(pair, mu, j);
            ++slid;
        } else if (margin(pair, mu) > 1e-3) {
            const Vector3d after = -restitution * v.dot(n) * n;
            REQUIRE_THAT(Vector3d(v + K * j), IsClose(after, Rounding(64, 6 * size)));
            ++stuck;
        }
    }
    check_that(slid > 0 && stuck > 0, "cases of either kind could be judged");
}

namespace {

// Two point masses that slide almost along each other, so that even a large friction does not stop
// them: with K = 2 δ and v = t - a n, they stick from μ = 1/((1 + ε) a) on.
struct Grazing {
    Matrix3d K = 2 * Matrix3d::Identity();
    Vector3d n, t;
    double approach, restitution, border;
    explicit Grazing(Random& random)
    {
        n = random.unit_vector();
        t = tangential(random.unit_vector(), n).normalized();
        approach = power_of_two(random, -24, -1);
        restitution = random.uniform(0, 1);
        border = 1 / ((1 + restitution) * approach);
    }
    Vector3d v() const { return t - approach * n; }
    Vector3d sliding(double mu) const { return (1 + restitution) * approach / 2 * (n - mu * t); }
};

} // namespace

TEST_CASE("collision: a large friction that does not stop a grazing contact", "[A4.8][collision]")
{
    for (Random random : seeds(60)) {
        const Grazing contact(random);
        const double mu = random.uniform(0.1, 0.9) * contact.border;
        CAPTURE(contact.approach, mu);
        // the normal part of v has a rounding error of eps
        const Tolerance rounding = Rounding(64, 1 + mu);
        REQUIRE_THAT(
            sliding_friction_impulse(contact.K, contact.v(), contact.n, contact.restitution, mu),
            IsClose(contact.sliding(mu), rounding));
    }
}

TEST_CASE("collision: a grazing contact slides below a large friction and sticks above it",
          "[A4.9][collision]")
{
    for (Random random : seeds(60)) {
        const Grazing contact(random);
        for (const double share : {0.2, 0.9, 1.1, 20.0}) {
            const double mu = share * contact.border;
            CAPTURE(contact.approach, mu);
            const Vector3d expected = contact.sliding(std::min(mu, contact.border));
            REQUIRE_THAT(
                collision_impulse(contact.K, contact.v(), contact.n, contact.restitution, mu),
                IsClose(expected, Rounding(64, 1 + std::min(mu, contact.border))));
        }
    }
}

TEST_CASE("collision: bodies that neither approach nor separate are left alone",
          "[A4.9][collision]")
{
    for (const Vector3d& v : {Vector3d(1, 0, 0), Vector3d(-1, 0, 0), Vector3d(0, 0, 1),
                              Vector3d(0, 0, -1), Vector3d(3, 0, -2)})
        for (const double friction : {0.0, 0.5, 1e6}) {
            CAPTURE(v, friction);
            REQUIRE_THAT(collision_impulse(jamming_contact(), v, up, 0.5, friction),
                         IsExactly(Vector3d(Vector3d::Zero())));
        }
}

TEST_CASE("collision: bodies that separate slowly are left alone", "[A4.9][collision]")
{
    for (Random random : seeds(100)) {
        const CollidingPair pair = small_pair(random);
        // 2^-40 is still a thousand times the rounding error of v·n
        const double speed = power_of_two(random, -40, 3);
        const Vector3d v = speed * pair.n + tangential(pair.v, pair.n);
        CAPTURE(speed);
        REQUIRE_THAT(collision_impulse(pair.K, v, pair.n, pair.restitution, random.uniform(0, 1)),
                     IsExactly(Vector3d(Vector3d::Zero())));
    }
}

TEST_CASE("collision: a heavy body at rest gets its velocities", "[A4.10][collision]")
{
    for (Random random : seeds(40)) {
        const double lightness = power_of_two(random, -60, 0);
        Body body; // at rest at the origin
        body.inverse_mass = lightness;
        body.inverse_inertia = lightness * random.positive_definite();
        const Vector3d x = random.vector(), j = random.vector();
        CAPTURE(lightness);
        const Body after = apply_impulse(body, x, j), expected = kicked(body, x, j);
        REQUIRE_THAT(Vector3d(after.velocity / lightness),
                     IsClose(Vector3d(expected.velocity / lightness), Rounding(16, j.norm())));
        REQUIRE_THAT(Vector3d(after.angular_velocity / lightness),
                     IsClose(Vector3d(expected.angular_velocity / lightness),
                             Rounding(64, 10 * x.norm() * j.norm())));
    }
}

TEST_CASE("collision: slow bodies have a relative velocity", "[A4.3][collision]")
{
    for (Random random : seeds(40)) {
        const double speed = power_of_two(random, -60, 0);
        Body body1, body2; // static, both at the origin
        body1.velocity = speed * random.vector();
        body2.velocity = speed * random.vector();
        CAPTURE(speed);
        REQUIRE_THAT(relative_velocity(body1, body2, random.vector()),
                     IsClose(Vector3d(body1.velocity - body2.velocity), Rounding(16, speed)));
    }
}

TEST_CASE("collision: the deepest of any number of contacts", "[A4.11][collision]")
{
    for (const int count : {1, 2, 9, 33, 129, 1000}) {
        Random random(first_seed() + static_cast<unsigned>(count));
        std::vector<ContactPoint> contacts(static_cast<std::size_t>(count));
        for (ContactPoint& contact : contacts) {
            contact.depth = random.uniform(0, 1);
            contact.relative_velocity = -contact.normal;
        }
        for (const int deepest : {0, count / 2, count - 1}) {
            CAPTURE(count, deepest);
            std::vector<ContactPoint> changed = contacts;
            changed[static_cast<std::size_t>(deepest)].depth = 2;
            REQUIRE_THAT(deepest_approaching_point(changed), IsExactly(std::optional(deepest)));
        }
    }
}

TEST_CASE("collision: normals along an axis and close to one", "[A4.2][collision]")
{
    for (Random random : seeds(60)) {
        Vector3d g = near_an_axis(random);
        if (random.bits() % 4 == 0)
            g = (random.bits() % 2 ? 1 : -1) * Vector3d::Unit(random.bits() % 3);
        CAPTURE(g);
        LevelSet grid{Vector3d::Zero(), 0.5, {3, 4, 3}, {}}; // φ = g·x, also between the nodes
        for (int k = 0; k < grid.size[2]; ++k)
            for (int j = 0; j < grid.size[1]; ++j)
                for (int i = 0; i < grid.size[0]; ++i)
                    grid.distances.push_back(0.5 * g.dot(Vector3d(i, j, k)));
        const Vector3d p = Vector3d(0.5, 0.75, 0.5) + 0.4 * random.vector();
        REQUIRE_THAT(level_set_normal(grid, p), IsClose(g, Rounding(64, 1)));
    }
}
