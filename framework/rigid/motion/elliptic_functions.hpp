// SPDX-License-Identifier: MIT
// Elliptic integrals and Jacobi's elliptic functions. Their relative errors stay small for every
// parameter m below 1, also for m very near to 1.
#pragma once

namespace rigor {

/// Carlson's R_F(x, y, z) = ½ ∫₀^∞ dt / √((t + x)(t + y)(t + z)).
///
/// The arguments are not negative, and at most one of them is 0.
double carlson_rf(double x, double y, double z);

/// Carlson's R_J(x, y, z, p) = 3/2 ∫₀^∞ dt / ((t + p) √((t + x)(t + y)(t + z))).
///
/// x, y, z are not negative, at most one of them is 0, and p > 0.
double carlson_rj(double x, double y, double z, double p);

/// K, a quarter of the period of sn and cn.
///
/// @param m1  the complementary parameter 1 - m, in (0, 1]
double quarter_period(double m1);

struct EllipticFunctions {
    double sn = 0, cn = 1, dn = 1;
};

/// Jacobi's sn, cn and dn of u. Where cn and dn are small, their relative errors are small too.
///
/// @param m1  the complementary parameter 1 - m, in (0, 1]
EllipticFunctions elliptic_functions(double u, double m1);

/// sn, cn and dn of u + v, computed from their values at u and at v by the addition theorem.
EllipticFunctions at_sum(const EllipticFunctions& u, const EllipticFunctions& v, double m1);

} // namespace rigor
