// SPDX-License-Identifier: MIT
// A4.5, A4.6, A4.8 and A4.9: contacts of every structure. Any entries of K beside its diagonal may
// be 0, entries on it equal, the normal along an axis or a diagonal, and components of the velocity
// 0 or equal.
#include "formulas/collision.hpp"
#include "sliding_pair.hpp"
#include "support/seeds.hpp"

namespace collision_patterns_test {

using namespace rigor;
using namespace rigor::testing;

namespace {

constexpr double restitutions[] = {-1, -0.5, 0, 0.5, 1}, frictions[] = {0, 0.1, 0.5, 1, 4};

// A vector of which any components are 0, equal or opposite; never the zero vector.
Vector3d special_vector(Random& random)
{
    Vector3d v = random.vector();
    for (int i = 0; i < 3; ++i) {
        if (random.bits() % 3 == 0) v[i] = 0;
        if (random.bits() % 4 == 0) v[i] = v[(i + 1) % 3];
        if (random.bits() % 4 == 0) v[i] = -v[(i + 1) % 3];
    }
    return v.norm() < 0.1 ? Vector3d(Vector3d::Unit(random_index(random, 3))) : v;
}

// Two bodies that approach. The eigenvalues of K lie between 0.2 and 1.6.
CollidingPair special_pair(Random& random)
{
    CollidingPair pair;
    Vector3d along = 0.9 * Vector3d::Ones() + 0.1 * random.vector();
    if (random.bits() % 2 == 0) along[0] = along[random_index(random, 3)];
    if (random.bits() % 4 == 0) along.setConstant(along[0]);
    pair.K = along.asDiagonal();
    for (int i = 0; i < 3; ++i) {
        const int k = (i + 1) % 3;
        if (random.bits() % 2 == 0) pair.K(i, k) = pair.K(k, i) = random.uniform(-0.3, 0.3);
    }
    pair.n = special_vector(random).normalized();
    pair.v = special_vector(random);
    if (pair.v.dot(pair.n) > 0) pair.v = -pair.v;
    if (pair.v.dot(pair.n) > -0.05) pair.v -= pair.n;
    pair.restitution = restitutions[random.bits() % 5];
    const double inverse = pair.K.inverse().norm();
    pair.size = inverse * pair.v.norm();
    pair.condition = inverse * pair.K.norm();
    return pair;
}

// v + K j is -ε vₙ n
void check_sticking(const CollidingPair& pair, const Vector3d& j)
{
    const Vector3d after = -pair.restitution * pair.v.dot(pair.n) * pair.n;
    REQUIRE_THAT(Vector3d(pair.v + pair.K * j), IsClose(after, Rounding(64, impulse_scale(pair))));
}

// Calls check(pair, friction) for special pairs and coefficients of friction.
template <class Check> void check_special_pairs(const Check& check)
{
    for (Random random : seeds(300)) {
        const CollidingPair pair = special_pair(random);
        const double friction = frictions[random.bits() % 5];
        CAPTURE(pair.K, pair.v, pair.n, pair.restitution, friction);
        check(pair, friction);
    }
}

} // namespace

TEST_CASE("collision: frictionless impulses of contacts of every structure", "[A4.5][collision]")
{
    check_special_pairs([](const CollidingPair& p, double) {
        check_extreme_sliding(p, 0, frictionless_impulse(p.K, p.v, p.n, p.restitution));
    });
}

TEST_CASE("collision: sticking impulses of contacts of every structure", "[A4.6][collision]")
{
    check_special_pairs([](const CollidingPair& p, double) {
        check_sticking(p, static_friction_impulse(p.K, p.v, p.n, p.restitution));
    });
}

TEST_CASE("collision: sliding impulses of contacts of every structure", "[A4.8][collision]")
{
    check_special_pairs([](const CollidingPair& p, double friction) {
        const double speed = tangential(p.v, p.n).norm();
        if ((speed < 1e-9 && speed > 0) || !slides_easily(p, friction)) return;
        check_extreme_sliding(p, friction,
                              sliding_friction_impulse(p.K, p.v, p.n, p.restitution, friction));
    });
}

TEST_CASE("collision: contacts of every structure stick or slide", "[A4.9][collision]")
{
    check_special_pairs([](const CollidingPair& p, double friction) {
        const Vector3d j = collision_impulse(p.K, p.v, p.n, p.restitution, friction);
        const double inside = margin(p, friction), speed = tangential(p.v, p.n).norm();
        if (inside > 1e-3)
            check_sticking(p, j);
        else if (inside < -1e-3 && slides_easily(p, friction) && speed > 1e-9)
            check_extreme_sliding(p, friction, j);
    });
}

} // namespace collision_patterns_test
