// SPDX-License-Identifier: MIT
// The checkpoints of A1 to A5 and A7 that have no derivation beside them.
#include "formulas/collision.hpp"
#include "formulas/contact.hpp"
#include "formulas/fracture.hpp"
#include "formulas/inertia.hpp"
#include "formulas/kinematics.hpp"
#include "formulas/rotation.hpp"
#include "handouts/numbers.hpp"
#include "support/catch.hpp"

#include <cmath>
#include <numbers>

using namespace rigor;
using namespace rigor::handouts;

TEST_CASE("A1: a checkpoint of six particles", "[numbers]")
{
    std::vector<Particle> particles;
    for (int i = 0; i < 3; ++i)
        for (const double side : {1.0, -1.0})
            particles.push_back({0.5, side * (i + 1) * Vector3d::Unit(i)});
    const Vector3d origin = Vector3d::Zero();
    const Wrench wrench = inertial_wrench(particles, origin, Vector3d(4, 5, 6), Vector3d(1, 2, 3));
    CHECK(wrench.force.norm() < 1e-14);
    check_shown("A1", "give the force 0 and the torque $(-30, 24, -6)$.",
                {wrench.force.norm(), wrench.torque.x(), wrench.torque.y(), wrench.torque.z()});
}

TEST_CASE("A2: checkpoints", "[numbers]")
{
    TriangleMesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    mesh.triangles = {{1, 2, 3}, {0, 2, 1}, {0, 3, 2}, {0, 1, 3}};
    const MassProperties solid = mesh_mass_properties(mesh, 1);
    const Vector3d X = solid.center_of_mass;
    // C = ½ Tr(I) δ - I, and the shift back to the origin
    const Matrix3d C = solid.inertia.trace() / 2 * Matrix3d::Identity() - solid.inertia;
    const Matrix3d second = C + solid.mass * X * X.transpose();
    check_shown("A2", "has $1/60$ on its diagonal and $1/120$ beside it.",
                {second(0, 0), second(0, 1)});
    check_shown("A2", "has $1/80$ on its diagonal and $1/480$ beside it.",
                {solid.inertia(0, 0), solid.inertia(0, 1)});

    MassProperties half = solid_box(12, {0.5, 1, 1}), other = half;
    half.center_of_mass.x() = 0.25;
    other.center_of_mass.x() = -0.25;
    const Vector3d m = half.inertia.diagonal();
    check_shown(
        "A2",
        "each with 6 kg, its center at $x = 0.25$ or $-0.25$ and the moments 1, 0.625 and "
        "0.625",
        {half.mass, half.center_of_mass.x(), other.center_of_mass.x(), m.x(), m.y(), m.z()});
    const MassProperties cube = combine(half, other);
    const Vector3d J = cube.inertia.diagonal();
    check_shown("A2", "give 12 kg and the moments 2, 2 and 2.", {cube.mass, J.x(), J.y(), J.z()});
}

TEST_CASE("A3: checkpoints", "[numbers]")
{
    const auto rates = euler_rates(Vector3d(0, std::numbers::pi / 4, 0), Vector3d(1, 0, 0));
    REQUIRE(rates);
    check_shown("A3", "needs the rates 1.414214 of roll, 0 of pitch and 1 of yaw", listed(*rates));

    const Vector3d J(13, 10, 5), w(1, 2, 3);
    BodyInertia box;
    box.inverse_mass = 1.0 / 12;
    box.inverse_inertia = J.cwiseInverse().asDiagonal();
    RigidState state;
    state.angular_momentum = J.cwiseProduct(w);
    const Quaternion q = step_symplectic_euler(state, box, {}, 0.1).orientation;
    check_shown("A3", "| 0.982946 | 0.049147 | 0.098295 | 0.147442 |",
                {q.s, q.v.x(), q.v.y(), q.v.z()});
}

TEST_CASE("A4: checkpoints", "[numbers]")
{
    LevelSet cell;
    cell.size = {2, 2, 2};
    cell.distances = {0, 0, 0, 0, 0, 0, 0, 8};
    const Vector3d p(0.5, 0.25, 0.75), n = level_set_normal(cell, p);
    check_shown("A4", "At $p = (1/2, 1/4, 3/4)$ the result is 0.75.",
                {p.x(), p.y(), p.z(), sample_level_set(cell, p)});
    check_shown("A4", "it is $(3/7, 6/7, 2/7)$.", listed(n));

    Matrix3d K;
    K << 3, 2, 2, 2, 4, 1, 2, 1, 2;
    const Vector3d up = Vector3d::UnitY(), v(2, -2, 0);
    check_shown("A4", "The impulse is $(-1.5, 1.5, 0)$.",
                listed(sliding_friction_impulse(K, v, up, 0.5, 1)));

    const Vector3d d = Vector3d(1, 1, 0).normalized(), X = d / 2;
    const Matrix3d I_inverse = 12 * (Matrix3d::Identity() - d * d.transpose());
    const Body rod = {1, I_inverse, X, Vector3d(0, -1, 0), Vector3d::Zero(), Vector3d::Zero()};
    const Body after = apply_impulse(rod, Vector3d::Zero(), Vector3d(0, 0.6, 0));
    check_shown("A4", "$X = (0.353553, 0.353553, 0)$", listed(X));
    check_shown("A4", "Then $L = (0, 0, -0.212132)$", listed(after.angular_momentum));
    const double ratio = after.angular_velocity.z() / after.angular_momentum.z();
    check_shown("A4", R"($\omega$ is 12 times that.)", {ratio});
}

TEST_CASE("A5: a checkpoint of two cubes", "[numbers]")
{
    Body cube;
    cube.inverse_mass = 1;
    cube.inverse_inertia = Vector3d(6, 6, 6).asDiagonal();
    cube.velocity = Vector3d(0, -1, 0);
    Body upper = cube;
    upper.position.y() = 1;
    std::vector<BodyContact> joints(2); // body 0 is the floor
    joints[0].body1 = 1;
    joints[0].point.y() = -0.5;
    joints[1].body1 = 2;
    joints[1].body2 = 1;
    joints[1].point.y() = 0.5;
    const ContactResult result = shock_propagation({Body(), cube, upper}, joints, {0, 1, 2}, 1);
    check_shown("A5", "The floor gives 1 N s and the lower cube gives 1 N s,",
                {result.impulses[0].y(), result.impulses[1].y()});
    CHECK(result.bodies[1].velocity.norm() + result.bodies[2].velocity.norm() < 1e-15);
}

TEST_CASE("A7: checkpoints of a cut and of two copies", "[numbers]")
{
    TetrahedralMesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    mesh.tetrahedra = {{0, 1, 2, 3}};
    const SplitMesh cut = split_element(mesh, 0, Vector3d(1, -1, 0).normalized());
    CHECK(cut.mesh.tetrahedra.size() == 2);
    CHECK(cut.mesh.vertices.size() == 8);
    for (const auto& t : cut.mesh.tetrahedra) {
        const auto& x = cut.mesh.vertices;
        const Vector3d a = x[t[1]] - x[t[0]], b = x[t[2]] - x[t[0]], c = x[t[3]] - x[t[0]];
        check_shown("A7", "two tetrahedra of $1/12$ m³ with eight vertices are left.",
                    {a.cross(b).dot(c) / 6});
    }

    const ElementCrack crack = {0, Vector3d(0.5, 0, 0), Vector3d(1, 1, 1).normalized()};
    const EmbeddedMesh copies = virtual_nodes(mesh, {crack});
    check_shown("A7", "has two copies with the shares 0.125 and 0.875 and eight vertices.",
                {copies.fractions[0], copies.fractions[1]});
    CHECK(copies.mesh.vertices.size() == 8);
    mesh.vertices.emplace_back(0, 0, -1);
    mesh.tetrahedra.push_back({0, 2, 1, 4});
    CHECK(virtual_nodes(mesh, {crack}).mesh.vertices.size() == 6);
}
