// SPDX-License-Identifier: MIT
// A7.2 and A7.3: stresses of every structure. Any of the shear stresses may be 0, any principal
// stress the largest, and two or all three of them equal.
#include "formulas/fracture.hpp"
#include "graded/laws/tensor_patterns.hpp"
#include "support/close.hpp"
#include "support/in_words.hpp"

namespace fracture_patterns_test {

using namespace rigor;
using namespace rigor::testing;

namespace {

// Checks that the stress along the unit vector d is a principal stress, and the largest one.
void check_largest(const Matrix3d& sigma, double stress, const Vector3d& d)
{
    const double size = std::max(sigma.norm(), 1.0);
    REQUIRE_THAT(d.norm(), IsClose(1.0, Rounding(64, 1)));
    REQUIRE_THAT(Vector3d(sigma * d), IsClose(Vector3d(stress * d), Rounding(256, size)));
    const Matrix3d rest = stress * Matrix3d::Identity() - sigma;
    check_at_least(smallest_minor(rest, size), 0,
                   "each principal minor of σ₁ δ - σ, which has no negative eigenvalue", 256);
}

} // namespace

TEST_CASE("fracture: the largest principal stress of stresses of every structure",
          "[A7.2][fracture]")
{
    for (const Matrix3d& sigma : tensor_patterns()) {
        CAPTURE(sigma);
        const PrincipalStress found = principal_stress(sigma);
        check_largest(sigma, found.stress, found.direction);
    }
}

TEST_CASE("fracture: the largest principal stress beside a shear of any size", "[A7.2][fracture]")
{
    constexpr double values[] = {-1, 0, 0.5, 1};
    for (int i = 0; i < 64; ++i)
        for (int axis = 0; axis < 3; ++axis)
            for (int power = 0; power <= 50; power += 2) {
                Matrix3d sigma =
                    Vector3d(values[i % 4], values[i / 4 % 4], values[i / 16]).asDiagonal();
                const int next = (axis + 1) % 3;
                sigma(axis, next) = sigma(next, axis) = std::ldexp(1, -power);
                CAPTURE(sigma);
                const PrincipalStress found = principal_stress(sigma);
                check_largest(sigma, found.stress, found.direction);
            }
}

TEST_CASE("fracture: stresses of every structure crack across their largest pull",
          "[A7.3][fracture]")
{
    for (const Matrix3d& sigma : tensor_patterns()) {
        const double least = smallest_minor(-sigma, 1); // exact, negative if the solid is pulled
        if (least == 0) continue;                       // whether it is pulled is up to rounding
        CAPTURE(sigma);
        const std::optional<Vector3d> n = crack_plane(sigma, -1);
        check_that(n.has_value() == (least < 0), least < 0
                                                     ? "a crack, since a principal stress is a pull"
                                                     : "no crack, since all stress is pressure");
        if (!n) continue;
        const double pull = n->dot(sigma * *n);
        check_largest(sigma, pull, *n);
        check_that(crack_plane(sigma, 0.999 * pull).has_value(),
                   "a crack, where the strength is a little less than σ₁");
        check_that(!crack_plane(sigma, 1.001 * pull).has_value(),
                   "no crack, where the strength is a little more than σ₁");
    }
}

TEST_CASE("fracture: a solid that is pulled alike from all sides cracks", "[A7.3][fracture]")
{
    for (int power = -60; power <= 60; power += 5) {
        CAPTURE(power);
        const double pull = std::ldexp(1, power);
        const std::optional<Vector3d> n = crack_plane(pull * Matrix3d::Identity(), pull / 2);
        check_that(n.has_value(), "a crack, whose normal may be any unit vector");
        REQUIRE_THAT(n->norm(), IsClose(1.0, Rounding(64, 1)));
        check_that(!crack_plane(-pull * Matrix3d::Identity(), 0).has_value(),
                   "no crack under pressure from all sides");
    }
}

} // namespace fracture_patterns_test
