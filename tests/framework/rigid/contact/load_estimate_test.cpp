// SPDX-License-Identifier: MIT
#include "rigid/contact/load_estimate.hpp"

#include "framework/rigid/worlds.hpp"

#include <numeric>

namespace load_estimate_test {

using namespace rigor;
using namespace rigor::testing;

namespace {

constexpr double h = 0.01; // [s]

// Bodies of 2 kg on top of each other, the lowest on static body 0. Contact k is below body k + 1.
struct Stack {
    ContactProblem problem;
    Island island;
    std::vector<int> active;

    explicit Stack(int bodies)
    {
        problem.time_step = h;
        problem.settings.gravity = {0, -g, 0};
        problem.bodies.emplace_back();
        for (int i = 1; i <= bodies; ++i) {
            Body body;
            body.inverse_mass = 0.5;
            body.position = {0, i - 0.5, 0};
            problem.bodies.push_back(body);
            island.bodies.push_back(i);
            ContactConstraint c;
            c.body1 = i;
            c.body2 = i - 1;
            c.point = {0, i - 1.0, 0};
            c.radius = 0.5;
            problem.contacts.push_back(c);
        }
        active.resize(bodies);
        std::iota(active.begin(), active.end(), 0);
    }
};

} // namespace

TEST_CASE("load estimate: a contact of a stack carries all bodies above it", "[rigid]")
{
    Stack stack(5);
    estimate_loads(stack.problem, stack.island, stack.active);
    for (int k = 0; k < 5; ++k)
        CHECK_THAT(stack.problem.contacts[k].initial_impulse,
                   IsClose(Vector3d(0, (5 - k) * 2 * g * h, 0), Rounding(16)));
}

TEST_CASE("load estimate: nothing is estimated where nothing rests on a static body", "[rigid]")
{
    Stack open(3);
    open.problem.contacts[0].gap = 0.01; // the lowest body does not touch the ground
    estimate_loads(open.problem, open.island, open.active);
    Stack weightless(3);
    weightless.problem.settings.gravity.setZero();
    estimate_loads(weightless.problem, weightless.island, weightless.active);
    for (const Stack* stack : {&open, &weightless})
        for (const ContactConstraint& c : stack->problem.contacts)
            CHECK(c.initial_impulse == Vector3d::Zero());
}

} // namespace load_estimate_test
