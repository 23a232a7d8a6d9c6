// SPDX-License-Identifier: MIT
// The same world gives bitwise the same results, for any number of threads and any number of runs.
#include "framework/rigid/worlds.hpp"
#include "rigid/step/step.hpp"

#include <cstring>
#include <map>

using namespace rigor;
using namespace rigor::testing;

namespace {

// A pile that falls together, a stack and a few single bodies: several islands, some of them at
// rest.
World busy_world(ContactMethod method)
{
    Random random(3);
    const Material material{0.3, 0.5};
    std::vector<RigidBody> bodies = {fixed(Plane{}, material)};
    for (int i = 0; i < 12; ++i) {
        const Vector3d X = 1.8 * Vector3d(i % 2, 1 + i / 4, i / 2 % 2) + 0.1 * random.vector();
        bodies.push_back(body_of(Box{{1, 1, 1}}, X, material, random.quaternion()));
    }
    for (int i = 0; i < 4; ++i)
        bodies.push_back(body_of(Box{{1, 1, 1}}, {20, i + 0.5, 0}, material));
    for (int i = 0; i < 4; ++i)
        bodies.push_back(body_of(Sphere{0.5}, {-10.0 - 3 * i, 1.0 + i, 0}, material));
    World world = world_of(std::move(bodies));
    world.settings.contact_method = method;
    return world;
}

// All bits of the results of a run, step by step. They are compared directly, so that no hash can
// hide a difference.
std::vector<double> run_bits(World world, int steps)
{
    std::vector<double> bits;
    const auto put = [&bits](const Vector3d& v) {
        bits.insert(bits.end(), v.data(), v.data() + 3);
    };
    for (int i = 0; i < steps; ++i) {
        for (const ContactRecord& c : step(world, 1.0 / 60)) {
            bits.insert(bits.end(), {double(c.body1), double(c.body2), c.depth});
            put(c.point);
            put(c.normal);
            put(c.impulse);
        }
        for (const RigidBody& body : world.bodies) {
            put(body.state.position);
            bits.push_back(body.state.orientation.s);
            put(body.state.orientation.v);
            put(body.state.velocity);
            put(body.state.angular_momentum);
        }
    }
    return bits;
}

bool same_bits(const std::vector<double>& a, const std::vector<double>& b)
{
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

constexpr ContactMethod methods[] = {ContactMethod::built_in, ContactMethod::one_at_a_time,
                                     ContactMethod::shock_propagation, ContactMethod::simultaneous};
constexpr int one_second = 60;

} // namespace

TEST_CASE("determinism: the number of threads does not change a bit", "[rigid]")
{
    for (const ContactMethod method : methods)
        for (const bool reference : {false, true}) {
            CAPTURE(static_cast<int>(method), reference);
            World world = busy_world(method);
            world.settings.formulas_are_reference = reference;
            const std::vector<double> one = run_bits(world, one_second);
            world.pool = ThreadPool(reference ? 3 : 2);
            REQUIRE(same_bits(run_bits(world, one_second), one));
        }
}

TEST_CASE("determinism: a second run in the same process is the same", "[rigid]")
{
    for (const ContactMethod method : methods) {
        CAPTURE(static_cast<int>(method));
        const World world = busy_world(method);
        const std::vector<double> first = run_bits(world, one_second);
        // Another run in between, so that the memory has different contents.
        run_bits(busy_world(ContactMethod::built_in), 7);
        REQUIRE(same_bits(run_bits(world, one_second), first));
    }
}

TEST_CASE("determinism: a copy of a world in the middle of a run goes on as it does", "[rigid]")
{
    for (const ContactMethod method : methods) {
        CAPTURE(static_cast<int>(method));
        World world = busy_world(method);
        run(world, 30, 1.0 / 60);
        const World copy = world;
        run(world, 1, 1.0 / 60); // a change of the world must not change its copy
        World again = copy;
        run(again, 1, 1.0 / 60);
        REQUIRE(same_bits(run_bits(again, 30), run_bits(world, 30)));
    }
}

TEST_CASE("determinism: bodies may be called what they like", "[rigid]")
{
    World named = busy_world(ContactMethod::simultaneous);
    for (std::size_t i = 0; i < named.bodies.size(); ++i)
        named.bodies[i].name = std::string(1 + i * 7 % 40, static_cast<char>('z' - i % 26));
    REQUIRE(same_bits(run_bits(named, one_second),
                      run_bits(busy_world(ContactMethod::simultaneous), one_second)));
}

TEST_CASE("determinism: the comparison sees a single bit", "[rigid]")
{
    World world = busy_world(ContactMethod::simultaneous);
    const std::vector<double> bits = run_bits(world, 1);
    world.bodies[1].state.position.x() = std::nextafter(world.bodies[1].state.position.x(), 9);
    REQUIRE_FALSE(same_bits(run_bits(world, 1), bits));
}
