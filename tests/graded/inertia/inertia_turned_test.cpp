// SPDX-License-Identifier: MIT
// A2.2 and A2.3: tensors of every structure, turned by any rotation. Some of the inverse moments
// may be 0, as those of point masses and rods and those that A2.5 returns for tiny moments.
#include "formulas/inertia.hpp"
#include "graded/laws/tensor_patterns.hpp"
#include "support/close.hpp"
#include "support/random.hpp"
#include "support/seeds.hpp"

namespace inertia_turned_test {

using namespace rigor;
using namespace rigor::testing;

namespace {

// R A Rᵀ, entry by entry.
Matrix3d exactly_turned(const Matrix3d& R, const Matrix3d& A)
{
    Matrix3d result;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            long double sum = 0;
            for (int k = 0; k < 3; ++k)
                for (int l = 0; l < 3; ++l)
                    sum += static_cast<long double>(R(i, k)) * A(k, l) * R(j, l);
            result(i, j) = static_cast<double>(sum);
        }
    return result;
}

template <class Turn> void check_turned(Turn turned)
{
    for (Random random : seeds(2)) {
        const Matrix3d R = random.rotation();
        for (const Matrix3d& A : tensor_patterns())
            for (const Matrix3d& tensor : {A, Matrix3d(A + 8 * Matrix3d::Identity())})
                if (smallest_minor(tensor, 1) >= 0) // exact: no moment is negative
                    REQUIRE_THAT(turned(R, tensor),
                                 IsClose(exactly_turned(R, tensor), Rounding(32, tensor.norm())));
    }
}

} // namespace

TEST_CASE("inertia: tensors of every structure in world space", "[A2.2][inertia]")
{
    check_turned(world_inertia);
}

TEST_CASE("inertia: inverse tensors of every structure in world space", "[A2.3][inertia]")
{
    check_turned(world_inverse_inertia);
}

// The inverse inertia of a rod whose axis is nearly one of the frame: of the entries t beside the
// diagonal and t² on it, t counts although t² is less than a rounding error of the largest entry.
TEST_CASE("inertia: the inverse of a rod that nearly lies along an axis", "[A2.3][inertia]")
{
    for (Random random : seeds(2))
        for (int power = 1; power <= 45; ++power)
            for (int axis = 0; axis < 6; ++axis)
                for (const double sign : {1., -1.}) {
                    CAPTURE(power, axis, sign);
                    Vector3d rod = Vector3d::Unit(axis % 3);
                    rod[(axis % 3 + 1 + axis / 3) % 3] = sign * std::ldexp(1, -power);
                    const Matrix3d A =
                        rod.squaredNorm() * Matrix3d::Identity() - rod * rod.transpose();
                    for (const Matrix3d& R : {Matrix3d(Matrix3d::Identity()), random.rotation()})
                        REQUIRE_THAT(world_inverse_inertia(R, A),
                                     IsClose(exactly_turned(R, A), Rounding(32, 1)));
                }
}

} // namespace inertia_turned_test
