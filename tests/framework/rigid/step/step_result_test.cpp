// SPDX-License-Identifier: MIT
#include "rigid/step/step_result.hpp"

#include "framework/rigid/contact/hand_made.hpp"
#include "rigid/bodies/non_finite.hpp"

#include <limits>

using namespace rigor;
using namespace rigor::testing;

namespace {

// Two balls beside each other on the ground, and the result of their step.
struct EndOfStep {
    World world;
    HandMade problem;
    ContactCandidates candidates;
    Refinement refined;
    StepResult result;

    EndOfStep()
    {
        world = world_of({fixed(Plane{}, {}), body_of(Sphere{0.5}, {1, 0.5, 0}),
                          body_of(Sphere{0.5}, {2, 0.5, 0})});
        world.time = 3;
        candidates.poses = {{},
                            {Matrix3d::Identity(), {1, 0.5, 0}},
                            {rotation_matrix(turn({0, 0, 1}, std::numbers::pi / 2)), {2, 0.5, 0}}};
        for (const RigidBody& body : world.bodies) {
            if (!body.is_static) problem.add(ball_at(body.state.position, body.mass));
            result.states.push_back(body.state);
        }
        problem.touch(1, 0, {1, 0, 0});
        problem.touch(2, 0, {2, 0, 0});
        problem.islands = {problem.island};
    }

    void collect() { collect_contacts(world, problem, candidates, refined, result); }
};

WarmContact warm_between(int body1, int body2, double x = 0)
{
    return {body1, body2, {x, 0, 0}, {x, 0, 0}, {0, 1, 0}};
}

ContactRecord record_between(int body1, int body2, double depth = 0)
{
    ContactRecord record;
    record.body1 = body1;
    record.body2 = body2;
    record.depth = depth;
    record.impulse = {0, 1, 0};
    return record;
}

} // namespace

TEST_CASE("step result: a contact with an impulse is recorded with the sum over the step",
          "[rigid]")
{
    EndOfStep end;
    ContactConstraint& c = end.problem.contacts[1];
    c.gap = -0.25;
    c.collision_impulse = {1, 2, 0};
    c.contact_impulse = {0, 3, 1};
    end.collect();
    REQUIRE(end.result.records.size() == 1); // the other contact got nothing
    const ContactRecord& record = end.result.records[0];
    CHECK(record.body1 == 2);
    CHECK(record.body2 == 0);
    CHECK(record.point == Vector3d(2, 0, 0));
    CHECK(record.normal == Vector3d(0, 1, 0));
    CHECK(record.depth == 0.25);
    CHECK(record.impulse == Vector3d(1, 5, 1));
    CHECK(end.world.counters.contacts == 1);
    CHECK(end.world.counters.islands == 1);
}

TEST_CASE("step result: the next step starts from the contact impulse in space of body 1",
          "[rigid]")
{
    EndOfStep end;
    end.problem.contacts[0].collision_impulse = {0, 5, 0}; // a bounce is not repeated
    end.problem.contacts[1].contact_impulse = {0, 3, 0};
    end.collect();
    REQUIRE(end.result.warm_contacts.size() == 1);
    const WarmContact& warm = end.result.warm_contacts[0];
    CHECK(warm.body1 == 2);
    CHECK(warm.body2 == 0);
    // The point half a meter below the center, seen from a body that is turned by 90° about z.
    CHECK_THAT(warm.point1, IsClose(Vector3d(-0.5, 0, 0), Rounding(4, 1)));
    CHECK(warm.mean_force == Vector3d(0, 3 / end.problem.time_step, 0));
}

TEST_CASE("step result: contacts of refined islands are sorted in between the others", "[rigid]")
{
    EndOfStep end;
    end.problem.contacts[0].contact_impulse = {0, 1, 0};
    end.problem.contacts[1].contact_impulse = {0, 1, 0};
    end.result.records = {record_between(7, 0)}; // a bounce inside the step
    end.refined.records = {record_between(1, 2)};
    end.refined.warm_contacts = {warm_between(1, 2, 5), warm_between(1, 2, 6), warm_between(0, 4)};
    end.collect();
    std::vector<std::pair<int, int>> warm, records;
    for (const WarmContact& c : end.result.warm_contacts)
        warm.emplace_back(c.body1, c.body2);
    for (const ContactRecord& r : end.result.records)
        records.emplace_back(r.body1, r.body2);
    using Pairs = std::vector<std::pair<int, int>>;
    CHECK(warm == Pairs{{0, 4}, {1, 0}, {1, 2}, {1, 2}, {2, 0}});
    CHECK(end.result.warm_contacts[2].point1.x() == 5); // those of one pair keep their order
    CHECK(records == Pairs{{7, 0}, {1, 0}, {2, 0}, {1, 2}});
    CHECK(end.world.counters.contacts == 3); // the substeps counted those of refined islands
}

TEST_CASE("step result: a step without contacts has none", "[rigid]")
{
    EndOfStep end;
    end.problem.contacts.clear();
    end.problem.islands.clear();
    end.collect();
    CHECK(end.result.records.empty());
    CHECK(end.result.warm_contacts.empty());
    CHECK(end.world.counters.contacts == 0);
    CHECK(end.world.counters.islands == 0);
}

TEST_CASE("step result: a state that is not finite is named at the end of the step", "[rigid]")
{
    EndOfStep end;
    end.world.bodies[2].name = "second";
    end.result.states[2].orientation.s = std::numeric_limits<double>::quiet_NaN();
    try {
        end.collect();
        FAIL("no exception");
    } catch (const NonFiniteState& error) {
        CHECK(error.body == "second");
        CHECK(error.quantity == "orientation q");
        CHECK(error.time == 3 + end.problem.time_step);
    }
}

TEST_CASE("step result: any number of threads collects the same contacts", "[rigid]")
{
    std::vector<ContactRecord> records[2];
    for (const int threads : {1, 2}) {
        EndOfStep end;
        end.problem.threads = ThreadPool(threads);
        end.problem.contacts.clear();
        for (int i = 0; i < 2000; ++i)
            end.problem.touch(1, 0, {1.0 * i, 0, 0}).contact_impulse = {0, i % 2 * 1.0, 0};
        end.collect();
        CHECK(end.result.warm_contacts.size() == 1000);
        records[threads - 1] = end.result.records;
    }
    REQUIRE(records[0].size() == 1000);
    REQUIRE(records[1].size() == 1000);
    for (std::size_t i = 0; i < 1000; ++i)
        REQUIRE(records[0][i].point == records[1][i].point);
}

TEST_CASE("step result: the world gets its states and its memory and its time", "[rigid]")
{
    EndOfStep end;
    end.result.states[1].position = {9, 9, 9};
    end.result.records = {record_between(1, 0)};
    end.result.warm_contacts = {warm_between(1, 0, 4)};
    end.world.memory.warm_contacts = {warm_between(2, 0), warm_between(1, 0)}; // from the last step
    const std::vector<ContactRecord> records = finish_step(end.world, 0.25, end.result);
    CHECK(end.world.bodies[1].state.position == Vector3d(9, 9, 9));
    CHECK(end.world.bodies[2].state.position == Vector3d(2, 0.5, 0));
    REQUIRE(end.world.memory.warm_contacts.size() == 1);
    CHECK(end.world.memory.warm_contacts[0].point1.x() == 4);
    CHECK(end.world.time == 3.25);
    CHECK(end.world.counters.steps == 1);
    CHECK(records.size() == 1);
}

TEST_CASE("step result: the contacts of sleeping bodies are those they fell asleep with", "[rigid]")
{
    EndOfStep end;
    end.world.bodies[2].rest.group = 0; // fell asleep in this step
    end.world.memory.sleeping_contacts = {{record_between(2, 0, 0.5), 0.125}};
    end.world.memory.sleeping_contacts[0].impulse = {0, 3, 0};
    end.result.records = {record_between(2, 0), record_between(1, 0), record_between(1, 2)};
    const std::vector<ContactRecord> records = finish_step(end.world, 0.25, end.result);
    REQUIRE(records.size() == 2);
    CHECK(records[0].body1 == 1);
    CHECK(records[0].body2 == 0);
    CHECK(records[1].body1 == 2);
    CHECK(records[1].depth == 0.5);
    CHECK(records[1].impulse == Vector3d(0, 6, 0));        // the same force in a step twice as long
    CHECK(end.world.memory.sleeping_contacts.size() == 1); // they are kept for the next step
}
