// SPDX-License-Identifier: MIT
#include "rigid/motion/elliptic_functions.hpp"

#include "support/close.hpp"

#include <cmath>
#include <numbers>

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("elliptic: integrals have the values that Carlson printed", "[rigid]")
{
    // Carlson 1995, section 3
    CHECK_THAT(carlson_rf(1, 2, 0), IsClose(1.3110287771461, Rounding(200)));
    CHECK_THAT(carlson_rf(2, 3, 4), IsClose(0.58408284167715, Rounding(200)));
    CHECK_THAT(carlson_rj(0, 1, 2, 3), IsClose(0.77688623778582, Rounding(200)));
    CHECK_THAT(carlson_rj(2, 3, 4, 5), IsClose(0.14297579667157, Rounding(200)));
}

TEST_CASE("elliptic: integrals agree with those of Legendre", "[rigid]")
{
    for (const double k : {0.1, 0.5, 0.9})
        for (const double phi : {0.01, 0.5, 1.5})
            for (const double n : {-100., -1., 0.3}) {
                CAPTURE(k, phi, n);
                const double s = std::sin(phi), c = std::cos(phi), d2 = 1 - k * k * s * s;
                const double F = s * carlson_rf(c * c, d2, 1);
                const double p = 1 - n * s * s;
                const double Pi = F + n / 3 * s * s * s * carlson_rj(c * c, d2, 1, p);
                CHECK_THAT(F, IsClose(std::ellint_1(k, phi), Rounding(8)));
                CHECK_THAT(Pi, IsClose(std::ellint_3(k, n, phi), Rounding(32, std::max(F, Pi))));
                CHECK_THAT(quarter_period(1 - k * k), IsClose(std::comp_ellint_1(k), Rounding(8)));
            }
}

TEST_CASE("elliptic: functions invert the integral of the first kind", "[rigid]")
{
    for (const double m1 : {1., 0.7, 0.1, 1e-3, 1e-8, 1e-16, 1e-40})
        for (const double part : {-0.9, -0.1, 0., 1e-9, 0.3, 0.7, 0.99, 0.9999999}) {
            CAPTURE(m1, part);
            const double u = part * quarter_period(m1);
            const EllipticFunctions f = elliptic_functions(u, m1);
            const double c2 = f.cn * f.cn, d2 = f.dn * f.dn;
            CHECK_THAT(f.sn * f.sn + c2, IsClose(1.0, Rounding(8)));
            CHECK_THAT(d2, IsClose(m1 + (1 - m1) * c2, Rounding(64)));
            CHECK_THAT(f.sn * carlson_rf(c2, d2, 1), IsClose(u, Rounding(64)));
        }
}

TEST_CASE("elliptic: functions are circular at m = 0 and hyperbolic at m = 1", "[rigid]")
{
    for (const double u : {-7., -1., 0.2, 3., 30.}) {
        const EllipticFunctions circular = elliptic_functions(u, 1);
        CHECK_THAT(circular.sn, IsClose(std::sin(u), Rounding(8)));
        CHECK_THAT(circular.cn, IsClose(std::cos(u), Rounding(8)));
        CHECK(circular.dn == 1);
        const EllipticFunctions hyperbolic = elliptic_functions(u, 1e-100);
        CHECK_THAT(hyperbolic.sn, IsClose(std::tanh(u), Rounding(16)));
        CHECK_THAT(hyperbolic.cn, IsClose(1 / std::cosh(u), Rounding(256)));
        CHECK_THAT(hyperbolic.dn, IsClose(1 / std::cosh(u), Rounding(256)));
    }
}

TEST_CASE("elliptic: the addition theorem gives the functions of a sum", "[rigid]")
{
    for (const double m1 : {0.8, 0.01, 1e-12})
        for (const double u : {-3., 0.4, 5.})
            for (const double v : {-0.7, 2., 4.}) {
                CAPTURE(m1, u, v);
                const EllipticFunctions f =
                    at_sum(elliptic_functions(u, m1), elliptic_functions(v, m1), m1);
                const EllipticFunctions sum = elliptic_functions(u + v, m1);
                CHECK_THAT(f.sn, IsClose(sum.sn, Rounding(64, 1)));
                CHECK_THAT(f.cn, IsClose(sum.cn, Rounding(64, 1)));
                CHECK_THAT(f.dn, IsClose(sum.dn, Rounding(64, 1)));
            }
}
