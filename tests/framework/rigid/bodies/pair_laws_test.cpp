// SPDX-License-Identifier: MIT
#include "rigid/bodies/pair_laws.hpp"

#include "framework/rigid/worlds.hpp"
#include "support/catch.hpp"

#include <array>

using namespace rigor;
using namespace rigor::testing;

namespace {

std::vector<PairLaw> some_laws()
{
    std::vector<PairLaw> laws = {
        {4, 1, 0.25, {}, true}, {0, 4, {}, 0.7, true}, {2, 3, {}, {}, false}};
    sort_by_pair(laws);
    return laws;
}

} // namespace

TEST_CASE("pair laws: a law holds for its two bodies in any order and for no others", "[rigid]")
{
    const std::vector<PairLaw> laws = some_laws();
    for (int i = 0; i < 5; ++i)
        for (int j = 0; j < 5; ++j) {
            CAPTURE(i, j);
            const PairLaw* law = law_of(laws, i, j);
            const bool has_law = (std::min(i, j) == 1 && std::max(i, j) == 4) ||
                                 (std::min(i, j) == 0 && std::max(i, j) == 4) ||
                                 (std::min(i, j) == 2 && std::max(i, j) == 3);
            REQUIRE((law != nullptr) == has_law);
            if (!law) continue;
            CHECK(law->body1 == std::min(i, j));
            CHECK(law->body2 == std::max(i, j));
        }
    CHECK(law_of({}, 0, 1) == nullptr);
}

TEST_CASE("pair laws: what a law leaves out follows from the materials", "[rigid]")
{
    std::vector<RigidBody> bodies(5, free_box());
    for (int i = 0; i < 5; ++i)
        bodies[i].material = {0.1 * (i + 1), 0.1 * (i + 1)};
    const std::vector<PairLaw> laws = some_laws();
    const Material first = material_between(laws, bodies, 4, 1);
    CHECK(first.restitution == 0.25);
    CHECK_THAT(first.friction, IsClose(std::sqrt(0.5 * 0.2), Rounding(4)));
    const Material second = material_between(laws, bodies, 0, 4);
    CHECK(second.restitution == 0.1);
    CHECK(second.friction == 0.7);
    const Material other = material_between(laws, bodies, 0, 3);
    CHECK(other.restitution == 0.1);
    CHECK_THAT(other.friction, IsClose(0.2, Rounding(4)));
}

TEST_CASE("pair laws: a part of a world keeps the laws of its bodies", "[rigid]")
{
    const std::vector<PairLaw> laws = some_laws();
    const std::vector<PairLaw> among = laws_among(laws, std::array{1, 2, 4});
    REQUIRE(among.size() == 1);
    CHECK(among[0].body1 == 0);
    CHECK(among[0].body2 == 2);
    CHECK(among[0].restitution == 0.25);
}

// Without a law for the pair, the smaller restitution of the two bodies and the geometric mean of
// their frictions would count.
TEST_CASE("pair laws: bodies bounce and slide by the law of their pair", "[rigid]")
{
    for (const double restitution : {0., 0.5, 1.}) {
        World world = world_of({body_of(Sphere{0.1}, {0, 0, 0}, {0.3, 0}),
                                body_of(Sphere{0.1}, {0.5, 0, 0}, {0.8, 0})},
                               {0, 0, 0});
        world.bodies[0].state.velocity = {1, 0, 0};
        world.pair_laws = {{0, 1, restitution, {}, true}};
        run(world, 100, 0.01);
        CAPTURE(restitution);
        CHECK_THAT(world.bodies[1].state.velocity.x(),
                   IsClose((1 + restitution) / 2, Rounding(64)));
    }
    for (const double mu : {0., 0.1, 0.4}) {
        World world =
            world_of({fixed(Plane{}, {0, 1}), body_of(Box{{0.4, 0.1, 0.4}}, {0, 0.05, 0}, {0, 1})});
        world.bodies[1].state.velocity = {3, 0, 0};
        world.pair_laws = {{0, 1, {}, mu, true}};
        run(world, 50, 0.01);
        CAPTURE(mu);
        CHECK_THAT(world.bodies[1].state.velocity.x(), IsClose(3 - mu * g * 0.5, Order(1e-9)));
    }
}

// There are three equal balls in a row. The first passes through the second and stops at the third.
TEST_CASE("pair laws: bodies that do not collide pass through each other alone", "[rigid]")
{
    for (const bool collides : {false, true}) {
        CAPTURE(collides);
        const auto ball = [](double x) { return body_of(Sphere{0.1}, {x, 0, 0}, {1, 0}); };
        World world = world_of({ball(0), ball(0.5), ball(1)}, {0, 0, 0});
        world.bodies[0].state.velocity = {1, 0, 0};
        world.pair_laws = {{0, 1, {}, {}, collides}};
        run(world, 110, 0.01);
        const auto x = [&](int i) { return world.bodies[i].state.position.x(); };
        CHECK_THAT(x(0), IsClose(collides ? 0.3 : 0.8, Rounding(1e3, 1)));
        CHECK_THAT(x(1), IsClose(collides ? 0.8 : 0.5, Rounding(1e3, 1)));
        CHECK_THAT(world.bodies[2].state.velocity.x(), IsClose(1.0, Rounding(1e3, 1)));
    }
}
