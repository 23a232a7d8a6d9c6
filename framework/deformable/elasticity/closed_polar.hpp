// SPDX-License-Identifier: MIT
// The polar decomposition in closed form, for one matrix or several at once.
//
// The rotation R in F = R S makes Tr(Rᵀ F) as large as a rotation can, namely s = Tr S. The
// singular values of F are s₁ ≥ s₂ ≥ |s₃| (s₃ < 0 where F is inverted), and s = s₁ + s₂ + s₃ is
// the largest root of
//
//     p(s) = s⁴ - 2 ‖F‖² s² - 8 det F s + ‖F‖⁴ - 4 ‖cof F‖²
//
// (Horn 1987, "Closed-form solution of absolute orientation using unit quaternions"; in each of the
// other roots, two of the sᵢ change sign). Newton's method, started at √3 ‖F‖, converges to s from
// above. As s is the maximum of Tr(Rᵀ F) over all rotations R, its derivative with respect to F is
// the R of this maximum, R = ∂s/∂F = -∂p/∂F / ∂p/∂s:
//
//     R = ((s² + ‖F‖²) F + 2 s cof F - 2 F Fᵀ F) / (s³ - ‖F‖² s - 2 det F)
//
// The denominator is 2 (s₁ + s₂)(s₂ + s₃)(s₃ + s₁). It is 0 where R is not unique.
#pragma once

#include "formulas/types.hpp"

#include <cmath>

namespace rigor {

/// A 3 × 3 matrix of numbers or of vector registers, row by row.
template <class Number> struct Square3 {
    Number a[3][3];
};

template <class Number>
[[gnu::always_inline]] inline Square3<Number> cofactors(const Square3<Number>& F)
{
    Square3<Number> C;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            const int k = (i + 1) % 3, l = (i + 2) % 3, m = (j + 1) % 3, n = (j + 2) % 3;
            C.a[i][j] = F.a[k][m] * F.a[l][n] - F.a[k][n] * F.a[l][m];
        }
    return C;
}

template <class Number>
[[gnu::always_inline]] inline Number dot(const Square3<Number>& A, const Square3<Number>& B)
{
    Number sum = A.a[0][0] * B.a[0][0];
    for (int i = 1; i < 9; ++i)
        sum += A.a[i / 3][i % 3] * B.a[i / 3][i % 3];
    return sum;
}

/// Aᵀ B
template <class Number>
[[gnu::always_inline]] inline Square3<Number> transposed_times(const Square3<Number>& A,
                                                               const Square3<Number>& B)
{
    Square3<Number> P;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            P.a[i][j] = A.a[0][i] * B.a[0][j] + A.a[1][i] * B.a[1][j] + A.a[2][i] * B.a[2][j];
    return P;
}

/// A B
template <class Number>
[[gnu::always_inline]] inline Square3<Number> times(const Square3<Number>& A,
                                                    const Square3<Number>& B)
{
    Square3<Number> P;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            P.a[i][j] = A.a[i][0] * B.a[0][j] + A.a[i][1] * B.a[1][j] + A.a[i][2] * B.a[2][j];
    return P;
}

/// R and s = Tr S of F = R S, with two numbers that tell how accurate R and s are.
template <class Number> struct ClosedPolar {
    Square3<Number> R;
    Number s;            // Tr S
    Number conditioning; // denominator in the formula of R (at the top of this file), divided by
                         // s³: 16/27 at rest, 0 if R is not unique
    Number last_step;    // last step of Newton's method, divided by s
};

// Newton's method has converged if its step, divided by s, is below this. The method converges
// quadratically, so that after such a step only rounding errors remain.
inline constexpr double small_step = 1e-12;

/// Below this conditioning, cancellation costs the closed form more than two digits.
inline constexpr double least_conditioning = 0.01;

/// Whether the closed form is accurate. If not, the caller takes R from an eigenvector instead
/// (polar_decomposition.cpp).
inline bool is_exact(double conditioning, double last_step)
{
    return conditioning > least_conditioning && std::abs(last_step) < small_step;
}

/// R and s of one matrix F, or of several at once, by the formulas at the top of this file.
/// @param norm2   ‖F‖²
/// @param start   where Newton's method starts: √3 ‖F‖, which is never below s
/// @param is_end  is_end(x) tells whether Newton's method stops after a step, where x is the step
///                divided by s; near rest it stops after at most four steps
template <class Number, class IsEnd>
[[gnu::always_inline]] inline ClosedPolar<Number>
closed_polar(const Square3<Number>& F, Number norm2, Number start, const IsEnd& is_end)
{
    const Square3<Number> C = cofactors(F);
    const Number det = F.a[0][0] * C.a[0][0] + F.a[0][1] * C.a[0][1] + F.a[0][2] * C.a[0][2];
    const Number p0 = norm2 * norm2 - 4.0 * dot(C, C), p1 = 8.0 * det, p2 = 2.0 * norm2;
    Number s = start, step = start;
    constexpr int most_steps = 20; // limits the time; near rest, four steps are enough
    for (int i = 0; i < most_steps; ++i) {
        const Number p = ((s * s - p2) * s - p1) * s + p0;
        const Number dp = (4.0 * (s * s) - 2.0 * p2) * s - p1;
        step = p / dp;
        s -= step;
        if (is_end(step / s)) break;
    }
    const Square3<Number> FFF = times(F, transposed_times(F, F));
    ClosedPolar<Number> polar;
    const Number denominator = (s * s - norm2) * s - 2.0 * det;
    const Number f = (s * s + norm2) / denominator, c = 2.0 * s / denominator,
                 q = 2.0 / denominator;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            polar.R.a[i][j] = f * F.a[i][j] + c * C.a[i][j] - q * FFF.a[i][j];
    polar.s = s;
    polar.conditioning = denominator / (s * s * s);
    polar.last_step = step / s;
    return polar;
}

} // namespace rigor
