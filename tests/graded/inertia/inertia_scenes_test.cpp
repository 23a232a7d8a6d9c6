// SPDX-License-Identifier: MIT
// A2.15: scenes whose bodies have known mass properties, and how these bodies fly.
#include "support/free_rotor.hpp"
#include "support/scene_run.hpp"

#include <cmath>

using namespace rigor;
using namespace rigor::testing;

namespace {

// Inertia of a box of edges s: M/12 (b² + c²), and so on.
Matrix3d box_inertia(double mass, const Vector3d& s)
{
    const Vector3d q = s.cwiseProduct(s);
    return Vector3d(mass / 12 * Vector3d(q.y() + q.z(), q.z() + q.x(), q.x() + q.y())).asDiagonal();
}

// Steiner's term: the inertia of a point mass at the offset d from the center.
Matrix3d point_inertia(double mass, const Vector3d& d)
{
    return mass * (d.squaredNorm() * Matrix3d::Identity() - d * d.transpose());
}

// The exact motion of a body that is one box.
FreeRotor rotor_of(const BodyDescription& body)
{
    const Vector3d size = std::get<Box>(body.parts[0].shape).size;
    const double m = body.parts[0].density * size.prod();
    return {box_inertia(m, size).diagonal(), body.angular_velocity};
}

constexpr const char* of_other_boxes =
    "the boxes of the scene have other sizes and densities than in its file";

} // namespace

TEST_CASE("inertia: a box of 1 by 2 by 3 m and 12 kg has the moments 13 10 and 5",
          "[A2.15][inertia][scene]")
{
    const Trajectory run = run_scene("a2-inertia/spinning_box");
    INFO("mass and inertia of the body, as the scene got them from your formulas");
    REQUIRE_THAT(run.bodies[0].mass, IsClose(12.0, Rounding(8)));
    REQUIRE_THAT(run.bodies[0].inertia,
                 IsClose(Matrix3d(Vector3d(13, 10, 5).asDiagonal()), Rounding(16)));
}

TEST_CASE("inertia: a free box tumbles as the exact solution does at fourth order",
          "[A2.15][inertia][scene]")
{
    INFO(of_other_boxes);
    const std::string changes = other_boxes("a2-inertia/spinning_box");
    std::vector<double> errors;
    for (const double h : {0.02, 0.01, 0.005}) {
        const Trajectory run = run_scene("a2-inertia/spinning_box", h, changes);
        const FreeRotor exact = rotor_of(run.scene.bodies[0]);
        const Eigen::Quaterniond q = exact.orientation(steps_of(run.frames.back()) * h);
        errors.push_back(angle_between(run.frames.back().bodies[0].orientation, {q.w(), q.vec()}));
    }
    check_order(errors, 4);
    check_at_most(errors.back(), 1e-6, "attitude error after 6 s at h = 0.005 [rad]");
}

TEST_CASE("inertia: the hammer is the union of handle and head", "[A2.15][inertia][scene]")
{
    INFO(of_other_boxes);
    const Trajectory run = run_scene("a2-inertia/hammer", {}, other_boxes("a2-inertia/hammer"));
    const std::vector<Part>& parts = run.scene.bodies[0].parts;
    double M = 0;
    Vector3d moment = Vector3d::Zero();
    for (const Part& part : parts) {
        const double m = part.density * std::get<Box>(part.shape).size.prod();
        M += m;
        moment += m * part.position;
    }
    const Vector3d X = moment / M;
    Matrix3d I = Matrix3d::Zero();
    for (const Part& part : parts) {
        const Vector3d size = std::get<Box>(part.shape).size;
        const double m = part.density * size.prod();
        I += box_inertia(m, size) + point_inertia(m, part.position - X);
    }
    INFO("mass, center and inertia of the body, as the scene got them from your formulas");
    REQUIRE_THAT(run.bodies[0].mass, IsClose(M, Rounding(16)));
    REQUIRE_THAT(run.bodies[0].center_of_mass, IsClose(X, Rounding(32)));
    REQUIRE_THAT(run.bodies[0].inertia, IsClose(I, Rounding(64)));
}

TEST_CASE("inertia: the hammer turns about its center of mass and that flies a parabola",
          "[A2.15][inertia][scene]")
{
    const Trajectory run = run_scene("a2-inertia/hammer");
    const RigidState& start = run.frames.front().bodies[0];
    const Vector3d g = run.scene.settings.gravity;
    for (const Frame& frame : run.frames) {
        const double t = steps_of(frame) * run.scene.time_step;
        CAPTURE(t);
        const double scale =
            start.position.norm() + start.velocity.norm() * t + g.norm() * t * t / 2;
        const double k = 16 * (1 + steps_of(frame));
        REQUIRE_THAT(
            frame.bodies[0].position,
            IsClose(start.position + t * start.velocity + t * t / 2 * g, Rounding(k, scale)));
        REQUIRE_THAT(frame.bodies[0].angular_momentum,
                     IsClose(start.angular_momentum, Rounding(16)));
    }
}

TEST_CASE("inertia: a plate about its middle axis turns over as the exact solution does",
          "[A2.15][inertia][scene]")
{
    std::vector<double> errors;
    for (const double h : {0.005, 0.0025, 0.00125}) {
        const Trajectory run = run_scene("a2-inertia/tumbling_plate", h);
        const FreeRotor exact = rotor_of(run.scene.bodies[0]);
        const Eigen::Quaterniond q = exact.orientation(steps_of(run.frames.back()) * h);
        errors.push_back(angle_between(run.frames.back().bodies[0].orientation, {q.w(), q.vec()}));
    }
    check_order(errors, 4);
}
