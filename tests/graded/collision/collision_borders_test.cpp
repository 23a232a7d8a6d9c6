// SPDX-License-Identifier: MIT
// A4.8 and A4.9 just beside the frictions at which a contact jams or sticks. All numbers are exact
// in binary, so the border is known to the last digit.
#include "formulas/collision.hpp"
#include "sliding_pair.hpp"
#include "support/close.hpp"

#include <cmath>

namespace rigor::testing {

namespace {

// K of a contact that slides along x and jams from the friction 1/c on: nᵀ K n = 1, nᵀ K T = c and
// det K = 1. For v = (1, -1, 0) and ε = 0 the sticking impulse is (-1 - c, 1 + c + c², 0).
Matrix3d strongly_coupled_contact(double c)
{
    Matrix3d K;
    K << c * c + 1, c, 0, //
        c, 1, 0,          //
        0, 0, 1;
    return K;
}

Vector3d sticking_impulse(double c)
{
    return {-1 - c, 1 + c + c * c, 0};
}

} // namespace

TEST_CASE("collision: a contact jams beside the friction of the border", "[A4.8][collision]")
{
    // nᵀ K (n - μ T) = 4 - 2 μ
    for (int power = 2; power <= 44; ++power) {
        CAPTURE(power);
        const double off = std::ldexp(1, -power), below = 2 - off, above = 2 + off;
        const double j_n = 1.5 / off;
        REQUIRE_THAT(sliding_friction_impulse(jamming_contact(), {2, -2, 0}, up, 0.5, below),
                     IsClose(Vector3d(-below * j_n, j_n, 0), Rounding(8, 4 * j_n / off)));
        const double share = above * 2 / 5; // the sticking impulse is (-4, 2, 3), its |j_T| is 5
        REQUIRE_THAT(sliding_friction_impulse(jamming_contact(), {2, -2, 0}, up, 0.5, above),
                     IsClose(Vector3d(-4 * share, 2, 3 * share), Rounding(1 << 10, 5)));
    }
}

TEST_CASE("collision: a strongly coupled contact jams with little friction", "[A4.8][collision]")
{
    for (int coupling = 0; coupling <= 10; ++coupling)
        for (int power = 1; power <= 20; ++power) {
            CAPTURE(coupling, power);
            const double c = std::ldexp(1, coupling), off = std::ldexp(1, -power);
            const Matrix3d K = strongly_coupled_contact(c);
            const double below = (1 - off) / c, above = (1 + off) / c, j_n = 1 / off;
            REQUIRE_THAT(sliding_friction_impulse(K, {1, -1, 0}, up, 0, below),
                         IsClose(Vector3d(-below * j_n, j_n, 0), Rounding(8, j_n / off)));
            REQUIRE_THAT(sliding_friction_impulse(K, {1, -1, 0}, up, 0, above),
                         IsClose(sticking_impulse(c), Rounding(64, std::pow(c + 1, 4))));
        }
}

TEST_CASE("collision: a strongly coupled contact sticks or slides", "[A4.9][collision]")
{
    for (int coupling = 0; coupling <= 10; ++coupling)
        for (int power = 1; power <= 20; ++power)
            for (const double sign : {1.0, -1.0}) {
                CAPTURE(coupling, power, sign);
                const double c = std::ldexp(1, coupling), off = sign * std::ldexp(1, -power);
                const double friction = (1 - off) / c;
                // within the cone: (1 + c) ≤ μ (1 + c + c²)
                const bool sticks = 1 + c <= friction * (1 + c + c * c);
                const double j_n = 1 / off;
                const Vector3d j =
                    collision_impulse(strongly_coupled_contact(c), {1, -1, 0}, up, 0, friction);
                if (sticks)
                    REQUIRE_THAT(j, IsClose(sticking_impulse(c), Rounding(64, std::pow(c + 1, 4))));
                else
                    REQUIRE_THAT(j, IsClose(Vector3d(-friction * j_n, j_n, 0),
                                            Rounding(8, std::abs(j_n / off))));
            }
}

TEST_CASE("collision: just outside of the cone it slides to another impulse", "[A4.9][collision]")
{
    // K (3, 1, 4) is (19, 14, 15). So with ε = 0 the sticking impulse for v = -(19, 14, 15) is
    // (3, 1, 4), which is on the border of the cone for μ = 5.
    const Vector3d v(-19, -14, -15), stick(3, 1, 4);
    const Vector3d T = tangential(v, up).normalized();
    for (int power = 2; power <= 40; ++power) {
        CAPTURE(power);
        const double off = std::ldexp(1, -power), below = 5 * (1 - off);
        REQUIRE_THAT(collision_impulse(jamming_contact(), v, up, 0, 5 * (1 + off)),
                     IsClose(stick, Rounding(1 << 10, 5)));
        const Vector3d edge = up - below * T;
        const Vector3d slide = 14 / up.dot(jamming_contact() * edge) * edge;
        REQUIRE_THAT(collision_impulse(jamming_contact(), v, up, 0, below),
                     IsClose(slide, Rounding(64, 5)));
    }
}

TEST_CASE("collision: bodies that only slide get no impulse", "[A4.9][collision]")
{
    // v·n is 0 or -0; the sticking impulse for these velocities would push or pull
    const Vector3d normals[] = {{0, 1, 0}, {-0.0, 1, -0.0}, {0, -1, 0}, {-0.0, -1, -0.0}};
    for (const double x : {-1.0, 1.0})
        for (const double z : {-1.0, -2.0, 1.0, 2.0})
            for (const double y : {0.0, -0.0})
                for (const double friction : {0.0, 0.5, 5.0})
                    for (const Vector3d& n : normals) {
                        CAPTURE(x, y, z, friction, n);
                        for (const Matrix3d& K :
                             {jamming_contact(),
                              Matrix3d(3 * Matrix3d::Ones() + Matrix3d::Identity())})
                            REQUIRE_THAT(collision_impulse(K, {x, y, z}, n, 0.5, friction),
                                         IsExactly(Vector3d(0, 0, 0)));
                    }
}

} // namespace rigor::testing
