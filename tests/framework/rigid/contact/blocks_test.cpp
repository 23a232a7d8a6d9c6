// SPDX-License-Identifier: MIT
// Blocks of a large island, which several threads sweep.
#include "rigid/contact/blocks.hpp"

#include "framework/rigid/worlds.hpp"
#include "rigid/step/step.hpp"
#include "support/catch.hpp"

#include <cstring>
#include <set>

using namespace rigor;
using namespace rigor::testing;

namespace {

// Three layers of cubes on the ground. The cubes of a layer touch each other.
World large_pile()
{
    Random random(5);
    std::vector<RigidBody> bodies = {fixed(Plane{}, {0, 0.5})};
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 12; ++x)
            for (int z = 0; z < 12; ++z) {
                const Vector3d X(0.9995 * x + 0.3 * y, y + 0.5, 0.9995 * z + 0.1 * y);
                bodies.push_back(body_of(Box{{1, 1, 1}}, X + 1e-4 * random.vector(), {0, 0.5}));
            }
    World world = world_of(std::move(bodies));
    world.settings.contact_method = ContactMethod::simultaneous;
    world.settings.formulas_are_reference = true;
    return world;
}

// A chain of contacts along x: body k touches body k + 1, and the first body touches the ground.
ContactProblem chain(int bodies, Island& island)
{
    ContactProblem problem;
    problem.settings.gravity = {0, -g, 0};
    problem.bodies.emplace_back(); // the static body
    for (int i = 1; i <= bodies; ++i) {
        Body& body = problem.bodies.emplace_back();
        body.inverse_mass = 1;
        body.position = {0.5 * i, 1, 0};
        island.bodies.push_back(i);
    }
    for (int i = 0; i < bodies; ++i) {
        ContactConstraint c;
        c.body1 = i;
        c.body2 = i + 1;
        problem.contacts.push_back(c);
        island.pairs.push_back({i, i + 1});
    }
    return problem;
}

} // namespace

TEST_CASE("blocks: those of one color share no body and no pair is lost", "[rigid]")
{
    for (int bodies : {50, 400, 2000}) {
        CAPTURE(bodies);
        Island island;
        const ContactProblem problem = chain(bodies, island);
        split_into_blocks(problem, island);
        std::set<int> seen;
        int last = 0;
        for (const IndexRange& color : island.colors) {
            std::set<int> taken;
            for (int k = color.first; k < color.last; ++k) {
                REQUIRE(island.blocks[k].first == last);
                last = island.blocks[k].last;
                std::set<int> own;
                for (int i = island.blocks[k].first; i < last; ++i) {
                    const ContactConstraint& c = problem.contacts[island.pairs[i].first];
                    REQUIRE(seen.insert(island.pairs[i].first).second);
                    for (int body : {c.body1, c.body2})
                        if (!problem.bodies[body].is_static()) own.insert(body);
                }
                for (int body : own)
                    REQUIRE(taken.insert(body).second);
            }
        }
        REQUIRE(last == bodies);
        REQUIRE((island.colors.size() > 1) == (bodies > 200));
    }
}

TEST_CASE("blocks: a large pile moves by the same bits with any number of threads", "[rigid]")
{
    World one = large_pile(), three = one;
    three.pool = ThreadPool(3);
    for (int i = 0; i < 8; ++i) {
        step(one, 1.0 / 60);
        step(three, 1.0 / 60);
    }
    REQUIRE(one.counters.contact_impulses > 1000);
    REQUIRE(std::memcmp(&one.counters, &three.counters, sizeof(Counters)) == 0);
    for (std::size_t i = 1; i < one.bodies.size(); ++i) {
        CAPTURE(i);
        const RigidState &a = one.bodies[i].state, &b = three.bodies[i].state;
        REQUIRE(a.position == b.position);
        REQUIRE(a.orientation.s == b.orientation.s);
        REQUIRE(a.orientation.v == b.orientation.v);
        REQUIRE(a.velocity == b.velocity);
        REQUIRE(a.angular_momentum == b.angular_momentum);
    }
}
