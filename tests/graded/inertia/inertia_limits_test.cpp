// SPDX-License-Identifier: MIT
// A2: inputs at the limits of the formulas: moments at their threshold in any order, tensors that
// are nearly diagonal, bodies of very different mass.
#include "formulas/inertia.hpp"
#include "support/close.hpp"
#include "support/random.hpp"
#include "support/seeds.hpp"

#include <algorithm>

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("inertia: the largest moment decides wherever it stands", "[A2.5][inertia]")
{
    for (Random random : seeds(30)) {
        const double largest = random.mass();
        const double shares[3] = {1, random.uniform(0.1, 0.9), 0};
        for (const double share : {0.9e-12, 1.1e-12, 1e-11, 1e-9, 1e-6}) {
            int order[3] = {0, 1, 2};
            do {
                Vector3d moments, expected;
                for (int i = 0; i < 3; ++i) {
                    moments[i] = largest * (order[i] == 2 ? share : shares[order[i]]);
                    expected[i] = order[i] == 2 && share < 1e-12 ? 0 : 1 / moments[i];
                }
                CAPTURE(moments);
                const Vector3d found = invert_moments(moments);
                for (int i = 0; i < 3; ++i)
                    REQUIRE_THAT(found[i], IsClose(expected[i], Rounding(8)));
            } while (std::next_permutation(order, order + 3));
        }
    }
}

TEST_CASE("inertia: a moment just beside the threshold", "[A2.5][inertia]")
{
    // with a power of two, 1e-12 times the largest moment is exact
    for (const int power : {-200, -1, 0, 1, 200})
        for (int k = 1; k <= 48; ++k)
            for (const double sign : {1.0, -1.0})
                for (int i = 0; i < 3; ++i) {
                    CAPTURE(power, k, sign, i);
                    const double largest = std::exp2(power);
                    Vector3d moments = Vector3d::Constant(largest);
                    moments[i] = 1e-12 * largest * (1 + sign * std::exp2(-k));
                    const double expected = sign > 0 ? 1 / moments[i] : 0;
                    REQUIRE_THAT(invert_moments(moments)[i], IsClose(expected, Rounding(8)));
                }
}

TEST_CASE("inertia: nearly equal moments have their own inverses", "[A2.5][inertia]")
{
    for (int power = 1; power <= 50; ++power)
        for (const double third : {0.0, 1e-13, 1e-3, 1.0, 2.0})
            for (int i = 0; i < 3; ++i) {
                CAPTURE(power, third, i);
                Vector3d moments, expected;
                moments[i] = third;
                moments[(i + 1) % 3] = 1;
                moments[(i + 2) % 3] = 1 + std::ldexp(1, -power);
                for (int k = 0; k < 3; ++k)
                    expected[k] = moments[k] < 1e-12 ? 0 : 1 / moments[k];
                const Vector3d found = invert_moments(moments);
                for (int k = 0; k < 3; ++k)
                    REQUIRE_THAT(found[k], IsClose(expected[k], Rounding(8)));
            }
}

TEST_CASE("inertia: principal axes of a tensor that is nearly diagonal", "[A2.4][inertia]")
{
    for (Random random : seeds(20))
        for (const double angle : {1e-3, 1e-5, 1e-7, 1e-9, 1e-11, 1e-12, 5e-13}) {
            CAPTURE(angle);
            const Matrix3d R = Eigen::AngleAxisd(angle, random.unit_vector()).toRotationMatrix();
            Vector3d moments(1, 2, 2.5); // in this order, or in another one
            if (random.bits() % 2 == 0)
                std::swap(moments[random_index(random, 3)], moments[random_index(random, 3)]);
            const Matrix3d turned = R * moments.asDiagonal() * R.transpose();
            const Matrix3d I = (turned + turned.transpose()) / 2;
            const PrincipalAxes axes = principal_axes(I);
            REQUIRE_THAT(axes.rotation, IsRotation());
            INFO("I = Q diag(moments) Qᵀ");
            REQUIRE_THAT(
                Matrix3d(axes.rotation * axes.moments.asDiagonal() * axes.rotation.transpose()),
                IsClose(I, Rounding(256, I.norm())));
        }
}

TEST_CASE("inertia: a light part far away counts", "[A2.14][inertia]")
{
    for (Random random : seeds(20))
        for (const double ratio : {1e-3, 1e-6, 1e-9, 1e-12, 1e-15, 1e-20}) {
            // the reduced mass m M/(m + M) at the distance d adds its inertia; here m d² = 1 kg m²
            CAPTURE(ratio);
            const double d = 1 / std::sqrt(ratio), reduced = ratio / (1 + ratio);
            const Vector3d at = d * random.unit_vector();
            const Matrix3d I = random.inertia();
            Matrix3d expected =
                I + reduced * (at.squaredNorm() * Matrix3d::Identity() - at * at.transpose());
            const MassProperties heavy = {1, Vector3d::Zero(), I},
                                 light = {ratio, at, Matrix3d::Zero()};
            for (const MassProperties& both : {combine(heavy, light), combine(light, heavy)}) {
                REQUIRE_THAT(both.mass, IsClose(1 + ratio, Rounding(8)));
                REQUIRE_THAT(both.center_of_mass, IsClose(Vector3d(reduced * at), Rounding(16, d)));
                REQUIRE_THAT(both.inertia, IsClose(expected, Rounding(64, 2 + I.norm())));
            }
        }
}

TEST_CASE("inertia: a body with a hole of nearly its mass has the mass that is left",
          "[A2.14][inertia]")
{
    // A body of 1 kg at the origin, and a hole of e - 1 kg at e u: X = (e - 1) u.
    for (Random random : seeds(10))
        for (int power = 1; power <= 40; ++power) {
            CAPTURE(power);
            const double e = std::ldexp(1, -power);
            const Vector3d u = random.unit_vector(), X = (e - 1) * u;
            const Matrix3d I = random.inertia(),
                           arms = u.squaredNorm() * Matrix3d::Identity() - u * u.transpose();
            // I/2 is what both have of their own; 1 kg at -X, e - 1 kg at e u - X = u
            const Matrix3d expected = I / 2 + ((e - 1) * (e - 1) + (e - 1)) * arms;
            const MassProperties body = {1, Vector3d::Zero(), I},
                                 hole = {e - 1, e * u, Matrix3d(-I / 2)};
            for (const MassProperties& left : {combine(body, hole), combine(hole, body)}) {
                REQUIRE_THAT(left.mass, IsClose(e, Rounding(8)));
                REQUIRE_THAT(left.center_of_mass, IsClose(X, Rounding(16)));
                REQUIRE_THAT(left.inertia, IsClose(expected, Rounding(64, 4 + I.norm())));
            }
        }
}

TEST_CASE("inertia: a part of the union may have negative mass", "[A2.14][inertia]")
{
    // A hole is such a part. The reduced mass m₁ m₂/(m₁ + m₂) at the distance d between the two
    // centers adds its inertia.
    for (Random random : seeds(20))
        for (const double first : {1.0, -1.0})
            for (const double second : {2.0, 0.5, -0.5, -2.0}) {
                const double m1 = first * random.mass(), m2 = second * m1;
                CAPTURE(m1, m2);
                const Vector3d x1 = random.vector(), x2 = random.vector(), d = x1 - x2;
                const Matrix3d I1 = m1 * random.inertia(), I2 = m2 * random.inertia();
                const double M = m1 + m2, reduced = m1 * m2 / M;
                const Matrix3d expected =
                    I1 + I2 +
                    reduced * (d.squaredNorm() * Matrix3d::Identity() - d * d.transpose());
                const MassProperties both = combine({m1, x1, I1}, {m2, x2, I2});
                REQUIRE_THAT(both.mass, IsClose(M, Rounding(8)));
                REQUIRE_THAT(both.center_of_mass,
                             IsClose(Vector3d((m1 * x1 + m2 * x2) / M), Rounding(32, 16)));
                const double largest = 64 * std::abs(m1); // the distances to X are at most 4 d
                REQUIRE_THAT(both.inertia,
                             IsClose(expected, Rounding(64, largest + I1.norm() + I2.norm())));
            }
}
