// SPDX-License-Identifier: MIT
// The worked numbers of the handouts, each computed by the formulas. A quote must stand in the
// handout, and each number in it must be right to its last digit.
#include "formulas/collision.hpp"
#include "formulas/contact.hpp"
#include "formulas/fracture.hpp"
#include "formulas/inertia.hpp"
#include "formulas/kinematics.hpp"
#include "formulas/plasticity.hpp"
#include "formulas/rotation.hpp"
#include "handouts/handouts.hpp"
#include "handouts/numbers.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

#include <cmath>
#include <numbers>

using namespace rigor;
using namespace rigor::handouts;

TEST_CASE("A1: the six particles that turn", "[numbers]")
{
    const Vector3d w(1, 2, 3), X = Vector3d::Zero(), V = Vector3d::Zero();
    std::vector<Particle> particles;
    for (int i = 0; i < 3; ++i)
        for (const double side : {1.0, -1.0})
            particles.push_back({0.5, side * (i + 1) * Vector3d::Unit(i)});
    const Matrix3d I = particle_mass_properties(particles).inertia;
    check_shown("A1", "| diagonal, with 13, 10 and 5 |", listed(I.diagonal()));
    CHECK(I.isDiagonal());
    check_shown("A1", "| $(13, 20, 15)$ |", listed(I * w));

    std::vector<Vector3d> torques;
    Matrix3d D = Matrix3d::Zero();
    for (int i = 0; i < 6; i += 2) {
        const std::vector<Particle> pair = {particles[i], particles[i + 1]};
        torques.push_back(inertial_wrench(pair, X, V, w).torque);
    }
    for (const auto& [m, x] : particles) {
        const Vector3d v = point_velocity(V, w, X, x);
        D += m * cross_matrix(X - x).transpose() * cross_matrix(V - v);
    }
    check_shown("A1", "| $(-13, 2, 3)$ |", listed(w.cross(w.cross(particles[0].position))));
    check_shown("A1", "| $(0, -3, 2)$ |", listed(torques[0]));
    check_shown("A1", "| $(24, 0, -8)$ |", listed(torques[1]));
    check_shown("A1", "| $(-54, 27, 0)$ |", listed(torques[2]));
    check_shown("A1", "| $(-30, 24, -6)$ |", listed(torques[0] + torques[1] + torques[2]));
    check_shown("A1", "| $(-30, 24, -6)$ |", listed(w.cross(I * w)));
    check_shown("A1", R"(0 & 12 & -18 \\ -3 & 0 & 9 \\ 2 & -4 & 0)", rows_of(D));
    check_shown("A1", R"(0 & 9 & -16 \\ 9 & 0 & 5 \\ -16 & 5 & 0)", rows_of(D + D.transpose()));
    check_shown("A1", R"(-30 \\ 24 \\ -6)", listed(D * w));
    check_shown("A1", R"(-30 \\ 24 \\ -6)", listed((D + D.transpose()) * w));
    check_shown("A1", "(30/13, -2.4, 1.2)", listed(-I.inverse() * w.cross(I * w)));
}

namespace {

constexpr double hammer_density = 750;
const Vector3d handle_size(0.12, 1.4, 0.12), head_size(0.7, 0.28, 0.28), head_center(0, 0.84, 0);

TriangleMesh box_mesh(const Vector3d& size, const Vector3d& center)
{
    TriangleMesh mesh;
    for (int c = 0; c < 8; ++c) {
        const Vector3d side((c & 1) ? 0.5 : -0.5, (c & 2) ? 0.5 : -0.5, (c & 4) ? 0.5 : -0.5);
        mesh.vertices.push_back(center + size.cwiseProduct(side));
    }
    for (const std::array<int, 4>& face : {std::array{0, 4, 6, 2},
                                           {1, 3, 7, 5},
                                           {0, 1, 5, 4},
                                           {2, 6, 7, 3},
                                           {0, 2, 3, 1},
                                           {4, 5, 7, 6}}) {
        mesh.triangles.push_back({face[0], face[1], face[2]});
        mesh.triangles.push_back({face[0], face[2], face[3]});
    }
    return mesh;
}

TriangleMesh hammer_mesh()
{
    TriangleMesh mesh = box_mesh(handle_size, Vector3d::Zero());
    const TriangleMesh head = box_mesh(head_size, head_center);
    for (const auto& [i, j, k] : head.triangles)
        mesh.triangles.push_back({i + 8, j + 8, k + 8});
    mesh.vertices.insert(mesh.vertices.end(), head.vertices.begin(), head.vertices.end());
    return mesh;
}

double density_at(const Vector3d& p)
{
    const auto is_in = [&](const Vector3d& size, const Vector3d& center) {
        return ((p - center).cwiseAbs().array() <= size.array() / 2).all();
    };
    return is_in(handle_size, Vector3d::Zero()) || is_in(head_size, head_center) ? hammer_density
                                                                                 : 0;
}

const Vector3d hammer_low(-0.35, -0.7, -0.14), hammer_extent(0.7, 1.68, 0.28);

MassProperties hammer_by_grid(double h)
{
    std::vector<DensitySample> samples;
    const Eigen::Vector3i count = (hammer_extent / h).array().round().cast<int>();
    for (int i = 0; i < count.x(); ++i)
        for (int j = 0; j < count.y(); ++j)
            for (int k = 0; k < count.z(); ++k) {
                const Vector3d p = hammer_low + h * Vector3d(i + 0.5, j + 0.5, k + 0.5);
                samples.push_back({p, density_at(p)});
            }
    return grid_mass_properties(samples, h);
}

MassProperties hammer_by_samples(int count)
{
    testing::Random random(1);
    std::vector<DensitySample> samples;
    for (int i = 0; i < count; ++i) {
        const Vector3d share = (random.vector() + Vector3d::Ones()) / 2;
        const Vector3d p = hammer_low + share.cwiseProduct(hammer_extent);
        samples.push_back({p, density_at(p)});
    }
    return sampled_mass_properties(samples, hammer_extent.prod());
}

std::string row_of(const std::string& method, const MassProperties& of)
{
    char text[200];
    std::snprintf(text, sizeof text, "| %s | %.3f | %.3f | %.3f | %.3f | %.3f |", method.c_str(),
                  of.mass, of.center_of_mass.y(), of.inertia(0, 0), of.inertia(1, 1),
                  of.inertia(2, 2));
    return text;
}

} // namespace

TEST_CASE("A2: the hammer by four methods", "[numbers]")
{
    const TriangleMesh mesh = hammer_mesh();
    const MassProperties exact = mesh_mass_properties(mesh, hammer_density);
    const std::string text = in_one_line(content(assignments() / "a2-inertia" / "README.md"));
    for (const std::string& row :
         {row_of("exact, by the mesh", exact),
          row_of("grid that fits, cells of 0.02 m", hammer_by_grid(0.02)),
          row_of("grid that does not fit, cells of 0.035 m", hammer_by_grid(0.035)),
          row_of("Monte Carlo, 10000 samples", hammer_by_samples(10000)),
          row_of("bounding box", bounding_box_mass_properties(mesh.vertices, exact.mass))}) {
        CAPTURE(row);
        CHECK(text.find(row) != std::string::npos);
    }
    // the mesh is the union of two boxes
    MassProperties head = solid_box(hammer_density, head_size);
    head.center_of_mass = head_center;
    const MassProperties both = combine(solid_box(hammer_density, handle_size), head);
    CHECK((both.inertia - exact.inertia).norm() < 1e-12 * both.inertia.norm());
}

TEST_CASE("A3: drift and lag of the simple updates", "[numbers]")
{
    const Vector3d w(0, 0, 1);
    const Matrix3d Q = gram_schmidt(advance_matrix(Matrix3d::Identity(), w, 0.1));
    check_shown("A3", "= 0.0997$ instead of 0.1,", {std::atan2(Q(1, 0), Q(0, 0)), 0.1});
    const auto angle = [&](double h) {
        const Quaternion q = advance_linear(Quaternion(), w, h);
        return 2 * std::atan2(q.v.norm(), q.s);
    };
    check_shown("A3", "0.09992 instead of 0.1, and 0.9273 instead of 1.",
                {angle(0.1), 0.1, angle(1), 1});
}

TEST_CASE("A4: impulses on a rod and on a ball", "[numbers]")
{
    const Vector3d up = Vector3d::UnitY();
    // the rod falls at 45° on its tip
    const Vector3d d = Vector3d(1, 1, 0).normalized(), X = d / 2;
    const Matrix3d I_inverse = 12 * (Matrix3d::Identity() - d * d.transpose());
    const Body rod = {1, I_inverse, X, Vector3d(0, -1, 0), Vector3d::Zero(), Vector3d::Zero()};
    const Matrix3d K = impulse_matrix(1, I_inverse, X, Vector3d::Zero());
    check_shown("A4", "$n^T K n = 2.5$", {up.dot(K * up)});
    const Vector3d j = frictionless_impulse(K, rod.velocity, up, 0.5);
    const Body after = apply_impulse(rod, Vector3d::Zero(), j);
    check_shown("A4", "= 0.6$: the center", {j.y()});
    check_shown("A4", "still falls at 0.4 m/s", {-after.velocity.y()});
    check_shown("A4", "spins at 2.54558441227157 rad/s", {after.angular_velocity.norm()});

    // a ball of 1 kg that hits at an angle
    const Matrix3d ball = Vector3d(3.5, 1, 3.5).asDiagonal();
    const Vector3d v(3, -2, 0);
    const Vector3d sticks = collision_impulse(ball, v, up, 0.5, 2.0 / 7 + 1e-9);
    const Vector3d slides = collision_impulse(ball, v, up, 0.5, 0.1);
    check_shown("A4", "along the floor at 2.142857142857143 m/s, and up at 1 m/s",
                {v.x() + sticks.x(), v.y() + sticks.y()});
    check_shown("A4", "along the floor at 2.7 m/s", {v.x() + slides.x()});
}

TEST_CASE("A4: friction that jams and friction that adds energy", "[numbers]")
{
    Matrix3d K;
    K << 3, 2, 2, 2, 4, 1, 2, 1, 2;
    const Vector3d up = Vector3d::UnitY(), v(2, -2, 0);
    check_shown("A4", R"(3 & 2 & 2 \\ 2 & 4 & 1 \\ 2 & 1 & 2)", rows_of(K));
    check_shown("A4", "j = (-4, 2, 3)", listed(static_friction_impulse(K, v, up, 0.5)));
    check_shown("A4", "j = (-3.2, 2, 2.4)", listed(collision_impulse(K, v, up, 0.5, 2)));
    const Vector3d jammed = collision_impulse(K, v, up, 0.5, 2), separates = v + K * jammed;
    check_shown("A4", "$v + K j$ is $(1.2, 2, 0.4)$", listed(separates));
    check_shown("A4", "separate at 2 m/s and not at 1 m/s", {separates.y(), -0.5 * v.y()});
    check_shown("A4", "they lose 4.64 J.", {-jammed.dot(v + separates) / 2});
    const Vector3d huge = collision_impulse(K, v, up, 0.5, 1.999);
    check_shown("A4", "$j_n = 1500$ N s, and the bodies gain $8.982",
                {huge.y(), huge.dot(v + K * huge / 2) / 1e6});
    const Vector3d j = collision_impulse(K, v, up, 0, 1.75);
    check_shown("A4", "$j = (-7, 4, 0)$", listed(j));
    check_shown("A4", "which is $-22 + 49.5 = 27.5$ J",
                {j.dot(v), j.dot(K * j) / 2, j.dot(v + K * j / 2)});

    Matrix3d K2;
    K2 << 6, 2, -3, 2, 3, 0, -3, 0, 2;
    check_shown("A4", "$(6, 2, -3)$, $(2, 3, 0)$ and $(-3, 0, 2)$", rows_of(K2));
    const Vector3d v2(1, -1, 0), shortened = collision_impulse(K2, v2, up, 0, 1.5);
    check_shown("A4", "The sticking impulse $(-10, 7, -15)$ is shortened",
                listed(static_friction_impulse(K2, v2, up, 0)));
    check_shown(
        "A4", "shortened to $(-5.824, 7, -8.737)$, and this adds 4.577 J.",
        {shortened.x(), shortened.y(), shortened.z(), shortened.dot(v2 + K2 * shortened / 2)});

    // The rod whose center falls straight down: the tip moves with (1.5, -2.5) m/s.
    const Vector3d d = Vector3d(1, 1, 0).normalized(), X = d / 2, tip(1.5, -2.5, 0);
    const Matrix3d I_inverse = 12 * (Matrix3d::Identity() - d * d.transpose());
    // v = V + ω × (0 - X) with V = (0, V_y, 0): ω_z X_y = 1.5 and V_y - ω_z X_x = -2.5
    const double w = tip.x() / X.y();
    const Vector3d V(0, tip.y() + w * X.x(), 0);
    const Body rod = {1, I_inverse, X, V, Vector3d(0, 0, w), Vector3d(0, 0, w / 12)};
    const auto energy = [](const Body& body) {
        return body.velocity.squaredNorm() / 2 + body.angular_velocity.squaredNorm() / 24;
    };
    const Matrix3d K_rod = impulse_matrix(1, I_inverse, X, Vector3d::Zero());
    // K does not couple z with the other directions.
    const Vector3d bounce = collision_impulse(K_rod, tip, up, 1, 100);
    const Body after = apply_impulse(rod, Vector3d::Zero(), bounce);
    check_shown("A4",
                "spin at 4.242641 rad/s about z while its center falls straight down at 1 m/s",
                {w, -V.y()});
    check_shown("A4", "1.25 J become 1.953125 J", {energy(rod), energy(after)});
    const double least_friction = bounce.x() / bounce.y();
    check_shown("A4", "$(0.9375, 2.5625)$ N s", {bounce.x(), bounce.y()});
    check_shown("A4", R"($\mu = 15/41 = 0.366$ on)", {least_friction, least_friction});
}

TEST_CASE("A4: what deepest point and first point miss", "[numbers]")
{
    check_shown("A4", "40 m/s and 60 steps a second, a plate moves 0.667 m", {40, 60, 40.0 / 60});
    // A fall of √(2/g), then bounces that together take twice that time, each half as long as the
    // one before.
    const double fall = std::sqrt(2 / 9.81);
    check_shown("A4", "lies still after 1.354571 s", {fall * (1 + 2 * 0.5 / (1 - 0.5))});
}

TEST_CASE("A5: what a flat rod keeps", "[numbers]")
{
    const Matrix3d I_inverse = Vector3d(3, 0, 3).asDiagonal(); // 1 kg and 2 m along x
    const Vector3d left(-1, 0, 0), right(1, 0, 0);
    const Body rod = {
        1, I_inverse, Vector3d::Zero(), Vector3d(0, -1, 0), Vector3d::Zero(), Vector3d::Zero()};
    std::vector<BodyContact> ends(2);
    ends[0].point = left;
    ends[1].point = right;
    for (BodyContact& end : ends)
        end.body2 = 1;
    const auto kept = [&](int n, const Vector3d& x) {
        const Body after = resolve_contacts({rod, Body()}, ends, n).bodies[0];
        return -point_velocity(after.velocity, after.angular_velocity, after.position, x).y();
    };
    check_shown("A5", "| 0.75 | 0.515625 | 0.0162932134 |",
                {kept(1, left), kept(2, left), kept(10, left)});
    // with the right end first the ends change places
    std::swap(ends[0], ends[1]);
    CHECK(std::abs(kept(1, right) - 0.75) < 1e-15);
}

TEST_CASE("A6: a piece of steel", "[numbers]")
{
    const double E = 200e9, nu = 0.3, sigma_Y = 250e6;
    const double lambda = E * nu / ((1 + nu) * (1 - 2 * nu)), G = E / (2 * (1 + nu));
    check_shown("A6", "| 0.001625 |", {yield_strain(sigma_Y, G)});
    // the strain of a bar that is pulled to its yield stress
    const Vector3d bar = sigma_Y / E * Vector3d(1, -nu, -nu);
    const Matrix3d strain = bar.asDiagonal();
    const double of_deviator = std::sqrt(1.5) * deviator(strain).norm();
    check_shown("A6", "For the steel below these are 0.00125 and 0.001625.",
                {bar.x(), of_deviator});
    CHECK(std::abs(of_deviator - (1 + nu) * bar.x()) < 1e-15);
    check_shown("A6", "bears 144.337567 MPa of shear", {sigma_Y / std::sqrt(3.0) / 1e6});

    Matrix3d plastic = Matrix3d::Zero(), total = Matrix3d::Zero();
    const auto stretched = [&](double e) {
        total(0, 0) = e;
        const Matrix3d trial = isotropic_stress(total - plastic, lambda, G);
        plastic = plastic_flow(plastic, trial, sigma_Y, G);
        return Matrix3d(isotropic_stress(total - plastic, lambda, G) / 1e6);
    };
    const Matrix3d first = stretched(0.001625), out = stretched(0.005), back = stretched(0);
    check_shown("A6", "| 0.001625 | 437.5 | 187.5 |", {0.001625, first(0, 0), first(1, 1)});
    check_shown("A6", "| 0.005 | 1000 | 750 |", {0.005, out(0, 0), out(1, 1)});
    check_shown("A6", "| −166.666667 | +83.333333 |", {back(0, 0), back(1, 1)});
}

TEST_CASE("A7: the second difference", "[numbers]")
{
    Matrix3d stress;
    stress << 2, -1, 0, -1, 2, -1, 0, -1, 2;
    CHECK(std::abs(principal_stress(stress).stress - (2 + std::numbers::sqrt2)) < 1e-14);
    CHECK(in_one_line(content(assignments() / "a7-fracture" / "README.md"))
              .find(R"($\sigma_1 = 2 + \sqrt2$ along $(1, -\sqrt2, 1)/2$)") != std::string::npos);
}
