// SPDX-License-Identifier: MIT
// The numbers in the answers to the questions "Predict, then run".
#include "formulas/collision.hpp"
#include "formulas/contact.hpp"
#include "formulas/fracture.hpp"
#include "formulas/inertia.hpp"
#include "formulas/kinematics.hpp"
#include "formulas/plasticity.hpp"
#include "formulas/rotation.hpp"
#include "handouts/numbers.hpp"
#include "support/catch.hpp"

#include <cmath>
#include <numbers>

using namespace rigor;
using namespace rigor::handouts;

namespace {

Matrix3d turned_about_z(double angle)
{
    return euler_to_matrix(Vector3d(0, 0, angle));
}

// The spin that A1.4 finds from two pictures of a cube that turns at 5 rad/s.
double measured_spin(double apart)
{
    const Matrix3d R = Matrix3d::Identity();
    return angular_velocity((turned_about_z(5 * apart) - R) / apart, R).z();
}

} // namespace

TEST_CASE("A1: questions", "[numbers]")
{
    const std::vector<PointForce> couple = {{{0, 3, 0}, {2, 0, 0}}, {{0, -3, 0}, {0, 0, 0}}};
    for (const Vector3d& X : {Vector3d(0, 0, 0), Vector3d(5, -1, 2)})
        check_shown("A1", "it is 6 N m about every point", {net_wrench(couple, X).torque.z()});
    check_shown("A1", R"($\sin(2)/0.4 = 2.273244$ rad/s)", {5 * 0.4, 0.4, measured_spin(0.4)});
    check_shown("A1", "With pictures 0.1 s apart it finds 4.794255 rad/s",
                {0.1, measured_spin(0.1)});
}

TEST_CASE("A2: questions", "[numbers]")
{
    const Vector3d size(1, 2, 3);
    const MassProperties one = solid_box(1, size), two = solid_box(1, 2 * size);
    check_shown("A2", "grows by the factor 8,", {two.mass / one.mass});
    check_shown("A2", "The moments grow by the factor 32,",
                {two.inertia(0, 0) / one.inertia(0, 0)});

    MassProperties half = solid_box(12, {0.5, 1, 1}), other = half;
    half.center_of_mass.x() = -0.25;
    other.center_of_mass.x() = 0.25;
    const Matrix3d whole = combine(half, other).inertia;
    CHECK((whole - solid_box(12, {1, 1, 1}).inertia).norm() < 1e-14);
    check_shown("A2", "both have 1. About", {half.inertia(0, 0)});
    const double about_y = half.inertia(1, 1);
    check_shown("A2", "they have 0.625 each, which is 1.25 together instead of 2. The missing 0.75",
                {about_y, 2 * about_y, whole(1, 1), whole(1, 1) - 2 * about_y});

    // the error of a grid is 1/(6 n²) for n cells along an edge, that of samples 0.1054/√N
    const double n = 10, grid = 1 / (6 * n * n);
    check_shown("A2", "which is 3999 of them", {std::pow(0.1054 / grid, 2)});
}

TEST_CASE("A3: questions", "[numbers]")
{
    const Vector3d w(0, 0, 1);
    const Quaternion q = advance_linear(Quaternion(), w, 1);
    const double angle = 2 * std::atan2(q.v.norm(), q.s);
    check_shown("A3", "= 9.272952$ rad instead of 10", {10 * angle, 10});
    const Quaternion turned = advance_exact(Quaternion(), w, 2 * std::numbers::pi);
    CHECK(std::abs(turned.s + 1) < 1e-15); // the negative of the first one

    // λ² = ω² (J1 - J2)(J2 - J3)/(J1 J3) about the middle axis of the box
    const double growth = 2 * std::sqrt((13.0 - 10) * (10 - 5) / (13 * 5));
    check_shown("A3", R"(\exp(0.9608\, t))", {growth});
    check_shown("A3", "after about 38.3 s", {16 * std::log(10.0) / growth});
    check_shown("A3", "A quarter turn takes 0.157 s", {max_time_step(10 * w)});
}

TEST_CASE("A4: questions", "[numbers]")
{
    check_shown("A4", "0.015625 m: each bounce", {std::pow(0.5, 2 * 3)});
    // a ball of 1 kg slides at 7 m/s and is stopped at its lowest point
    const Matrix3d ball = Vector3d(3.5, 1, 3.5).asDiagonal();
    const Vector3d j = static_friction_impulse(ball, {7, 0, 0}, Vector3d::UnitY(), 0);
    check_shown("A4", "It rolls at 5 m/s", {7 + j.x()});

    const Vector3d X = Vector3d::Zero(), push = Vector3d::UnitY(), end(0.5, 0, 0);
    const Matrix3d I_inverse = Vector3d(0, 12, 12).asDiagonal(); // 1 kg and 1 m along x
    Body rod;
    rod.inverse_mass = 1;
    rod.inverse_inertia = I_inverse;
    const Body after = apply_impulse(rod, end, push);
    const auto speed = [&](const Vector3d& x) {
        return point_velocity(after.velocity, after.angular_velocity, X, x).y();
    };
    check_shown("A4", "moves at 4 m/s, the center at 1 m/s, and the other end at 2 m/s *backwards*",
                {speed(end), speed(X), -speed(-end)});
}

TEST_CASE("A5: questions", "[numbers]")
{
    constexpr int count = 10;
    std::vector<Body> bodies(1); // the floor
    std::vector<BodyContact> contacts;
    std::vector<std::vector<int>> rests_on(1);
    for (int i = 1; i <= count; ++i) {
        Body cube;
        cube.inverse_mass = 1;
        cube.inverse_inertia = 6 * Matrix3d::Identity();
        cube.position = Vector3d(0, i - 0.5, 0);
        cube.velocity = Vector3d(0, -1, 0);
        bodies.push_back(cube);
        BodyContact contact;
        contact.body1 = i;
        contact.body2 = i - 1;
        contact.point = Vector3d(0, i - 1, 0);
        contacts.push_back(contact);
    }
    const std::vector<Vector3d> all = resolve_simultaneously(bodies, contacts, 2000).impulses;
    check_shown("A5", "The floor 10 N s, and the fifth joint 5 N s", {all[0].y(), all[5].y()});
    for (int k = 1; k <= count; ++k)
        CHECK(std::abs(all[k - 1].y() - (11 - k)) < 1e-6);
    const std::vector<Vector3d> one = resolve_contacts(bodies, contacts, 1).impulses;
    check_shown("A5", "Of the 10 N s that the floor should give it gets 1 N s", {10, one[0].y()});

    // floor 0, cards 1 to 3 in a ring, block 4
    const std::vector<int> levels =
        contact_levels({{}, {0, 2}, {0, 3}, {0, 1}, {1}}, {true, false, false, false, false});
    CHECK(levels == std::vector<int>{0, 1, 1, 1, 2});
    check_shown("A5", "The floor 0, all three cards 1, and the block 2",
                {double(levels[0]), double(levels[1]), double(levels[4])});
}

TEST_CASE("A6: questions", "[numbers]")
{
    CHECK(von_mises_principal(-110e6, -110e6, -110e6) == 0);
    check_shown("A6", "is 1 times the pull", {von_mises_principal(1, 1, 0)});
    check_shown("A6", "it is 1.732051 times as much", {von_mises_principal(1, -1, 0)});
    const double springs_back = 250e6 / 200e9;
    check_shown("A6", "1.00375 m. The 0.00125 m that belong to 250 MPa",
                {1.005 - springs_back, springs_back, 250});
}

TEST_CASE("A7: questions", "[numbers]")
{
    CHECK(principal_stress(Vector3d(0, -100e6, 0).asDiagonal()).stress == 0);
    TetrahedralMesh corner;
    corner.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    corner.tetrahedra = {{0, 1, 2, 3}};
    const auto share = [&](const Vector3d& normal, const Vector3d& point) {
        const EmbeddedMesh cut = virtual_nodes(corner, {{0, point, normal.normalized()}});
        return cut.fractions.at(0);
    };
    check_shown("A7", "0.125 and 0.5. The first share",
                {share({1, 1, 1}, {0.5, 0, 0}), share({1, 1, 0}, {0.5, 0, 0})});
}

TEST_CASE("A8: the errors of right steps", "[numbers]")
{
    // the largest error of a step of x'' = -x over all starts with the amplitude 1, over h³
    using State = Eigen::Vector2d; // x and v
    const double h = 0.001;
    const auto largest = [h](const auto& step) {
        double worst = 0;
        for (double angle = 0; angle < std::numbers::pi; angle += 0.1) {
            const State s(std::cos(angle), std::sin(angle));
            const State exact(s[0] * std::cos(h) + s[1] * std::sin(h),
                              s[1] * std::cos(h) - s[0] * std::sin(h));
            worst = std::max(worst, (State(step(s)) - exact).norm() / std::pow(h, 3));
        }
        return worst;
    };
    const double midpoint = largest([h](const State& s) {
        return State(s[0] + h * (s[1] - h / 2 * s[0]), s[1] - h * (s[0] + h / 2 * s[1]));
    });
    const double verlet = largest([h](const State& s) {
        const double x = s[0] + h * s[1] - h * h / 2 * s[0];
        return State(x, s[1] - h / 2 * (s[0] + x));
    });
    const double trapezoid = largest([h](const State& s) {
        const double a = h / 2;
        return State(State((1 - a * a) * s[0] + 2 * a * s[1], (1 - a * a) * s[1] - 2 * a * s[0]) /
                     (1 + a * a));
    });
    check_shown("A8", "the midpoint method has 0.1667,", {midpoint});
    CHECK(verlet < midpoint + 1e-4);
    CHECK(trapezoid < midpoint);
}
