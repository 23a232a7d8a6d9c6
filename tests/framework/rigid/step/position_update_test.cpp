// SPDX-License-Identifier: MIT
#include "rigid/step/position_update.hpp"

#include "framework/rigid/contact/hand_made.hpp"
#include "rigid/bodies/non_finite.hpp"
#include "rigid/step/mean_velocity.hpp"
#include "support/free_rotor.hpp"

#include <limits>

using namespace rigor;
using namespace rigor::testing;

namespace {

// Balls of radius ½ m on the ground, which move at 2 m/s along x and do not rotate. Each has one
// contact with the ground, without an impulse.
struct Balls {
    World world;
    HandMade problem;
    std::vector<bool> pulled;
    std::vector<Body> after_collisions;
    std::vector<Displacement> displacements;
    std::vector<RigidState> states; // after free flight; NaN, so that any use shows

    explicit Balls(int count = 1, int threads = 1) : problem(threads)
    {
        world = world_of({fixed(Plane{}, {})});
        for (int i = 0; i < count; ++i) {
            RigidBody ball = body_of(Sphere{0.5}, {2.0 * i, 0.5, 0});
            ball.state.velocity = {2, 0, 0};
            world.bodies.push_back(ball);
            Body moving = ball_at(ball.state.position, ball.mass, ball.state.velocity);
            moving.inverse_inertia = ball.inverse.inverse_inertia;
            problem.touch(problem.add(moving), 0, {2.0 * i, 0, 0});
        }
        pulled.assign(world.bodies.size(), false);
        after_collisions = problem.bodies;
        RigidState unknown;
        unknown.position.setConstant(std::numeric_limits<double>::quiet_NaN());
        states.assign(world.bodies.size(), unknown);
    }

    const RigidState& update()
    {
        problem.islands = {problem.island};
        std::vector<Pose> poses;
        for (const RigidBody& body : world.bodies)
            poses.push_back(pose_of(body.state));
        const std::vector<char> by_mean =
            solve_again_at_midpoint(world, after_collisions, states, poses, problem);
        update_positions(world, problem, pulled, after_collisions, by_mean, displacements, {},
                         states);
        return states[1];
    }
};

constexpr double dt = 0.01; // the time step [s]
constexpr Integrator first_order[] = {Integrator::linear, Integrator::exponential, Integrator::buss,
                                      Integrator::gram_schmidt, Integrator::euler_angles};
constexpr Integrator higher_order[] = {Integrator::runge_kutta, Integrator::matrix,
                                       Integrator::exact};
const Vector3d push(0, 1, 0); // any impulse [N s]

} // namespace

TEST_CASE("position update: a body without an impulse keeps the state after free flight", "[rigid]")
{
    Balls balls(2);
    balls.world.counters.free_flights = 2; // as counted in free flight
    balls.states[1].position = {1, 2, 3};
    balls.states[1].velocity = {4, 5, 6};
    const RigidState flown = balls.states[1];
    balls.problem.contacts[1].contact_impulse = push; // the other ball has one
    CHECK_THAT(balls.update(), IsExactly(flown));
    CHECK(balls.world.counters.free_flights == 1); // the other one flew again
}

TEST_CASE("position update: a body that only bounced flies on under gravity", "[rigid]")
{
    Balls balls;
    balls.problem.contacts[0].collision_impulse = push;
    balls.after_collisions[1].velocity = {2, 3, 0};
    balls.problem.bodies[1].velocity = {7, 7, 7}; // right only if a contact held it
    const RigidState& end = balls.update();
    CHECK_THAT(end.position,
               IsClose(Vector3d(2 * dt, 0.5 + 3 * dt - g * dt * dt / 2, 0), Rounding(4, 1)));
    CHECK_THAT(end.velocity, IsClose(Vector3d(2, 3 - g * dt, 0), Rounding(4)));
}

TEST_CASE("position update: a body that slides moves with the mean of its velocities", "[rigid]")
{
    for (const bool is_higher : {true, false})
        for (const Integrator integrator :
             is_higher ? std::span<const Integrator>(higher_order) : std::span(first_order)) {
            CAPTURE(static_cast<int>(integrator));
            Balls balls;
            balls.world.settings.integrator = integrator;
            balls.problem.contacts[0].contact_impulse = push;
            balls.problem.bodies[1].velocity = {1, 0, 0}; // after friction
            const RigidState& end = balls.update();
            // By an integrator of first order it moves with the velocity at the end.
            const double v = is_higher ? 1.5 : 1;
            CHECK_THAT(end.position, IsClose(Vector3d(v * dt, 0.5, 0), Rounding(4, 1)));
            CHECK(end.velocity == Vector3d(1, 0, 0));
        }
}

TEST_CASE("position update: the mean angular momentum turns a body that rolls", "[rigid]")
{
    for (const Integrator integrator : higher_order) {
        CAPTURE(static_cast<int>(integrator));
        Balls balls;
        balls.world.settings.integrator = integrator;
        spin(balls.world.bodies[1], {0, 0, -4});
        const Vector3d L = balls.world.bodies[1].state.angular_momentum;
        balls.after_collisions[1].angular_momentum = L;
        balls.after_collisions[1].angular_velocity = {0, 0, -4};
        balls.problem.bodies[1].angular_momentum = 2 * L; // after friction
        balls.problem.bodies[1].angular_velocity = {0, 0, -8};
        balls.problem.contacts[0].contact_impulse = push;
        const RigidState& end = balls.update();
        // A step of Runge and Kutta on the matrix is right up to a power of the angle, 0.06⁵/120.
        const double error = integrator == Integrator::matrix ? 1e-8 : 1e-15;
        CHECK(rotation_angle(eigen(end.orientation), eigen(turn({0, 0, -1}, 6 * dt))) < error);
        CHECK(end.angular_momentum == Vector3d(2 * L));
    }
}

TEST_CASE("position update: where a contact opens the velocity at the end counts", "[rigid]")
{
    enum class Opens { at_start, at_end, by_bounce };
    for (const Opens opens : {Opens::at_start, Opens::at_end, Opens::by_bounce}) {
        CAPTURE(static_cast<int>(opens));
        Balls balls;
        balls.problem.contacts[0].contact_impulse = push;
        balls.problem.bodies[1].velocity = {1, opens == Opens::at_end ? 0.5 : 0, 0};
        if (opens == Opens::at_start) balls.after_collisions[1].velocity.y() = -0.5;
        if (opens == Opens::by_bounce) balls.problem.contacts[0].collision_impulse = push;
        const Vector3d V = balls.problem.bodies[1].velocity;
        const RigidState& end = balls.update();
        CHECK_THAT(end.position, IsClose(Vector3d(Vector3d(0, 0.5, 0) + dt * V), Rounding(4, 1)));
        CHECK(end.velocity == V);
    }
}

TEST_CASE("position update: forces that pull are in the velocity after a bounce", "[rigid]")
{
    Balls balls;
    balls.problem.contacts[0].collision_impulse = push;
    balls.pulled[1] = true;
    balls.problem.bodies[1].velocity = {1, 3, 0}; // after the collision and the forces
    const RigidState& end = balls.update();
    CHECK_THAT(end.position, IsClose(Vector3d(dt, 0.5 + 3 * dt, 0), Rounding(4, 1)));
    CHECK(end.velocity == Vector3d(1, 3, 0));
}

TEST_CASE("position update: displacements are added without a velocity", "[rigid]")
{
    const Displacement shift{{0, 0.25, 0}, {0, 0, 0}}, rotation{{0, 0, 0}, {0, 0.5, 0}},
        both{{0, 0.25, 0}, {0, 0.5, 0}};
    for (const Displacement& by : {shift, rotation, both})
        for (const bool has_impulse : {false, true}) {
            CAPTURE(by.shift.y(), by.turn.y(), has_impulse);
            Balls balls;
            balls.states[1] = balls.world.bodies[1].state;
            balls.displacements = {{}, by};
            if (has_impulse) balls.problem.contacts[0].contact_impulse = push;
            balls.problem.bodies[1].velocity.setZero();
            balls.after_collisions[1].velocity.setZero();
            balls.world.bodies[1].state.velocity.setZero();
            balls.states[1].velocity.setZero();
            const RigidState& end = balls.update();
            CHECK(end.position == Vector3d(Vector3d(0, 0.5, 0) + by.shift));
            CHECK(rotation_angle(eigen(end.orientation), eigen(turn({0, 1, 0}, by.turn.y()))) <
                  1e-15);
            CHECK(end.velocity == Vector3d(0, 0, 0));
            CHECK(end.angular_momentum == Vector3d(0, 0, 0));
        }
}

TEST_CASE("position update: a velocity that is none is named with its body and time", "[rigid]")
{
    Balls balls;
    balls.world.time = 3;
    balls.world.bodies[1].name = "ball";
    balls.problem.contacts[0].contact_impulse = push;
    balls.problem.bodies[1].velocity.z() = std::numeric_limits<double>::infinity();
    try {
        balls.update();
        FAIL("no exception");
    } catch (const NonFiniteState& error) {
        CHECK(error.body == "ball");
        CHECK(error.quantity == "velocity V");
        CHECK(error.time == 3 + dt);
    }
}

TEST_CASE("position update: without islands nothing changes", "[rigid]")
{
    Balls balls;
    update_positions(balls.world, balls.problem, balls.pulled, balls.after_collisions, {}, {}, {},
                     balls.states);
    CHECK(std::isnan(balls.states[1].position.x()));
    CHECK(balls.world.counters.free_flights == 0);
}

TEST_CASE("position update: any number of threads gives the same bits", "[rigid]")
{
    const auto end = [](int threads) {
        Balls balls(300, threads);
        Random random(4);
        for (std::size_t i = 1; i < balls.problem.bodies.size(); ++i) {
            Body& body = balls.problem.bodies[i];
            body.velocity = random.vector();
            body.angular_momentum = random.vector();
            balls.problem.contacts[i - 1].contact_impulse = push;
        }
        balls.update();
        return balls.states;
    };
    const std::vector<RigidState> one = end(1);
    for (const int threads : {2, 3}) {
        const std::vector<RigidState> more = end(threads);
        for (std::size_t i = 1; i < one.size(); ++i)
            REQUIRE_THAT(more[i], IsExactly(one[i]));
    }
}
