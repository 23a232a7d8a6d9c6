// SPDX-License-Identifier: MIT
// The checkpoints of the tasks of A4 to A7 that no other test of numbers has.
#include "formulas/collision.hpp"
#include "formulas/contact.hpp"
#include "formulas/fracture.hpp"
#include "formulas/plasticity.hpp"
#include "handouts/numbers.hpp"
#include "support/catch.hpp"

#include <cmath>

using namespace rigor;
using namespace rigor::handouts;

namespace {

constexpr double nearly = 1e-9; // away from the border of a cone

} // namespace

TEST_CASE("A4: a checkpoint for each formula", "[numbers]")
{
    const Vector3d up = Vector3d::UnitY(), d = Vector3d(1, 1, 0).normalized(), tip(0, 0, 0);
    Body wheel, other;
    wheel.velocity = Vector3d(1, 0, 0);
    wheel.angular_velocity = Vector3d(0, 0, 2);
    other.velocity = Vector3d(0.5, 0, 0);
    check_shown("A4", "the result is $(1.5, 0, 0)$.",
                listed(relative_velocity(wheel, other, {0, -0.5, 0})));

    const Matrix3d I_inverse = 12 * (Matrix3d::Identity() - d * d.transpose());
    const Matrix3d K = impulse_matrix(1, I_inverse, d / 2, tip);
    check_shown("A4", "the rows are $(2.5, -1.5, 0)$, $(-1.5, 2.5, 0)$ and $(0, 0, 4)$.",
                rows_of(K));
    check_shown("A4", "the rod on its tip gets $(0, 0.6, 0)$.",
                listed(frictionless_impulse(K, {0, -1, 0}, up, 0.5)));

    const Matrix3d ball = Vector3d(3.5, 1, 3.5).asDiagonal();
    const Vector3d v(3, -2, 0);
    check_shown("A4", "gets $(-6/7, 3, 0)$.", listed(static_friction_impulse(ball, v, up, 0.5)));
    check_shown("A4", R"(gets $(-0.3, 3, 0)$ with $\mu = 0.1$.)",
                {collision_impulse(ball, v, up, 0.5, 0.1).x(),
                 collision_impulse(ball, v, up, 0.5, 0.1).y(),
                 collision_impulse(ball, v, up, 0.5, 0.1).z(), 0.1});

    const Vector3d j(3, 4, 0);
    const double border = 3.0 / 4;
    CHECK(inside_friction_cone(j, up, border + nearly));
    CHECK_FALSE(inside_friction_cone(j, up, border - nearly));
    CHECK_FALSE(inside_friction_cone({0, -4, 0}, up, 1e6));
    check_shown("A4", R"(is inside from $\mu = 0.75$ on)", {border});

    std::vector<ContactPoint> contacts(3);
    for (std::size_t i = 0; i < 3; ++i)
        contacts[i].relative_velocity = Vector3d(0, i == 1 ? 1 : -1, 0);
    contacts[0].depth = 0.001;
    contacts[1].depth = 0.003;
    contacts[2].depth = 0.002;
    check_shown("A4", "the last one, with the index 2.",
                {double(deepest_approaching_point(contacts).value())});
}

TEST_CASE("A5: a checkpoint for each formula", "[numbers]")
{
    check_shown("A5", "for $N = 10$ and $k = 3$ it is $-0.6$.",
                {10, 3, contact_restitution(3, 10)});

    Body rod; // 1 kg and 2 m along x
    rod.inverse_mass = 1;
    rod.inverse_inertia = Vector3d(3, 0, 3).asDiagonal();
    rod.velocity = Vector3d(0, -1, 0);
    std::vector<BodyContact> ends(2);
    ends[0].point = Vector3d(-1, 0, 0);
    ends[1].point = Vector3d(1, 0, 0);
    ends[0].body2 = ends[1].body2 = 1;
    const auto impulses = resolve_contacts({rod, Body()}, ends, 1).impulses;
    check_shown("A5", "gets 0.25 N s at its left end and 0.375 N s at its right end.",
                {impulses[0].y(), impulses[1].y()});

    const std::vector<int> levels =
        contact_levels({{}, {0}, {1}, {0, 2}}, {true, false, false, false});
    check_shown("A5", "have the levels 0, 1, 2 and 3.",
                std::vector<double>(levels.begin(), levels.end()));
}

TEST_CASE("A6: a checkpoint for each formula", "[numbers]")
{
    const Matrix3d stress = Vector3d(3, 2, 1).asDiagonal();
    const Matrix3d strain = Vector3d(0.1, 0, 0).asDiagonal();
    check_shown("A6", "has 1, 0 and −1 on its diagonal.", listed(deviator(stress).diagonal()));
    check_shown("A6", "the principal stresses 3, 2 and 1 give 1.732051.",
                {3, 2, 1, von_mises_principal(3, 2, 1)});
    check_shown("A6", "the same stress gives 1.732051 again.", {von_mises_frobenius(stress)});
    check_shown("A6", "the same stress gives 1.732051 once more.", {von_mises(stress)});
    check_shown("A6", R"(give the stress $\mathrm{diag}(0.4, 0.2, 0.2)$.)",
                listed(isotropic_stress(strain, 2, 1).diagonal()));
    check_shown("A6", R"($\mathrm{diag}(0.1, 0, 0)$ give 0.2.)",
                {0.1, 0, 0, von_mises_from_strain(strain, 1)});
    check_shown("A6", "$G = E / 2.6$, gives 0.001625.", {2.6, yield_strain(250e6, 200e9 / 2.6)});
}

TEST_CASE("A7: a checkpoint for each formula of a stress", "[numbers]")
{
    const auto all = [](double s) { return Matrix3d(Matrix3d::Constant(s)); };
    const auto smooth = smooth_stress({all(1), all(4), all(1)}, {{1}, {0, 2}, {1}}, {1, 1, 2});
    check_shown("A7", "get 2.5, 1.75 and 2.", {smooth[0](0, 1), smooth[1](0, 1), smooth[2](0, 1)});

    Matrix3d difference, torsion = Matrix3d::Zero();
    difference << 2, -1, 0, -1, 2, -1, 0, -1, 2;
    const PrincipalStress largest = principal_stress(difference);
    const Vector3d e = largest.direction.x() > 0 ? largest.direction : -largest.direction;
    check_shown("A7", "has 3.414214 along $(0.5, -0.707107, 0.5)$,",
                {largest.stress, e.x(), e.y(), e.z()});

    torsion(0, 1) = torsion(1, 0) = 10;
    const Vector3d n = crack_plane(torsion, 9).value();
    check_shown("A7", "with the normal $(0.707107, 0.707107, 0)$", listed(n.x() > 0 ? n : -n));
    CHECK_FALSE(crack_plane(torsion, 11).has_value());

    const std::array<Vector3d, 4> corner = {Vector3d::Zero(), Vector3d::UnitX(), Vector3d::UnitY(),
                                            Vector3d::UnitZ()};
    const Vector3d normal(0.6, 0.8, 0), slanted = Vector3d::Ones().normalized();
    check_shown("A7", "is face 0 with 0.808290, a little before face 2 with 0.8.",
                {double(closest_face(corner, normal)), slanted.dot(normal), 2, normal.y()});
}
