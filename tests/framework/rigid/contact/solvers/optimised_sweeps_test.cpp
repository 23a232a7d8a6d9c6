// SPDX-License-Identifier: MIT
// The engine's faster forms give the same results as the reference's formulas.
#include "rigid/bodies/optimised_forms.hpp"

#include "formulas/collision.hpp"
#include "formulas/contact.hpp"
#include "framework/rigid/worlds.hpp"
#include "rigid/contact/active_contacts.hpp"
#include "rigid/contact/blocks.hpp"
#include "rigid/contact/solvers/optimised_sweeps.hpp"
#include "support/catch.hpp"
#include "support/seeds.hpp"

using namespace rigor;
using namespace rigor::testing;

namespace {

Body random_body(Random& random)
{
    Body body;
    const Matrix3d A = rotation_matrix(random.quaternion());
    body.inverse_mass = random.uniform(0.1, 10);
    body.inverse_inertia =
        A *
        Vector3d(random.uniform(0.1, 10), random.uniform(0.1, 10), random.uniform(0.1, 10))
            .asDiagonal() *
        A.transpose();
    body.position = random.vector();
    body.velocity = random.vector();
    body.angular_velocity = random.vector();
    body.angular_momentum = random.vector();
    return body;
}

// Random bodies that touch each other and the ground, as a contact problem and as input for the
// formula.
struct Heap {
    ContactProblem problem;
    Island island;
    Counters counters;
    ThreadPool alone;
    std::vector<BodyContact> contacts;

    explicit Heap(unsigned seed)
    {
        Random random(seed);
        problem.counters = &counters;
        problem.pool = &alone;
        problem.optimised = true;
        problem.time_step = 0.01;
        problem.settings.gravity = {0, -g, 0};
        problem.bodies.emplace_back(); // the static body
        for (int i = 1; i < 7; ++i) {
            problem.bodies.push_back(random_body(random));
            island.bodies.push_back(i);
        }
        for (int i = 0; i < 15; ++i) {
            ContactConstraint c;
            c.body1 = 1 + i % 6;
            c.body2 = i < 6 ? 0 : 1 + (i * 5 + 3) % 6;
            if (c.body1 == c.body2) continue;
            c.point = 2 * random.vector();
            c.normal = random.unit_vector();
            c.gap = random.uniform(-0.01, 0.01);
            c.friction = random.uniform(0, 1);
            c.initial_impulse = 0.1 * c.normal;
            problem.set_impulse_matrix(c);
            const int at = static_cast<int>(problem.contacts.size());
            island.pairs.push_back({at, at + 1});
            problem.contacts.push_back(c);
        }
        split_into_blocks(problem, island);
        for (int i : activate_contacts(problem, island)) {
            const ContactConstraint& c = problem.contacts[i];
            contacts.push_back({c.body1, c.body2, c.point, c.normal, -c.gap, c.friction,
                                c.target_speed, c.initial_impulse});
        }
    }
};

} // namespace

TEST_CASE("optimised: velocities impulse matrices and impulses are the formulas'", "[rigid]")
{
    for (unsigned seed : seeds(20)) {
        CAPTURE(seed);
        Random random(seed);
        const Body a = random_body(random), b = random_body(random);
        const Vector3d x = random.vector(), j = random.vector();
        CHECK_THAT(optimised::relative_velocity(a, b, x),
                   IsClose(relative_velocity(a, b, x), Rounding(32, 8)));
        CHECK_THAT(optimised::impulse_matrix(a, x),
                   IsClose(impulse_matrix(a.inverse_mass, a.inverse_inertia, a.position, x),
                           Rounding(32, 200)));
        Body pushed = a;
        optimised::apply_impulse(pushed, x, j);
        CHECK_THAT(pushed, IsClose(apply_impulse(a, x, j), Rounding(32, 200)));
    }
}

TEST_CASE("optimised: the sweeps are those of resolve_simultaneously", "[rigid]")
{
    for (unsigned seed : seeds(20))
        for (int sweeps : {0, 1, 7}) {
            CAPTURE(seed, sweeps);
            Heap heap(seed);
            REQUIRE(heap.contacts.size() > 8);
            const ContactResult expected =
                resolve_simultaneously(heap.problem.bodies, heap.contacts, sweeps);
            const UninitializedVector<int> active = activate_contacts(heap.problem, heap.island);
            const auto fast = optimised_sweeps(heap.problem, heap.island, active);
            std::vector<Vector3d> steps(active.size());
            for (int i = 0; i < sweeps; ++i)
                fast->sweep(steps);
            fast->finish();
            // Each sweep adds some rounding error of velocities up to 10 m/s and impulses up to 10
            // N s.
            const Tolerance rounding = Rounding(1000.0 * (sweeps + 1), 10);
            for (std::size_t k = 0; k < active.size(); ++k)
                CHECK_THAT(heap.problem.contacts[active[k]].contact_impulse,
                           IsClose(expected.impulses[k], rounding));
            for (int i : heap.island.bodies)
                CHECK_THAT(heap.problem.bodies[i], IsClose(expected.bodies[i], rounding));
        }
}

TEST_CASE("optimised: a world of boxes moves as by the readable formulas", "[rigid]")
{
    std::vector<RigidBody> bodies = {fixed(Plane{}, {0.2, 0.5})};
    Random random(4);
    for (int i = 0; i < 6; ++i)
        bodies.push_back(body_of(Box{{0.4, 0.3, 0.5}}, Vector3d(0.9 * i, 0.4, 0), {0.2, 0.5},
                                 random.quaternion()));
    World fast = world_of(bodies), readable = fast;
    fast.settings.formulas_are_reference = true;
    run(fast, 60, 0.01);
    run(readable, 60, 0.01);
    REQUIRE(fast.counters.contact_impulses > 100);
    for (std::size_t i = 1; i < bodies.size(); ++i)
        CHECK_THAT(fast.bodies[i].state.position,
                   IsClose(readable.bodies[i].state.position, Rounding(1e4, 1)));
}
