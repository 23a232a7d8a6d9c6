// SPDX-License-Identifier: MIT
// Computes elliptic integrals by Carlson's duplication (1995, "Numerical computation of real or
// complex elliptic integrals", Numer. Algorithms 10): the arguments are brought closer together
// until a short series is exact up to rounding. Computes elliptic functions by the
// arithmetic-geometric mean (Bulirsch 1965, "Numerical calculation of elliptic integrals and
// elliptic functions", Numer. Math. 7).
#include "rigid/motion/elliptic_functions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace rigor {

namespace {

// The series leave out terms of sixth order. So they are exact up to rounding if the arguments
// differ from their mean A by at most this fraction of A, (ε/4)^(1/6) with the machine epsilon ε.
const double left_out_spread = std::pow(std::numeric_limits<double>::epsilon() / 4, 1.0 / 6);

// The arithmetic and the geometric mean converge quadratically. If they differ by less than this
// fraction of the arithmetic mean, half their sum equals their common limit up to rounding.
constexpr double mean_tolerance = 1e-8;
// Largest number of rounds in which the two means approach each other. Even the complementary
// parameter m1 = 1e-300 needs only 11 rounds.
constexpr int most_rounds = 20;

// Largest number of rounds of the duplication. Arguments as far apart as 1 and 1e-300 need at most
// 13 rounds, unless p of R_J is far larger than x, y and z, which does not occur in
// free_rotation.cpp.
constexpr int most_duplications = 100;

// R_C(1, 1 + e) = arctan(√e) / √e, which is artanh(√-e) / √-e for e < 0.
double carlson_rc1(double e)
{
    if (std::abs(e) < 1e-4) return 1 - e * (1.0 / 3 - e * (1.0 / 5 - e * (1.0 / 7)));
    const double root = std::sqrt(std::abs(e));
    return (e > 0 ? std::atan(root) : std::atanh(root)) / root;
}

} // namespace

double carlson_rf(double x, double y, double z)
{
    const double A0 = (x + y + z) / 3;
    double A = A0, share = 1; // share = 4⁻ⁿ
    const double spread =
        std::max({std::abs(A0 - x), std::abs(A0 - y), std::abs(A0 - z)}) / left_out_spread;
    const double dx = A0 - x, dy = A0 - y;
    for (int n = 0; n < most_duplications && share * spread > A; ++n) {
        const double sx = std::sqrt(x), sy = std::sqrt(y), sz = std::sqrt(z);
        const double lambda = sx * sy + sy * sz + sz * sx;
        x = (x + lambda) / 4, y = (y + lambda) / 4, z = (z + lambda) / 4;
        A = (A + lambda) / 4;
        share /= 4;
    }
    const double X = dx * share / A, Y = dy * share / A, Z = -X - Y;
    const double E2 = X * Y - Z * Z, E3 = X * Y * Z;
    return (1 - E2 / 10 + E3 / 14 + E2 * E2 / 24 - 3 * E2 * E3 / 44) / std::sqrt(A);
}

double carlson_rj(double x, double y, double z, double p)
{
    const double A0 = (x + y + z + 2 * p) / 5, dx = A0 - x, dy = A0 - y, dz = A0 - z;
    const double spread =
        std::max({std::abs(dx), std::abs(dy), std::abs(dz), std::abs(A0 - p)}) / left_out_spread;
    double A = A0, share = 1, sum = 0; // share = 4⁻ⁿ
    for (int n = 0; n < most_duplications && share * spread > A; ++n) {
        const double sx = std::sqrt(x), sy = std::sqrt(y), sz = std::sqrt(z), sp = std::sqrt(p);
        const double lambda = sx * sy + sy * sz + sz * sx;
        const double d = (sp + sx) * (sp + sy) * (sp + sz);
        const double e = ((p - x) / d) * ((p - y) / d) * (p - z);
        sum += share / d * carlson_rc1(e);
        x = (x + lambda) / 4, y = (y + lambda) / 4, z = (z + lambda) / 4, p = (p + lambda) / 4;
        A = (A + lambda) / 4;
        share /= 4;
    }
    const double X = dx * share / A, Y = dy * share / A, Z = dz * share / A;
    const double P = (-X - Y - Z) / 2;
    const double E2 = X * Y + X * Z + Y * Z - 3 * P * P;
    const double E3 = X * Y * Z + 2 * E2 * P + 4 * P * P * P;
    const double E4 = (2 * X * Y * Z + E2 * P + 3 * P * P * P) * P, E5 = X * Y * Z * P * P;
    const double series =
        1 - 3 * E2 / 14 + E3 / 6 + 9 * E2 * E2 / 88 - 3 * E4 / 22 - 9 * E2 * E3 / 52 + 3 * E5 / 26;
    return share * series / (A * std::sqrt(A)) + 6 * sum;
}

double quarter_period(double m1)
{
    double a = 1, b = std::sqrt(m1);
    for (int n = 0; n < most_rounds && a - b > mean_tolerance * a; ++n) {
        const double mean = (a + b) / 2;
        b = std::sqrt(a * b);
        a = mean;
    }
    return std::numbers::pi / (a + b);
}

EllipticFunctions elliptic_functions(double u, double m1)
{
    std::array<double, most_rounds> means{}, roots{};
    double a = 1, b = std::sqrt(m1);
    int n = 0;
    for (; n + 1 < most_rounds; ++n) {
        means[n] = a, roots[n] = b;
        if (!(a - b > mean_tolerance * a)) break;
        const double mean = (a + b) / 2;
        b = std::sqrt(a * b);
        a = mean;
    }
    const double limit = (a + b) / 2;
    EllipticFunctions f{std::sin(limit * u), std::cos(limit * u), 1};
    if (f.sn == 0) return f;
    // Landen's transformation, from the last pair of means back to the first. At each pair,
    // `slope` is cn/sn, and c is cn/sn times the arithmetic mean of the pair.
    double slope = f.cn / f.sn, c = limit * slope;
    for (; n >= 0; --n) {
        slope *= c;
        c *= f.dn;
        f.dn = (roots[n] + slope) / (means[n] + slope);
        slope = c / means[n];
    }
    f.sn = std::copysign(1 / std::sqrt(c * c + 1), f.sn);
    f.cn = c * f.sn;
    return f;
}

EllipticFunctions at_sum(const EllipticFunctions& u, const EllipticFunctions& v, double m1)
{
    // 1 - m sn²(u) sn²(v), as a sum of positive terms
    const double D = u.cn * u.cn + u.sn * u.sn * v.dn * v.dn;
    EllipticFunctions f;
    f.sn = (u.sn * v.cn * v.dn + v.sn * u.cn * u.dn) / D;
    f.cn = (u.cn * v.cn - u.sn * u.dn * v.sn * v.dn) / D;
    const double size = std::hypot(f.sn, f.cn); // 1 up to rounding
    f.sn /= size;
    f.cn /= size;
    f.dn = std::sqrt(m1 + (1 - m1) * f.cn * f.cn);
    return f;
}

} // namespace rigor
