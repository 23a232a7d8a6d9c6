// SPDX-License-Identifier: MIT
// A body that turns about its middle axis leaves it (Ashbaugh, Chicone and Cushman 1991, "The
// twisting tennis racket"): small deviations grow with W √((I₁ - I₂)(I₂ - I₃)/(I₁ I₃)), I₁ the
// largest moment. About the other two axes they swing with W √((I₃ - I₁)(I₃ - I₂)/(I₁ I₂)), I₃ the
// moment of that axis.
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

namespace tennis_racket {

namespace {

// The angular velocity in the body after a time T.
Vector3d later(const Vector3d& w, double T, int steps)
{
    World world = solved({free_box(w)}, {0, 0, 0});
    run(world, steps, T / steps);
    return rotation_matrix(world.bodies[0].state.orientation).transpose() *
           angular_velocity(world.bodies[0]);
}

} // namespace

TEST_CASE("classics: a racket leaves its middle axis exponentially", "[classics]")
{
    const Vector3d& I = free_moments; // 13, 10, 5
    const double W = 2, e = 1e-6;
    const double rate = W * std::sqrt((I[0] - I[1]) * (I[1] - I[2]) / (I[0] * I[2]));
    // The direction in which it grows: ẇ₁ = (I₂ - I₃)/I₁ W w₃, ẇ₃ = (I₁ - I₂)/I₃ W w₁.
    const Vector3d grows(e, W, e * rate * I[0] / ((I[1] - I[2]) * W));
    for (const double T : {1., 5.}) {
        CAPTURE(T);
        const Vector3d w = later(grows, T, 400);
        CHECK_THAT(w.x() / e, IsClose(std::exp(rate * T), Order(1e-5 * std::exp(rate * T))));
    }
}

TEST_CASE("classics: about its outer axes a racket only wobbles", "[classics]")
{
    const Vector3d& I = free_moments;
    const double W = 2, e = 1e-6;
    for (const int axis : {0, 2}) {
        CAPTURE(axis);
        const int i = (axis + 1) % 3, j = (axis + 2) % 3;
        const double rate = W * std::sqrt((I[axis] - I[i]) * (I[axis] - I[j]) / (I[i] * I[j]));
        Vector3d w = W * Vector3d::Unit(axis);
        w[i] = e;
        for (const double T : {1., 20.}) {
            const Vector3d v = later(w, T, 2000);
            CHECK_THAT(v[i] / e, IsClose(std::cos(rate * T), Order(1e-5)));
        }
    }
}

} // namespace tennis_racket
