// SPDX-License-Identifier: MIT
// The checkpoints of the tasks of A0 to A3: one example for each formula.
#include "formulas/inertia.hpp"
#include "formulas/kinematics.hpp"
#include "formulas/pipeline.hpp"
#include "formulas/rotation.hpp"
#include "handouts/numbers.hpp"
#include "support/catch.hpp"

#include <numbers>

using namespace rigor;
using namespace rigor::handouts;

namespace {

Matrix3d quarter_turn_about_z()
{
    Matrix3d R;
    R << 0, -1, 0, 1, 0, 0, 0, 0, 1;
    return R;
}

std::vector<double> listed(const Quaternion& q)
{
    return {q.s, q.v.x(), q.v.y(), q.v.z()};
}

// The mass, and then the three moments.
std::vector<double> mass_and_moments(const MassProperties& of)
{
    return {of.mass, of.inertia(0, 0), of.inertia(1, 1), of.inertia(2, 2)};
}

} // namespace

TEST_CASE("A0: a checkpoint for the formula", "[numbers]")
{
    const Matrix3d I = Vector3d(1, 2, 3).asDiagonal();
    check_shown("A0", "has 28 J.", {kinetic_energy(2, {3, 0, 4}, I, {1, 1, 1})});
}

TEST_CASE("A1: a checkpoint for each formula of a point", "[numbers]")
{
    const Matrix3d R = quarter_turn_about_z();
    const Vector3d X(10, 20, 30), p(1, 0, 0), x = world_point(R, X, p);
    check_shown("A1", "the first row is $(0, -3, 2)$.",
                {cross_matrix({1, 2, 3})(0, 0), cross_matrix({1, 2, 3})(0, 1),
                 cross_matrix({1, 2, 3})(0, 2)});
    check_shown("A1", "takes $(1, 0, 0)$ to $(10, 21, 30)$.",
                {p.x(), p.y(), p.z(), x.x(), x.y(), x.z()});
    const Vector3d back = object_point(R, X, x);
    check_shown("A1", "take $(10, 21, 30)$ back to $(1, 0, 0)$.",
                {x.x(), x.y(), x.z(), back.x(), back.y(), back.z()});
    Matrix3d rate;
    rate << 1, -3, 2, 3, 1, -1, -2, 1, 1;
    check_shown("A1", "with the rows $(1, -3, 2)$, $(3, 1, -1)$ and $(-2, 1, 1)$", rows_of(rate));
    check_shown("A1", "the result is $(1, 2, 3)$.",
                listed(angular_velocity(rate, Matrix3d::Identity())));
    const Vector3d origin = Vector3d::Zero();
    check_shown("A1", "give $(-6, 0, 5)$.",
                listed(point_velocity({0, 0, 5}, {0, 0, 2}, origin, {0, 3, 0})));
    const Matrix36d S = velocity_modes(origin, {1, 2, 3});
    check_shown("A1", "the first row is $(1, 0, 0, 0, 3, -2)$.",
                {S(0, 0), S(0, 1), S(0, 2), S(0, 3), S(0, 4), S(0, 5)});
}

TEST_CASE("A1: a checkpoint for each formula of forces", "[numbers]")
{
    check_shown("A1", "has the torque $(0, 0, 4)$",
                listed(net_wrench({{{0, 2, 0}, {3, 0, 0}}}, {1, 0, 0}).torque));
    MatrixState state;
    state.angular_momentum = Vector3d(0, 0, 3);
    const MatrixStateRate rate =
        equations_of_motion(state, 0.5, Matrix3d::Identity(), {{4, 0, 0}, {0, 0, 5}});
    const Vector3d V_dot = rate.velocity_rate, L_dot = rate.angular_momentum_rate;
    check_shown("A1", R"($\dot V = (2, 0, 0)$, $\dot L = (0, 0, 5)$)",
                {V_dot.x(), V_dot.y(), V_dot.z(), L_dot.x(), L_dot.y(), L_dot.z()});
    check_shown("A1", "$(0, -3, 0)$ as the first row", listed(rate.rotation_rate.row(0)));
}

TEST_CASE("A2: a checkpoint for each formula of a tensor", "[numbers]")
{
    const Matrix3d R = quarter_turn_about_z();
    const Matrix3d box = Vector3d(13, 10, 5).asDiagonal(), other = Vector3d(1, 2, 4).asDiagonal();
    check_shown("A2", R"(it is $\mathrm{diag}(10, 13, 5)$.)",
                listed(world_inertia(R, box).diagonal()));
    check_shown("A2", R"(it is $\mathrm{diag}(2, 1, 4)$.)",
                listed(world_inverse_inertia(R, other).diagonal()));
    Matrix3d I;
    I << 2, 1, 0, 1, 2, 0, 0, 0, 4;
    check_shown("A2", "has the moments 1, 3 and 4.", listed(principal_axes(I).moments));
    check_shown("A2", "become 0, 0.5 and 0.25.", listed(invert_moments({0, 2, 4})));
}

TEST_CASE("A2: a checkpoint for each solid", "[numbers]")
{
    const MassProperties ball = solid_sphere(1, 1), ellipsoid = solid_ellipsoid(1, {1, 2, 3});
    check_shown("A2", "it has 4.188790 kg and the moments 1.675516.",
                {ball.mass, ball.inertia(0, 0)});
    check_shown("A2", "it has 12 kg and the moments 13, 10 and 5.",
                mass_and_moments(solid_box(2, {1, 2, 3})));
    check_shown("A2", "it has 6.283185 kg and the moments 3.665191, 3.141593 and 3.665191.",
                mass_and_moments(solid_cylinder(1, 1, 2)));
    check_shown("A2", "it has 25.132741 kg and $I_{xx} = 65.345127$.",
                {ellipsoid.mass, ellipsoid.inertia(0, 0)});
    check_shown("A2", "it has 6 kg and the moments 2, 0 and 2.", mass_and_moments(thin_rod(3, 2)));
    const MassProperties bounds = bounding_box_mass_properties({{0, 0, 0}, {1, 2, 3}}, 12);
    check_shown("A2", "have their center at $(0.5, 1, 1.5)$", listed(bounds.center_of_mass));
    check_shown("A2", "and the moments 13, 10 and 5.", listed(bounds.inertia.diagonal()));
}

TEST_CASE("A2: a checkpoint for each sum over particles", "[numbers]")
{
    std::vector<Particle> particles;
    for (int i = 0; i < 3; ++i)
        for (const double side : {1.0, -1.0})
            particles.push_back({0.5, side * (i + 1) * Vector3d::Unit(i)});
    check_shown("A2", "have 3 kg, and 13, 10 and 5 on the diagonal",
                mass_and_moments(particle_mass_properties(particles)));
    std::vector<DensitySample> samples;
    for (int i = 0; i < 8; ++i)
        samples.push_back(
            {{(i & 1) ? 0.25 : -0.25, (i & 2) ? 0.25 : -0.25, (i & 4) ? 0.25 : -0.25}, 12});
    const MassProperties grid = grid_mass_properties(samples, 0.5);
    const MassProperties sampled = sampled_mass_properties(samples, 1);
    check_shown("A2",
                "sampled at the centers of 8 cells, has 12 kg and the moments 1.5 instead of 2.",
                {double(samples.size()), grid.mass, grid.inertia(0, 0),
                 solid_box(12, {1, 1, 1}).inertia(0, 0)});
    check_shown("A2", "give 12 kg and 1.5 again.", {sampled.mass, sampled.inertia(0, 0)});
}

TEST_CASE("A3: a checkpoint for each formula of a matrix", "[numbers]")
{
    const double right = std::numbers::pi / 2;
    const Matrix3d step = advance_matrix(Matrix3d::Identity(), {0, 0, 1}, 0.1);
    check_shown("A3", "makes the first column $(1, 0.1, 0)$.", listed(step.col(0)));
    Matrix3d columns;
    columns << 3, 0, 1, 4, 5, 1, 0, 0, 1;
    check_shown("A3", "become $(0.6, 0.8, 0)$, $(-0.8, 0.6, 0)$ and $(0, 0, 1)$.",
                rows_of(gram_schmidt(columns).transpose()));
    check_shown("A3", "have the columns $(0, 1, 0)$, $(0, 0, 1)$ and $(1, 0, 0)$.",
                rows_of(euler_to_matrix({right, 0, right}).transpose()));
}

TEST_CASE("A3: a checkpoint for each formula of a quaternion", "[numbers]")
{
    const Quaternion half = {0.5, Vector3d::Constant(0.5)}, q = {0.8, {0, 0, 0.6}};
    const Vector3d w(0, 0, 2);
    check_shown("A3", "is $(1, (1, 1, 1))$.", listed(multiply({1, {1, 0, 0}}, {1, {0, 1, 0}})));
    check_shown("A3", "is $(1, (-2, -3, -4))$.", listed(conjugate({1, {2, 3, 4}})));
    check_shown("A3", "becomes $(0.6, (0, 0.8, 0))$.", listed(normalize({3, {0, 4, 0}})));
    check_shown("A3", "becomes $(3, 1, 2)$.", listed(rotate(half, {1, 2, 3})));
    check_shown("A3", "has the first column $(0.28, 0.96, 0)$.", listed(to_matrix(q).col(0)));
    check_shown("A3", "give $(-0.9, (1, 0.5, 1.2))$.", listed(quaternion_rate(q, {1, 2, 3})));
    check_shown("A3", "leads to $(0.540302, (0, 0, 0.841471))$.",
                listed(advance_exact(Quaternion(), w, 1)));
    check_shown("A3", "leads to $(0.707107, (0, 0, 0.707107))$.",
                listed(advance_linear(Quaternion(), w, 1)));
    check_shown("A3", "at 10 rad/s it is 0.157080 s.", {10, max_time_step({0, 0, 10})});
    const Wrench weight = gravity_wrench(2, {0, -9.81, 0});
    check_shown("A3", "the force $(0, -19.62, 0)$", listed(weight.force));
    CHECK(weight.torque.isZero(0));
}
