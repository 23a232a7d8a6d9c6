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

} // namespace inertia_turned_test
