// SPDX-License-Identifier: MIT
// A5.4: shock propagation.
#include "contact_laws.hpp"
#include "support/seeds.hpp"

#include <algorithm>
#include <numeric>

namespace rigor::testing::contact_shock_test {

namespace {

using Levels = std::vector<int>;

constexpr int n = 5; // iterations

ContactResult propagated(const ContactCase& problem, const Levels& levels, int iterations = n)
{
    return shock_propagation(problem.bodies, problem.contacts, levels, iterations);
}

// Random levels: 0 for static bodies and more for the others. Some levels may have no body.
Levels random_levels(const ContactCase& problem, unsigned seed)
{
    Random random(seed + 1000);
    Levels levels;
    for (const Body& body : problem.bodies)
        levels.push_back(body.is_static() ? 0 : static_cast<int>(random.uniform(1, 5)));
    return levels;
}

// Checks that a stack whose bodies are numbered from below is stopped.
void check_stopped(const ContactCase& problem, int iterations, const View& view = {})
{
    Levels levels(problem.bodies.size());
    std::iota(levels.begin(), levels.end(), 0);
    const ContactResult result = propagated(problem, levels, iterations);
    // everything below is held, so each contact stops its upper body alone
    for (std::size_t i = 0; i < problem.contacts.size(); ++i) {
        CAPTURE(iterations, i);
        const int body = problem.contacts[i].body1;
        const double mass = 1 / problem.bodies[body].inverse_mass;
        REQUIRE_THAT(result.impulses[i], IsClose(Vector3d(mass * view.velocity(up)),
                                                 Rounding(64, 5 * view.mass * view.speed)));
        REQUIRE_THAT(result.bodies[body].velocity,
                     IsClose(Vector3d(0, 0, 0), Rounding(64, view.speed)));
    }
    check_untouched(problem, result);
}

int visits(const ContactCase& problem)
{
    return n * static_cast<int>(problem.contacts.size());
}

} // namespace

TEST_CASE("contact: a stack is stopped whole in one pass", "[A5.4][contact]")
{
    for (int iterations : {1, 2, 10})
        check_stopped(stack({3, 1, 4, 1, 5}), iterations);

    for (Random random : seeds(5)) {
        const View view = random_view(random);
        std::vector<double> masses(2 + random.bits() % 6);
        for (double& mass : masses)
            mass = random.uniform(0.5, 5);
        ContactCase problem = turned(stack(masses), view);
        std::rotate(problem.contacts.begin(), problem.contacts.begin() + 1, problem.contacts.end());
        for (int iterations : {1, 2, 10})
            check_stopped(problem, iterations, view);
    }
}

TEST_CASE("contact: a stack far heavier above than below", "[A5.4][contact]")
{
    for (const double ratio : {1e3, 1e6, 1e12, 1e18, 1e40, 1e90}) {
        CAPTURE(ratio);
        const ContactCase problem = stack({1 / ratio, 1, ratio});
        const ContactResult result = propagated(problem, {0, 1, 2, 3});
        for (int i = 1; i <= 3; ++i)
            REQUIRE_THAT(result.bodies[i].velocity, IsClose(Vector3d(0, 0, 0), Rounding(64, 1)));
    }
}

TEST_CASE("contact: the blocks on a seesaw follow the plank that their weight has tilted",
          "[A5.4][contact]")
{
    // the plank already moves as the whole weight above lets it, but the blocks do not
    ContactCase problem = seesaw();
    const Bodies expected = tilting_seesaw();
    problem.bodies[1] = expected[1];
    const ContactResult result = propagated(problem, {0, 1, 2, 2});

    REQUIRE_THAT(result.bodies[1], IsExactly(expected[1])); // held; its own contact is at rest
    REQUIRE_THAT(result.bodies, IsClose(expected, Rounding(64, 1)));
    // each block is stopped against the plank: 6 (1 - 4/9) and 2 (1 + 4/9)
    REQUIRE_THAT(
        result.impulses,
        IsClose(std::vector<Vector3d>{0 * up, 10.0 / 3 * up, 26.0 / 9 * up}, Rounding(64, 4)));
}

TEST_CASE("contact: a seesaw that moves as its weight lets it is left as it is", "[A5.4][contact]")
{
    ContactCase problem = seesaw();
    problem.bodies = tilting_seesaw();
    const ContactResult result = propagated(problem, {0, 1, 2, 2});
    REQUIRE_THAT(result.bodies, IsClose(problem.bodies, Rounding(64, 1)));
}

TEST_CASE("contact: a body that is held keeps moving and drags what rests on it", "[A5.4][contact]")
{
    // A block falls on a cart on ice and is held by friction. The bodies of this contact are named
    // in both orders.
    ContactCase problem{{Body(), block(2, {0.5, 0, 0}), block(1, {0, -1, 0}, up)},
                        {touch(1, 0, 0.01), touch(2, 1, 0.01, 0.5 * up, 1)}};
    ContactResult result = propagated(problem, {0, 1, 2});
    REQUIRE_THAT(result.bodies[1], IsExactly(problem.bodies[1]));
    REQUIRE_THAT(result.bodies[2].velocity, IsClose(Vector3d(0.5, 0, 0), Rounding(64, 1)));
    REQUIRE_THAT(result.impulses[1], IsClose(Vector3d(0.5, 1, 0), Rounding(64, 1)));

    std::swap(problem.contacts[1].body1, problem.contacts[1].body2);
    problem.contacts[1].normal = -up;
    result = propagated(problem, {0, 1, 2});
    REQUIRE_THAT(result.bodies[1], IsExactly(problem.bodies[1]));
    REQUIRE_THAT(result.bodies[2].velocity, IsClose(Vector3d(0.5, 0, 0), Rounding(64, 1)));
    REQUIRE_THAT(result.impulses[1], IsClose(Vector3d(-0.5, -1, 0), Rounding(64, 1)));
}

TEST_CASE("contact: bodies of one level move each other", "[A5.4][contact]")
{
    // a body of 3 kg at 1 m/s runs into one of 1 kg at rest: both move on at 3/4 m/s
    ContactCase problem{{block(1), block(3, -up)}, {touch(1, 0, 0.01)}};
    for (int level : {1, 4}) {
        const ContactResult result = propagated(problem, {level, level});
        REQUIRE_THAT(result.impulses[0], IsClose(Vector3d(0, 0.75, 0), Rounding(64, 1)));
        for (int i : {0, 1})
            REQUIRE_THAT(result.bodies[i].velocity, IsClose(Vector3d(0, -0.75, 0), Rounding(64)));
    }
    for (unsigned seed : seeds(50)) {
        problem = random_case(seed, false);
        const ContactResult result = propagated(problem, Levels(problem.bodies.size(), 2));
        check_momenta(problem, result, visits(problem));
        check_bookkeeping(problem, result, visits(problem));
    }
}

TEST_CASE("contact: within a level the deepest contact comes first and gently", "[A5.4][contact]")
{
    // the rod of A5.2 with two iterations, and the same rod on a body that is held
    const auto rod_on = [](int below, double a, double b) -> ContactCase {
        return {{Body(), block(1), rod(-up)},
                {touch(2, below, 0.01, {a, 0, 0}), touch(2, below, 0.02, {b, 0, 0})}};
    };
    for (int below : {0, 1}) {
        CAPTURE(below);
        const ContactResult result = propagated(rod_on(below, -1, 1), {0, 1, 2}, 2);
        REQUIRE_THAT(result.impulses, IsClose(std::vector<Vector3d>{0.4140625 * up, 0.328125 * up},
                                              Rounding(32, 1)));
    }
    for (Random random : seeds(5)) {
        const View view = random_view(random);
        const double a = random.uniform(-1, -0.6), b = random.uniform(0.6, 1);
        for (int below : {0, 1})
            for (int iterations : {2, 3, 4}) {
                CAPTURE(below, iterations);
                const auto [at_b, at_a] = impulses_on_both_ends(iterations, b, a);
                const ContactResult result =
                    propagated(turned(rod_on(below, a, b), view), {0, 1, 2}, iterations);
                REQUIRE_THAT(
                    result.impulses,
                    IsClose(std::vector<Vector3d>{view.impulse(at_a * up), view.impulse(at_b * up)},
                            Rounding(32, view.mass * view.speed)));
            }
    }
}

TEST_CASE("contact: what is above does not matter to what is below", "[A5.4][contact]")
{
    for (unsigned seed : seeds(50)) {
        const ContactCase problem = random_case(seed, true);
        const Levels levels = random_levels(problem, seed);
        const Bodies whole = propagated(problem, levels).bodies;
        for (int top = 0; top <= 5; ++top) {
            ContactCase lower = problem;
            const auto is_above = [&](const BodyContact& c) {
                return std::max(levels[c.body1], levels[c.body2]) > top;
            };
            lower.contacts.erase(
                std::remove_if(lower.contacts.begin(), lower.contacts.end(), is_above),
                lower.contacts.end());
            const ContactResult result = propagated(lower, levels);
            for (std::size_t i = 0; i < levels.size(); ++i) {
                CAPTURE(i, top);
                if (levels[i] <= top)
                    REQUIRE_THAT(whole[i], IsClose(result.bodies[i], Rounding(64)));
            }
        }
    }
}

TEST_CASE("contact: each body receives the impulses of its own level only", "[A5.4][contact]")
{
    for (unsigned seed : seeds(100)) {
        const ContactCase problem = random_case(seed, true);
        const Levels levels = random_levels(problem, seed);
        const ContactResult result = propagated(problem, levels);
        const auto receives = [&](int body, const BodyContact& c) {
            return levels[body] == std::max(levels[c.body1], levels[c.body2]);
        };
        check_bookkeeping(problem, result, visits(problem), receives);
    }
}

TEST_CASE("contact: shock propagation pushes and stays in the friction cone", "[A5.4][contact]")
{
    for (unsigned seed : seeds(100)) {
        const ContactCase problem = random_case(seed, true);
        check_cones(problem, propagated(problem, random_levels(problem, seed)), visits(problem));
    }
}

TEST_CASE("contact: contacts of the ground level are left alone", "[A5.4][contact]")
{
    const ContactCase problem{{Body(), block(1, -up)}, {touch(1, 0, 0.01)}};
    const ContactResult result = propagated(problem, {0, 0});
    REQUIRE_THAT(result.bodies, IsExactly(problem.bodies));
    REQUIRE_THAT(result.impulses, IsExactly(std::vector<Vector3d>{{0, 0, 0}}));
}

TEST_CASE("contact: shock propagation without iterations or contacts changes nothing",
          "[A5.4][contact]")
{
    const ContactCase problem = stack({1, 2, 3});
    for (int iterations : {0, -1}) {
        const ContactResult result = propagated(problem, {0, 1, 2, 3}, iterations);
        REQUIRE_THAT(result.bodies, IsExactly(problem.bodies));
        REQUIRE_THAT(result.impulses, IsExactly(std::vector<Vector3d>(3, {0, 0, 0})));
    }
    const ContactResult untouched = propagated({problem.bodies, {}}, {0, 1, 2, 3});
    REQUIRE_THAT(untouched.bodies, IsExactly(problem.bodies));
    check_count(untouched.impulses.size(), 0, "impulses");
    check_count(propagated({}, {}).bodies.size(), 0, "bodies");
}

} // namespace rigor::testing::contact_shock_test
