// SPDX-License-Identifier: MIT
// Two to six balls of any masses on a line, with small gaps, that hit each other again and again,
// with or without a wall at their end that gravity may pull them to. Many impacts fall into one
// step, each at its own time, and each decides what follows.
#include "balls_on_a_line.hpp"
#include "classics/problems.hpp"
#include "support/random.hpp"

namespace chains_of_balls {

using namespace rigor;
using namespace rigor::testing;

namespace {

template <class T> const T& one_of(const std::vector<T>& list, Random& random)
{
    return list[random_index(random, list.size())];
}

BallsOnALine any_chain(Random& random)
{
    BallsOnALine chain;
    chain.has_wall = random.bits() % 2 == 0;
    chain.gravity = chain.has_wall && random.bits() % 2 == 0 ? g : 0;
    chain.restitution = one_of<double>({1, 0.9, 0.7, 0.5, 0.3}, random);
    double x = chain.radius + random.uniform(1e-3, 0.05);
    for (std::uint64_t i = 2 + random.bits() % 5; i > 0; --i) {
        const double v = random.bits() % 3 == 0 ? random.uniform(-2, 2) : 0;
        chain.balls.push_back({x, v, std::exp(random.uniform(-2, 2))});
        x += 2 * chain.radius + 0.05 * std::exp(random.uniform(std::log(0.02), 0));
    }
    return chain;
}

World world_of_chain(const BallsOnALine& chain)
{
    const Material material{chain.restitution, 0};
    std::vector<RigidBody> bodies;
    for (const auto& [x, v, mass] : chain.balls) {
        bodies.push_back(ball_of_mass(chain.radius, mass, {x, 0, 0}, material));
        bodies.back().state.velocity = {v, 0, 0};
    }
    if (chain.has_wall) bodies.push_back(fixed(Box{{1, 9, 9}}, material, {-0.5, 0, 0}));
    return solved(bodies, {-chain.gravity, 0, 0});
}

// The largest difference of a velocity from the exact one [m/s].
double error_of(const BallsOnALine& chain, double h, double T)
{
    World world = world_of_chain(chain);
    run_until(world, T, h);
    BallsOnALine exact = chain;
    exact.advance(T);
    double error = 0;
    for (std::size_t i = 0; i < chain.balls.size(); ++i)
        error = std::max(error, std::abs(world.bodies[i].state.velocity.x() - exact.balls[i].v));
    return error;
}

} // namespace

TEST_CASE("classics: a chain of balls knows the time of each of its impacts", "[classics]")
{
    const double T = 0.2;
    int chains = 0;
    std::vector<unsigned> wrong; // seeds
    for (unsigned seed = 0; seed < 3000; ++seed) {
        Random random(seed);
        const BallsOnALine chain = any_chain(random);
        const double h = one_of<double>({0.02, 0.01, 0.005, 0.0025}, random);
        // Slow impacts and slow bounces are left out, since what follows them is sensitive.
        BallsOnALine exact = chain;
        exact.advance(T, 31);
        const double least = chain.gravity > 0 ? 0.3 : 1e-3;
        if (exact.impacts == 0 || exact.impacts > 30 || exact.slowest < 1e-3 ||
            exact.slowest_off_wall < least)
            continue;
        ++chains;
        if (!(error_of(chain, h, T) < 1e-5)) wrong.push_back(seed);
    }
    CAPTURE(chains, wrong);
    check_at_least(chains, 1000, "chains with impacts");
    // In one of some thousand chains, a ball that has almost come to rest on the wall is hit.
    check_at_most(static_cast<double>(wrong.size()) / chains, 2e-3, "share of wrong chains");
}

} // namespace chains_of_balls
