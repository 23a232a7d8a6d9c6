// SPDX-License-Identifier: MIT
#include "framework/rigid/integrators.hpp"
#include "framework/rigid/worlds.hpp"
#include "rigid/bodies/mass.hpp"
#include "rigid/step/step.hpp"

namespace single_body_test {

using namespace rigor;
using namespace rigor::testing;

namespace {

constexpr double h = 1.0 / 60; // [s]

RigidBody thrown_box()
{
    RigidBody body = body_of(Box{{1, 2, 3}}, {0, 5, 0});
    body.state.velocity = {1, 2, 3};
    body.state.angular_momentum = 4000 * Vector3d(3, 1, 2);
    return body;
}

// A box that turns about one axis alone, which is no principal axis.
RigidBody box_on_an_axis()
{
    RigidBody body = thrown_box();
    let_turn_about(body, Vector3d(1, 2, 2) / 3);
    return body;
}

void check_flight(const RigidBody& body)
{
    for (const Integrator integrator : all_integrators) {
        CAPTURE(static_cast<int>(integrator));
        World alone = world_of({body}), two = world_of({body, fixed(Box{{1, 1, 1}}, {0, 0.5})});
        two.bodies[1].state.position = {1000, 0, 0};
        alone.settings.integrator = two.settings.integrator = integrator;
        for (int i = 0; i < 50; ++i) {
            REQUIRE(step(alone, h).empty());
            REQUIRE(step(two, h).empty());
        }
        const RigidState &a = alone.bodies[0].state, &b = two.bodies[0].state;
        CHECK(a.position == b.position);
        CHECK(a.orientation.s == b.orientation.s);
        CHECK(a.orientation.v == b.orientation.v);
        CHECK(a.velocity == b.velocity);
        CHECK(a.angular_momentum == b.angular_momentum);
        CHECK(alone.time == two.time);
        CHECK(alone.counters.steps == two.counters.steps);
        CHECK(alone.counters.substeps == two.counters.substeps);
        CHECK(alone.counters.free_flights == two.counters.free_flights);
    }
}

} // namespace

TEST_CASE("single body: a body that is alone flies as it does far from others", "[rigid]")
{
    check_flight(thrown_box());
    check_flight(box_on_an_axis());
}

} // namespace single_body_test
