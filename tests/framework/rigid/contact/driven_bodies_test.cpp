// SPDX-License-Identifier: MIT
#include "rigid/contact/driven_bodies.hpp"

#include "framework/rigid/contact/hand_made.hpp"
#include "support/seeds.hpp"

using namespace rigor;
using namespace rigor::testing;

namespace {

// A driven body 0 that body 1 touches from above at (1, 0, 0), and body 2 which touches nothing.
ContactProblem problem_with(const DriveVelocity& first, const DriveVelocity& mean,
                            const DriveVelocity& last, double h)
{
    ContactProblem problem;
    problem.time_step = h;
    problem.bodies.resize(3);
    problem.bodies[0].velocity = mean.linear;
    problem.bodies[0].angular_velocity = mean.angular;
    problem.bodies[1].inverse_mass = 1;
    problem.driven = {{0, first, mean, last}};
    ContactConstraint c;
    c.body1 = 1;
    c.body2 = 0;
    c.point = {1, 0, 0};
    c.normal = {0, 1, 0};
    problem.contacts.push_back(c);
    Island island;
    island.bodies = {1};
    island.pairs = {{0, 1}};
    problem.islands = {island};
    return problem;
}

} // namespace

TEST_CASE("driven bodies: along the normal the mean counts and along the surface the end",
          "[rigid]")
{
    const DriveVelocity mean{{1, 2, 3}, {0, 0, 0}}, last{{4, 5, 6}, {0, 0, 0}};
    ContactProblem problem = problem_with(mean, mean, last, 0.01);
    set_velocities_at_end(problem, problem.islands[0], problem.bodies);
    CHECK_THAT(problem.bodies[0].velocity, IsClose(Vector3d(4, 2, 6), Rounding(8)));
    reset_velocities(problem, problem.islands[0]);
    CHECK(problem.bodies[0].velocity == Vector3d(1, 2, 3));
}

// What stands on a turntable has moved on by the end of the step, and the velocity of the surface
// there is that of the same place turned by h ω, to second order in h ω.
TEST_CASE("driven bodies: a turntable carries its points round", "[rigid]")
{
    for (const double h : {0.01, 0.001}) {
        const Vector3d w(0, 2, 0);
        ContactProblem problem = problem_with({{0, 0, 0}, w}, {{0, 0, 0}, w}, {{0, 0, 0}, w}, h);
        problem.bodies[1].velocity = w.cross(Vector3d(1, 0, 0));
        set_velocities_at_end(problem, problem.islands[0], problem.bodies);
        const Vector3d v = problem.bodies[0].velocity + w.cross(Vector3d(1, 0, 0));
        const Vector3d carried = rotation_matrix(turn(w, 2 * h)) * w.cross(Vector3d(1, 0, 0));
        CHECK_THAT(v, IsClose(carried, Order(2 * (2 * h) * (2 * h))));
    }
}

// The fall that gravity adds to a body at rest on a turning one, and any other motion away from it
// or towards it, does not move the contact over its surface.
TEST_CASE("driven bodies: a motion along the normal carries nothing", "[rigid]")
{
    const Vector3d w(0, 0, 5);
    ContactProblem problem = problem_with({{0, 0, 0}, w}, {{0, 0, 0}, w}, {{0, 0, 0}, w}, 0.01);
    const std::vector<Body> first = problem.bodies; // body 1 at rest
    problem.bodies[1].velocity = {0, -0.0981, 0};
    for (const double v_n : {0., 2., -3.}) {
        std::vector<Body> moving = first;
        moving[1].velocity = w.cross(Vector3d(1, 0, 0)) + Vector3d(0, v_n, 0);
        set_velocities_at_end(problem, problem.islands[0], moving);
        CHECK_THAT(problem.bodies[0].velocity.x(), IsClose(-0.01 * 5 * 5, Rounding(8)));
        reset_velocities(problem, problem.islands[0]);
    }
}

TEST_CASE("driven bodies: where nothing touches one its velocity stays", "[rigid]")
{
    const DriveVelocity mean{{1, 2, 3}, {0, 1, 0}}, last{{4, 5, 6}, {0, 1, 0}};
    ContactProblem problem = problem_with(mean, mean, last, 0.01);
    set_velocities_at_end(problem, Island(), problem.bodies);
    CHECK(problem.bodies[0].velocity == mean.linear);
}

namespace {

// The problem of `problem_with` with a driven body that moves along y, in its moving frame. Body 1
// has the velocity v at the start.
ContactProblem in_frame(double first, double mean, double last, double v)
{
    const auto along_y = [](double speed) { return DriveVelocity{{0, speed, 0}, {0, 0, 0}}; };
    ContactProblem problem = problem_with(along_y(first), along_y(mean), along_y(last), 0.01);
    problem.bodies[1].velocity = {7, v, 0};
    enter_moving_frames(problem);
    return problem;
}

} // namespace

TEST_CASE("driven bodies: in the frame a body keeps its velocity relative to the driven one",
          "[rigid]")
{
    const ContactProblem problem = in_frame(2, 3, 5, 2.5);
    const MovingFrame& frame = problem.islands[0].frame;
    CHECK(frame.mean_minus_first == Vector3d(0, 1, 0));
    CHECK(frame.last_minus_mean == Vector3d(0, 2, 0));
    CHECK(frame.change() == Vector3d(0, 3, 0));
    CHECK(problem.bodies[1].velocity == Vector3d(7, 3 + 0.5, 0)); // mean + (2.5 - first)
    CHECK(problem.bodies[0].velocity == Vector3d(0, 3, 0));
    CHECK(problem.contacts[0].force_speed == -1); // the part of the fictitious force in v'
}

TEST_CASE("driven bodies: with a constant velocity the world is the frame", "[rigid]")
{
    for (const double error : {0., 4e-16}) { // also up to rounding
        const ContactProblem problem = in_frame(3, 3 + error, 3, 2.5);
        CHECK(problem.islands[0].frame.is_world());
        CHECK(problem.bodies[1].velocity == Vector3d(7, 2.5, 0));
    }
}

// Body 2 is static: a wall on the other side of body 1, or the floor below it.
TEST_CASE("driven bodies: between a piston and a wall there is no frame for both", "[rigid]")
{
    for (const bool is_wall : {true, false}) {
        CAPTURE(is_wall);
        const DriveVelocity first{{0, 2, 0}, {0, 0, 0}}, mean{{0, 3, 0}, {0, 0, 0}},
            last{{0, 5, 0}, {0, 0, 0}};
        ContactProblem problem = problem_with(first, mean, last, 0.01);
        ContactConstraint c = problem.contacts[0];
        c.body2 = 2;
        c.normal = is_wall ? Vector3d(0, -1, 0) : Vector3d(1, 0, 0);
        problem.contacts.push_back(c);
        problem.islands[0].pairs.push_back({1, 2});
        enter_moving_frames(problem);
        CHECK(problem.islands[0].frame.is_world() == is_wall);
        if (is_wall) continue;

        const Vector3d y(0, 1, 0);
        set_velocities_at_start(problem, problem.islands[0]);
        CHECK(problem.bodies[2].velocity == y); // 0 + mean - first
        CHECK(problem.bodies[0].velocity == 3 * y);
        reset_velocities(problem, problem.islands[0]);
        CHECK(problem.bodies[2].velocity == 0 * y);
        set_velocities_at_end(problem, problem.islands[0], problem.bodies);
        CHECK(problem.bodies[2].velocity == -2 * y); // 0 - (last - mean)
        CHECK(problem.bodies[0].velocity == 3 * y);
    }
}

TEST_CASE("driven bodies: a frame that holds nothing is left", "[rigid]")
{
    for (const bool holds : {true, false}) {
        CAPTURE(holds);
        ContactProblem problem = in_frame(2, 3, 5, 2.5);
        std::vector<Body> first = problem.bodies;
        if (holds) problem.contacts[0].collision_impulse = {0, 1, 0};
        leave_unheld_frames(problem, first);
        CHECK(problem.islands[0].frame.is_world() != holds);
        if (holds) continue;
        CHECK(first[1].velocity == Vector3d(7, 2.5, 0));
        CHECK(problem.bodies[1].velocity == Vector3d(7, 3.5 + 2, 0));
        CHECK(problem.contacts[0].force_speed == 0);
    }
}

TEST_CASE("driven bodies: all frames are left after the step", "[rigid]")
{
    ContactProblem problem = in_frame(2, 3, 5, 2.5);
    std::vector<Body> first = problem.bodies;
    problem.contacts[0].collision_impulse = {0, 1, 0};
    leave_moving_frames(problem, first);
    CHECK(problem.islands[0].frame.is_world());
    CHECK(problem.bodies[1].velocity == Vector3d(7, 3.5 + 2, 0));
    CHECK(problem.contacts[0].force_speed == 0);
}
