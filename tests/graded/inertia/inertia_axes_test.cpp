// SPDX-License-Identifier: MIT
// A2.4 and A2.5: principal axes, and the inverse of those moments that are not zero.
#include "formulas/inertia.hpp"
#include "graded/laws/tensor_patterns.hpp"
#include "support/close.hpp"
#include "support/random.hpp"
#include "support/seeds.hpp"

#include <cmath>
#include <numbers>

namespace inertia_axes_test {

using namespace rigor;
using namespace rigor::testing;

namespace {

Matrix3d diagonal(double x, double y, double z)
{
    return Vector3d(x, y, z).asDiagonal();
}

Matrix3d turned(const Matrix3d& R, const Vector3d& moments)
{
    const Matrix3d I = R * moments.asDiagonal() * R.transpose();
    return (I + I.transpose()) / 2; // symmetric to the last bit
}

// Checks that the axes are a rotation that turns the moments into I, and that the moments ascend
// and are not negative.
void require_principal_axes(const PrincipalAxes& axes, const Matrix3d& I)
{
    const Matrix3d& Q = axes.rotation;
    const Matrix3d found = Q * axes.moments.asDiagonal() * Q.transpose();

    REQUIRE_THAT(Q, IsRotation());
    {
        INFO("I = Q diag(moments) Qᵀ");
        REQUIRE_THAT(found, IsClose(I, Rounding(256, I.norm())));
    }
    check_at_most(axes.moments[0], axes.moments[1], "the first moment", I.norm());
    check_at_most(axes.moments[1], axes.moments[2], "the second moment", I.norm());
    check_at_most(-axes.moments.minCoeff(), 0, "minus the smallest moment", 0);
}

} // namespace

TEST_CASE("inertia: principal axes of a diagonal tensor", "[A2.4][inertia]")
{
    const Matrix3d I = diagonal(3, 1, 2);

    const PrincipalAxes axes = principal_axes(I);

    require_principal_axes(axes, I);
    REQUIRE_THAT(axes.moments, IsClose(Vector3d(1, 2, 3), Rounding(16, I.norm())));
    INFO("the first axis is y, up to its sign");
    REQUIRE_THAT(std::abs(axes.rotation(1, 0)), IsClose(1.0, Rounding(16, 1)));
}

TEST_CASE("inertia: principal axes of tensors of every structure", "[A2.4][inertia]")
{
    for (const Matrix3d& A : tensor_patterns())
        for (const Matrix3d& I : {A, Matrix3d(A + 8 * Matrix3d::Identity())})
            if (smallest_minor(I, 1) >= 0) { // exact: no moment is negative
                CAPTURE(I);
                require_principal_axes(principal_axes(I), I);
            }
}

TEST_CASE("inertia: principal axes of a tensor with products", "[A2.4][inertia]")
{
    Matrix3d I;
    I << 2, -1, 0, -1, 2, 0, 0, 0, 4; // eigenvalue 1 along (1, 1, 0), 3 along (-1, 1, 0)

    const PrincipalAxes axes = principal_axes(I);

    require_principal_axes(axes, I);
    REQUIRE_THAT(axes.moments, IsClose(Vector3d(1, 3, 4), Rounding(64, I.norm())));
    INFO("the first axis is (1, 1, 0), up to its sign");
    REQUIRE_THAT(std::abs(axes.rotation.col(0).dot(Vector3d(1, 1, 0))),
                 IsClose(std::numbers::sqrt2, Rounding(64, 2)));
    INFO("the same moments times `mass`, along the columns of R");
    for (Random random : seeds(5)) {
        const Matrix3d R = random.rotation();
        const Vector3d moments = random.mass() * Vector3d(1, 3, 4);
        const Matrix3d J = turned(R, moments);

        const PrincipalAxes found = principal_axes(J);

        require_principal_axes(found, J);
        REQUIRE_THAT(found.moments, IsClose(moments, Rounding(256, J.norm())));
        REQUIRE_THAT(std::abs(found.rotation.col(0).dot(R.col(0))), IsClose(1.0, Rounding(64, 1)));
    }
}

TEST_CASE("inertia: principal axes of any body are a rotation", "[A2.4][inertia]")
{
    for (Random random : seeds(100)) {
        const Matrix3d I = random.inertia();

        require_principal_axes(principal_axes(I), I);
    }
}

TEST_CASE("inertia: principal axes of bodies that are nearly round", "[A2.4][inertia]")
{
    for (Random random : seeds(20)) {
        const Matrix3d R = random.rotation();
        for (const double gap : {0.0, 1e-12, 1e-8, 1e-6, 1e-4}) {
            CAPTURE(gap);
            const Vector3d moments(1, 1 + gap, 1.5);
            const Matrix3d I = turned(R, moments);

            const PrincipalAxes axes = principal_axes(I);

            require_principal_axes(axes, I);
            REQUIRE_THAT(axes.moments, IsClose(moments, Rounding(256, I.norm())));
        }
    }
}

TEST_CASE("inertia: principal axes of spheres and of nothing", "[A2.4][inertia]")
{
    require_principal_axes(principal_axes(2 * Matrix3d::Identity()), 2 * Matrix3d::Identity());

    const PrincipalAxes nothing = principal_axes(Matrix3d::Zero());
    REQUIRE_THAT(nothing.rotation, IsRotation());
    REQUIRE_THAT(nothing.moments, IsExactly(Vector3d(Vector3d::Zero())));
}

TEST_CASE("inertia: moments are never negative", "[A2.4][inertia]")
{
    const double rounding = 1e-16;
    const PrincipalAxes axes = principal_axes(diagonal(-rounding, 1, 2));
    require_principal_axes(axes, diagonal(0, 1, 2));

    for (Random random : seeds(100)) { // rods in every direction: one moment is 0, up to rounding
        const Matrix3d I = turned(random.rotation(), Vector3d(0, 5, 5));

        require_principal_axes(principal_axes(I), I);
    }
    for (Random random : seeds(100)) // rods in every plane of two axes
        for (int axis = 0; axis < 3; ++axis) {
            Vector3d rod = random.vector();
            rod[axis] = 0;
            const Matrix3d I = rod.squaredNorm() * Matrix3d::Identity() - rod * rod.transpose();

            require_principal_axes(principal_axes(I), I);
        }
}

TEST_CASE("inertia: principal axes of thin and of tiny bodies", "[A2.4][inertia]")
{
    for (Random random : seeds(20)) {
        for (const Vector3d& moments : {Vector3d(1e-6, 1, 1), Vector3d(1e-12, 2e-12, 2.5e-12)}) {
            const Matrix3d I = turned(random.rotation(), moments);

            const PrincipalAxes axes = principal_axes(I);

            require_principal_axes(axes, I);
            REQUIRE_THAT(axes.moments, IsClose(moments, Rounding(1024, I.norm())));
        }
    }
}

TEST_CASE("inertia: inverse moments by hand", "[A2.5][inertia]")
{
    REQUIRE_THAT(invert_moments(Vector3d(2, 4, 8)),
                 IsClose(Vector3d(0.5, 0.25, 0.125), Rounding(8, 0.5)));
}

TEST_CASE("inertia: what cannot turn has no inverse moment", "[A2.5][inertia]")
{
    REQUIRE_THAT(invert_moments(Vector3d(0, 5, 5)),
                 IsClose(Vector3d(0, 0.2, 0.2), Rounding(8))); // rod
    REQUIRE_THAT(invert_moments(Vector3d(5, 0, 5)), IsClose(Vector3d(0.2, 0, 0.2), Rounding(8)));
    REQUIRE_THAT(invert_moments(Vector3d::Zero()), IsExactly(Vector3d(Vector3d::Zero()))); // point
}

TEST_CASE("inertia: a pseudo-inverse inverts where there is something to invert", "[A2.5][inertia]")
{
    const double m = 3, L = 2;
    const Vector3d moments(m * L * L / 2, m * L * L / 2, 0); // two points at z = ±L/2

    const Vector3d product = invert_moments(moments).cwiseProduct(moments);

    REQUIRE_THAT(product, IsClose(Vector3d(1, 1, 0), Rounding(8, 1)));
}

TEST_CASE("inertia: what rounding left of a moment is not inverted", "[A2.5][inertia]")
{
    const Vector3d rod = invert_moments(Vector3d(5e-16, 5, 5));
    REQUIRE_THAT(rod[0], IsExactly(0.0));

    INFO("class B: zero up to 1e-12 of the largest moment, and no further");
    REQUIRE_THAT(invert_moments(Vector3d(9.9e-13, 1, 1))[0], IsExactly(0.0));
    REQUIRE_THAT(invert_moments(Vector3d(1.01e-12, 1, 1))[0],
                 IsClose(1 / 1.01e-12, Rounding(8, 1e12)));
}

TEST_CASE("inertia: a small body has large inverse moments", "[A2.5][inertia]")
{
    const Vector3d moments(1e-15, 2e-15, 4e-15); // a grain of sand

    REQUIRE_THAT(invert_moments(moments),
                 IsClose(Vector3d(1e15, 0.5e15, 0.25e15), Rounding(8, 1e15)));
}

} // namespace inertia_axes_test
