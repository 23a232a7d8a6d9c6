// SPDX-License-Identifier: MIT
// SIMD arithmetic on pairs of numbers: a quantity of body 1, and the same quantity of body 2. A
// contact acts on both bodies in the same way, so one instruction can update both.
#pragma once

#include "formulas/types.hpp"

namespace rigor::optimised {

/// A number of body 1 and a number of body 2, side by side in a register.
using Two [[gnu::vector_size(16)]] = double;

/// A vector of body 1 and a vector of body 2.
struct TwoVectors {
    Two x, y, z;

    TwoVectors& operator+=(const TwoVectors& b)
    {
        x += b.x, y += b.y, z += b.z;
        return *this;
    }
};

[[gnu::always_inline]] inline TwoVectors side_by_side(const Vector3d& a, const Vector3d& b)
{
    return {Two{a[0], b[0]}, Two{a[1], b[1]}, Two{a[2], b[2]}};
}

/// The vector of body 1 (`of_first`) or of body 2 (`of_second`).
inline Vector3d of_first(const TwoVectors& a)
{
    return {a.x[0], a.y[0], a.z[0]};
}
inline Vector3d of_second(const TwoVectors& a)
{
    return {a.x[1], a.y[1], a.z[1]};
}

/// a × b
[[gnu::always_inline]] inline TwoVectors cross(const TwoVectors& a, const TwoVectors& b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// The vector a for body 1 and again for body 2.
[[gnu::always_inline]] inline TwoVectors broadcast(const Vector3d& a)
{
    return {Two{a[0], a[0]}, Two{a[1], a[1]}, Two{a[2], a[2]}};
}

/// The vector of body 1 minus the vector of body 2.
[[gnu::always_inline]] inline Vector3d difference(const TwoVectors& a)
{
    return {a.x[0] - a.x[1], a.y[0] - a.y[1], a.z[0] - a.z[1]};
}

/// a·b for each body.
[[gnu::always_inline]] inline Two dot(const TwoVectors& a, const TwoVectors& b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// Inverse masses and inertias of both bodies, with the signs for an impulse j on body 1 and -j on
/// body 2: 1/M₁ beside -1/M₂, I₁⁻¹ beside -I₂⁻¹.
struct TwoMasses {
    Two inverse_mass, xx, yy, zz, xy, xz, yz;

    TwoMasses() = default;
    TwoMasses(const Body& b1, const Body& b2)
    {
        const Matrix3d &I = b1.inverse_inertia, &J = b2.inverse_inertia;
        inverse_mass = Two{b1.inverse_mass, -b2.inverse_mass};
        xx = Two{I(0, 0), -J(0, 0)};
        yy = Two{I(1, 1), -J(1, 1)};
        zz = Two{I(2, 2), -J(2, 2)};
        xy = Two{I(0, 1), -J(0, 1)};
        xz = Two{I(0, 2), -J(0, 2)};
        yz = Two{I(1, 2), -J(1, 2)};
    }
};

/// I₁⁻¹ t₁ for body 1 and -I₂⁻¹ t₂ for body 2, with the signs of `TwoMasses`.
[[gnu::always_inline]] inline TwoVectors inverse_inertia_times(const TwoMasses& of,
                                                               const TwoVectors& t)
{
    return {of.xx * t.x + of.xy * t.y + of.xz * t.z, of.xy * t.x + of.yy * t.y + of.yz * t.z,
            of.xz * t.x + of.yz * t.y + of.zz * t.z};
}

/// V and ω of both bodies. They stay in registers while a sweep visits the contacts of this pair.
struct TwoMotions {
    TwoVectors V, w;

    /// v₁ - v₂ at the contact point. The lever arms r lead from the centers of mass to this point.
    [[gnu::always_inline]] Vector3d relative_velocity(const TwoVectors& r) const
    {
        TwoVectors v = cross(w, r);
        v += V;
        return difference(v);
    }

    /// Inlined form of `apply_impulse`: j acts on body 1 and -j on body 2. Changes V and ω only;
    /// the angular momenta are not stored here.
    [[gnu::always_inline]] void apply(const TwoMasses& of, const TwoVectors& r, const Vector3d& j)
    {
        const TwoVectors p = broadcast(j);
        V += {of.inverse_mass * p.x, of.inverse_mass * p.y, of.inverse_mass * p.z};
        w += inverse_inertia_times(of, cross(r, p));
    }
};

} // namespace rigor::optimised
