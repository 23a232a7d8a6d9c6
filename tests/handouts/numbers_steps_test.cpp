// SPDX-License-Identifier: MIT
// The small numbers beside the derivations of the handouts, and those of their checkpoints.
#include "formulas/collision.hpp"
#include "formulas/contact.hpp"
#include "formulas/fracture.hpp"
#include "formulas/kinematics.hpp"
#include "formulas/plasticity.hpp"
#include "formulas/rotation.hpp"
#include "handouts/numbers.hpp"
#include "support/catch.hpp"

#include <cmath>
#include <numbers>

using namespace rigor;
using namespace rigor::handouts;

TEST_CASE("A1: steps of the derivation", "[numbers]")
{
    const Vector3d X = Vector3d::Zero(), V = Vector3d::Zero(), w(0, 0, 2), x(0, 3, 0);
    check_shown("A1", "gets $(-6, 0, 0)$ besides $V$", listed(point_velocity(V, w, X, x)));
}

TEST_CASE("A2: the standard deviation of a sample", "[numbers]")
{
    // The standard deviation of y² + z²: in the ball ⟨y⁴⟩ = 3/35 and ⟨y² z²⟩ = 1/35, in the cube
    // ⟨y⁴⟩ = 1/80.
    const double mean = 2.0 / 5, square = 2 * 3.0 / 35 + 2 * 1.0 / 35;
    check_shown("A2", "it is 0.2619 in a ball", {std::sqrt(square - mean * mean)});
    check_shown("A2", "and 0.1054 in a cube", {std::sqrt(2 * (1.0 / 80 - 1.0 / 144))});
}

TEST_CASE("A3: how fast a symmetric top goes around its angular momentum", "[numbers]")
{
    const Vector3d w(2, 4, 6), J(0.04, 0.04, 0.02); // as in the scene symmetric_top
    check_shown("A3", "go around $L$ together, at 5.385 rad/s.",
                {J.cwiseProduct(w).norm() / J.x()});
}

TEST_CASE("A4: the rod that jams first", "[numbers]")
{
    // the upper end is behind the tip, which slides along x
    const auto K_at = [](double slope) {
        const Vector3d d(-std::cos(slope), std::sin(slope), 0);
        const Matrix3d I_inverse = 12 * (Matrix3d::Identity() - d * d.transpose());
        return impulse_matrix(1, I_inverse, d / 2, Vector3d::Zero());
    };
    const Vector3d n = Vector3d::UnitY(), T = Vector3d::UnitX();
    const auto jams_from = [&](double slope) {
        const Matrix3d K = K_at(slope);
        return n.dot(K * n) / n.dot(K * T);
    };
    const double angle = std::atan(2.0);
    check_shown("A4", "at 63.4349° above the floor, jams from $\\mu = 4/3$ on.",
                {angle * 180 / std::numbers::pi, jams_from(angle)});

    for (const double theta : {0.3, 0.9, 1.4}) {
        CAPTURE(theta);
        const Matrix3d K = K_at(theta);
        const double c = std::cos(theta), s = std::sin(theta), t = std::tan(theta);
        CHECK(std::abs(n.dot(K * n) - (1 + 3 * c * c)) < 1e-14);
        CHECK(std::abs(n.dot(K * T) - 3 * s * c) < 1e-14);
        CHECK(std::abs(jams_from(theta) - (4 + t * t) / (3 * t)) < 1e-12);
        CHECK(jams_from(theta) > jams_from(angle));
    }
}

TEST_CASE("A3: steps of the derivation", "[numbers]")
{
    // a third of a turn about (1, 1, 1)
    Quaternion third;
    third.s = 0.5;
    third.v = Vector3d::Constant(0.5);
    check_shown("A3", "it is $(0, 1, 0)$: the x axis", listed(to_matrix(third).col(0)));

    // Euler's equations of the box, near a spin of 2 rad/s about its middle axis
    const Vector3d J(13, 10, 5);
    const auto rate = [&](const Vector3d& w) {
        return Vector3d(-w.cross(Vector3d(J.cwiseProduct(w))));
    };
    const double of_x = rate({0, 2, 1}).x(), of_z = rate({1, 2, 0}).z();
    check_shown("A3",
                R"($13\, \dot\omega_x = 10\, \omega_z$ and $5\, \dot\omega_z = 6\, \omega_x$)",
                {J.x(), of_x, J.z(), of_z});
    const double square = of_x / J.x() * of_z / J.z();
    check_shown("A3", R"($\lambda = \sqrt{12/13} = 0.9608$ per second)",
                {square, std::sqrt(square)});
}

TEST_CASE("A6: steps of the derivation", "[numbers]")
{
    const Matrix3d stress = Vector3d(3, 2, 1).asDiagonal();
    check_shown("A6", "and half of their sum is 3.", {std::pow(von_mises_principal(3, 2, 1), 2)});
    check_shown("A6", "which is 3 too.", {std::pow(von_mises_frobenius(stress), 2)});

    const double E = 200e9, nu = 0.3, sigma_Y = 250e6;
    const double lambda = E * nu / ((1 + nu) * (1 - 2 * nu)), G = E / (2 * (1 + nu));
    Matrix3d plastic = Matrix3d::Zero(), total = Matrix3d::Zero();
    const auto stretched = [&](double e) {
        total(0, 0) = e;
        plastic = plastic_flow(plastic, isotropic_stress(total - plastic, lambda, G), sigma_Y, G);
    };
    stretched(0.005);
    const double mean = isotropic_stress(total - plastic, lambda, G).trace() / 3;
    check_shown("A6", "times $e$: 833.333333 MPa at 0.005.", {mean / 1e6, total(0, 0)});
    const double out = plastic(0, 0);
    check_shown("A6", "= 0.00225$. On the way back", {out});
    stretched(0);
    const double back = out - plastic(0, 0);
    check_shown("A6", "250 MPa times these two, 562500 and 291666.6667 J/m³",
                {sigma_Y / 1e6, sigma_Y * out, sigma_Y * back});
}

TEST_CASE("A1: checkpoints", "[numbers]")
{
    const Vector3d X = Vector3d::Zero(), V = Vector3d::Zero(), w(1, 2, 3), x(1, 0, 0);
    const Matrix3d block = generalized_mass({Particle{2, x}}, X).bottomRightCorner<3, 3>();
    CHECK(block.isDiagonal());
    check_shown("A1", "is diagonal, with 0, 2 and 2.", listed(block.diagonal()));
    const Vector3d v = point_velocity(V, w, X, x);
    const Matrix3d of_rotation = velocity_mode_rates(V, v).rightCols<3>();
    check_shown("A1", "$v = (0, 3, -2)$, as for the particle", listed(v));
    check_shown("A1", "gives $(-13, 2, 3)$.", listed(of_rotation * w));
}

TEST_CASE("A3: a checkpoint of a step of Buss", "[numbers]")
{
    const Vector3d J(13, 10, 5), w(1, 2, 3);
    BodyInertia box;
    box.inverse_mass = 1.0 / 12;
    box.inverse_inertia = J.cwiseInverse().asDiagonal();
    RigidState state;
    state.angular_momentum = J.cwiseProduct(w);
    const Vector3d w_dot = -box.inverse_inertia * w.cross(state.angular_momentum);
    const Vector3d turned = w_dot.cross(w);
    const double h = 0.1;
    const Vector3d W = w + h / 2 * w_dot + h * h / 12 * turned;
    check_shown("A3", "| −9.6 | −5.723077 | 7.015385 |", listed(turned));
    check_shown("A3", "| 1.107385 | 1.875231 | 3.065846 |", listed(W));
    const Quaternion q = step_buss(state, box, {}, h).orientation;
    const Quaternion by_hand = advance_exact(state.orientation, W, h);
    CHECK(std::abs(q.s - by_hand.s) + (q.v - by_hand.v).norm() < 1e-15);
}

TEST_CASE("A5: a checkpoint of two sweeps", "[numbers]")
{
    // 1 kg and 2 m along x
    Body rod;
    rod.inverse_mass = 1;
    rod.inverse_inertia = Vector3d(3, 0, 3).asDiagonal();
    rod.velocity = Vector3d(0, -1, 0);
    std::vector<BodyContact> ends(2);
    ends[0].point = Vector3d(-1, 0, 0);
    ends[1].point = Vector3d(1, 0, 0);
    for (BodyContact& end : ends)
        end.body2 = 1;
    const auto impulses = [&](int sweeps) {
        return resolve_simultaneously({rod, Body()}, ends, sweeps).impulses;
    };
    check_shown("A5", "| 1 | 0.25 | 0.375 |", {1, impulses(1)[0].y(), impulses(1)[1].y()});
    check_shown("A5", "| 2 | 0.4375 | 0.46875 |", {2, impulses(2)[0].y(), impulses(2)[1].y()});
    check_shown("A5", "They approach 0.5 N s each", {impulses(100)[0].y()});
}

TEST_CASE("A5: a rod that falls flat on its two ends", "[numbers]")
{
    // 1 kg and 2 m along x, one impulse after the other
    const Matrix3d I_inverse = Vector3d(0, 3, 3).asDiagonal();
    const Vector3d X(0, 0, 0), left(-1, 0, 0), right(1, 0, 0), up(0, 1, 0);
    Body rod{1, I_inverse, X, Vector3d(0, -1, 0), {0, 0, 0}, {0, 0, 0}};
    const auto speed = [&](const Vector3d& x) {
        return (rod.velocity + rod.angular_velocity.cross(x - X)).y();
    };
    const auto hit = [&](const Vector3d& x) {
        const Matrix3d K = impulse_matrix(1, I_inverse, X, x);
        const Vector3d j = frictionless_impulse(K, speed(x) * up, up, 0);
        rod = apply_impulse(rod, x, j);
        return j.y();
    };
    check_shown("A5", "moves that end by $4j$ and the other by $-2j$",
                {impulse_matrix(1, I_inverse, X, left)(1, 1), 1 + 3 * left.x() * right.x()});
    const double first = hit(left);
    check_shown("A5", "| 1/4 N s at the left end | 0 | −1.5 m/s |",
                {first, speed(left), speed(right)});
    const double second = hit(right);
    check_shown("A5", "| 1.5/4 N s at the right end | −0.75 m/s | 0 |",
                {second, speed(left), speed(right)});
}

TEST_CASE("A6: a checkpoint of one stretch", "[numbers]")
{
    const double E = 200e9, nu = 0.3, sigma_Y = 250e6;
    const double lambda = E * nu / ((1 + nu) * (1 - 2 * nu)), G = E / (2 * (1 + nu));
    const Matrix3d strain = Vector3d(0.005, 0, 0).asDiagonal();
    const Matrix3d plastic =
        plastic_flow(Matrix3d::Zero(), isotropic_stress(strain, lambda, G), sigma_Y, G);
    check_shown("A6", "0.00225 along x and −0.001125 along y and z",
                {plastic(0, 0), plastic(1, 1)});
}

TEST_CASE("A7: a checkpoint of two tetrahedra", "[numbers]")
{
    TetrahedralMesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
    mesh.tetrahedra = {{0, 1, 2, 3}, {4, 1, 3, 2}};
    const std::vector<MeshFace> cut = {MeshFace{0, 0}};
    const SplitMesh parts = split_along_faces(mesh, cut);
    check_shown("A7", "have 5 vertices. When this face is cut, they have 8.",
                {double(mesh.vertices.size()), double(parts.mesh.vertices.size())});
}
