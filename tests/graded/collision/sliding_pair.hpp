// SPDX-License-Identifier: MIT
// Two bodies that slide on each other: how far they are from sticking and from jamming, and the
// laws of the sliding impulse.
#pragma once

#include "colliding_pair.hpp"
#include "support/close.hpp"

#include <numbers>

namespace rigor::testing {

inline const Vector3d up(0, 1, 0);

/// The part of v that is perpendicular to n.
inline Vector3d tangential(const Vector3d& v, const Vector3d& n)
{
    return v - v.dot(n) * n;
}

inline Matrix3d turn(double degrees, const Vector3d& axis)
{
    return Eigen::AngleAxisd(degrees * std::numbers::pi / 180, axis).toRotationMatrix();
}

/// nᵀ K (n - μ T) / nᵀ K n, which is 1 without friction and 0 where the contact jams.
inline double ease(const CollidingPair& pair, double friction)
{
    const Vector3d T = tangential(pair.v, pair.n).normalized();
    const Vector3d Kn = pair.K * pair.n;
    return 1 - friction * Kn.dot(T) / Kn.dot(pair.n);
}

/// Distance of the sticking impulse from the border of the friction cone, relative to the size of
/// the impulse; positive inside the cone.
inline double margin(const CollidingPair& pair, double friction)
{
    const double v_n = pair.v.dot(pair.n);
    const Vector3d j = pair.K.inverse() * (-pair.v - pair.restitution * v_n * pair.n);
    return (friction * j.dot(pair.n) - tangential(j, pair.n).norm()) / j.norm();
}

/// Whether the contact is so far from jamming that the division magnifies rounding by 2 at most.
inline bool slides_easily(const CollidingPair& pair, double friction)
{
    return ease(pair, friction) > 0.5;
}

/// The scale of the rounding of an impulse [N s]: solving with K magnifies rounding by at most the
/// square of its condition.
inline double impulse_scale(const CollidingPair& pair)
{
    return pair.size * pair.condition * pair.condition;
}

/// The laws that determine a sliding impulse.
inline void check_sliding(const CollidingPair& pair, double friction, const Vector3d& j)
{
    const auto& [body1, body2, x, n, K, v, restitution, size, condition] = pair;
    const Vector3d T = tangential(v, n).normalized();
    const double scale = impulse_scale(pair);
    {
        INFO("n.(v + K j) is -ε v.n");
        REQUIRE_THAT((v + K * j).dot(n),
                     IsClose(-restitution * v.dot(n), Rounding(64, scale * K.norm())));
    }
    {
        INFO("the tangential part is -μ jₙ T");
        REQUIRE_THAT(tangential(j, n), IsClose(-friction * j.dot(n) * T, Rounding(64, scale)));
    }
    check_at_least(j.dot(n), 0, "jₙ", scale);
}

/// As `check_sliding`, where friction and directions may be extreme: |j| grows with 1 + μ, and the
/// rounding of T with |v|/|v_T|.
inline void check_extreme_sliding(CollidingPair pair, double friction, const Vector3d& j)
{
    const double speed = tangential(pair.v, pair.n).norm();
    pair.size *= (1 + friction) * (speed > 0 ? 1 + pair.v.norm() / speed : 1);
    check_sliding(pair, friction, j);
}

/// A body that slides along T while it falls on a plane with the normal n.
struct Skid {
    double mass = 1;            // [kg]
    double along = 1, down = 1; // its speeds along T and against n [m/s]
    double restitution = 0.5;
    Vector3d T = Vector3d::UnitX(), n = up; // unit, perpendicular

    Vector3d v() const { return along * T - down * n; }
    /// The change of the normal velocity by the impulse.
    double kick() const { return (1 + restitution) * down; }
    /// The tolerance of an impulse on this body. The condition of K is at most 4.
    Tolerance rounding() const { return Rounding(64, 4 * mass * v().norm()); }
};

inline Skid random_skid(Random& random)
{
    const Matrix3d R = random.rotation();
    return {random.uniform(0.5, 2),
            random.uniform(1, 4),
            random.uniform(1, 4),
            random.uniform(0, 1),
            R.col(0),
            R.col(1)};
}

/// K of a uniform sphere that skids: `sphere_on_floor` for any normal and mass.
inline Matrix3d skidding_sphere(const Skid& skid)
{
    return (3.5 * Matrix3d::Identity() - 2.5 * skid.n * skid.n.transpose()) / skid.mass;
}

/// K of a thin rod of length 1 whose tip skids. The rod trails behind its tip, at the angle atan t
/// to the plane: K = (4 δ - 3 d dᵀ)/M. So K couples n and T, and friction presses the tip down.
inline Matrix3d skidding_rod(double t, const Skid& skid)
{
    const Vector3d d = (t * skid.n - skid.T).normalized();
    return (4 * Matrix3d::Identity() - 3 * d * d.transpose()) / skid.mass;
}

/// K of a contact that jams if it slides along x with μ ≥ 2: then friction presses it down harder
/// than the normal impulse lifts it.
/// For v = (2, -2, 0) and ε = 0.5 the sticking impulse is (-4, 2, 3).
inline Matrix3d jamming_contact()
{
    Matrix3d K;
    K << 3, 2, 2, //
        2, 4, 1,  //
        2, 1, 2;
    return K;
}

} // namespace rigor::testing
