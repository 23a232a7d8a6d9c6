// SPDX-License-Identifier: MIT
// Solutions of assignment A4: the level set gives distance and normal, the impulse matrix K relates
// impulse and velocity at a contact, and `collision_impulse` selects the static or sliding impulse.
// The formulas are those of the lecture "Inertia, rotation, impulses", in the order of the tasks.
#include "formulas/collision.hpp"
#include "formulas/kinematics.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

namespace {

// The place on the grid of the point in the grid's box that is nearest to p. If p is in the box,
// this point is p itself.
struct GridPosition {
    std::array<int, 3> cell; // the lowest node of the cell that contains the nearest point
    Vector3d t;              // position in that cell, 0 … 1 along each axis
    double distance;         // distance from p, 0 inside the box [m]
};

GridPosition grid_position(const LevelSet& grid, const Vector3d& p)
{
    const double h = grid.cell_size;
    const Vector3d s = (p - grid.origin) / h; // p in units of cells from node (0, 0, 0)

    GridPosition position;
    Vector3d nearest;
    for (int i = 0; i < 3; ++i) {
        const int last = grid.size[i] - 1;
        nearest[i] = std::clamp(s[i], 0.0, static_cast<double>(last));
        // A face between two cells belongs to the one with the higher index; the last face belongs
        // to the last cell.
        position.cell[i] = std::min(static_cast<int>(nearest[i]), last - 1);
        position.t[i] = nearest[i] - position.cell[i];
    }
    position.distance = h * (s - nearest).norm();
    return position;
}

// φ at the corner (i, j, k) of a cell, each 0 or 1.
double corner(const LevelSet& grid, const std::array<int, 3>& cell, int i, int j, int k)
{
    const std::size_t x = cell[0] + i, y = cell[1] + j, z = cell[2] + k;
    const std::size_t nx = grid.size[0], ny = grid.size[1];
    return grid.distances[x + nx * (y + ny * z)];
}

// Bilinear interpolation between the values f(0, 0), f(1, 0), f(0, 1), f(1, 1), at (s, t).
template <class Values> double bilinear(double s, double t, const Values& f)
{
    return std::lerp(std::lerp(f(0, 0), f(1, 0), s), std::lerp(f(0, 1), f(1, 1), s), t);
}

// A tangential speed at most this fraction of the speed is a rounding error. The fraction is a few
// thousand times the machine epsilon.
constexpr double no_sliding = 1e-12;

// The impulse j with its tangential part shortened to |j_T| = μ jₙ if it is longer; zero if j
// pulls.
Vector3d onto_friction_cone(const Vector3d& j, const Vector3d& n, double mu)
{
    const double j_n = j.dot(n);
    if (j_n <= 0) return Vector3d::Zero(); // pulls
    const Vector3d j_T = j - j_n * n;
    if (j_T.norm() <= mu * j_n) return j;
    return j_n * n + mu * j_n * j_T.normalized();
}

} // namespace

double sample_level_set(const LevelSet& grid, const Vector3d& p)
{
    const GridPosition at = grid_position(grid, p);

    // φ is interpolated along x and y on the lower and upper face of the cell, then along z.
    const auto on_face = [&](int k) {
        return bilinear(at.t.x(), at.t.y(),
                        [&](int i, int j) { return corner(grid, at.cell, i, j, k); });
    };
    return std::lerp(on_face(0), on_face(1), at.t.z()) + at.distance;
}

Vector3d level_set_normal(const LevelSet& grid, const Vector3d& p)
{
    const GridPosition at = grid_position(grid, p);
    const Vector3d& t = at.t;
    const auto phi = [&](int i, int j, int k) { return corner(grid, at.cell, i, j, k); };

    // h ∇φ: φ is linear along each axis, so its slope is the difference of two opposite faces.
    const Vector3d gradient(
        bilinear(t.y(), t.z(), [&](int j, int k) { return phi(1, j, k) - phi(0, j, k); }),
        bilinear(t.x(), t.z(), [&](int i, int k) { return phi(i, 1, k) - phi(i, 0, k); }),
        bilinear(t.x(), t.y(), [&](int i, int j) { return phi(i, j, 1) - phi(i, j, 0); }));
    if (gradient.norm() == 0) return Vector3d::UnitY(); // there is no outward direction

    // n = ∇φ / |∇φ|
    return gradient / gradient.norm();
}

Vector3d relative_velocity(const Body& body1, const Body& body2, const Vector3d& x)
{
    // vᵢ = ωᵢ × (x - Xᵢ) + Vᵢ
    const Vector3d v1 = point_velocity(body1.velocity, body1.angular_velocity, body1.position, x);
    const Vector3d v2 = point_velocity(body2.velocity, body2.angular_velocity, body2.position, x);

    // v = v₁ - v₂
    return v1 - v2;
}

Matrix3d impulse_matrix(double inverse_mass, const Matrix3d& I_inverse, const Vector3d& X,
                        const Vector3d& x)
{
    if (inverse_mass == 0) return Matrix3d::Zero(); // static

    const Matrix3d delta = Matrix3d::Identity();
    const Matrix3d r_star = cross_matrix(x - X);

    // K = δ/M + (x - X)*ᵀ I⁻¹ (x - X)*
    return inverse_mass * delta + r_star.transpose() * I_inverse * r_star;
}

Vector3d frictionless_impulse(const Matrix3d& K, const Vector3d& v, const Vector3d& n,
                              double restitution)
{
    const double epsilon = restitution;
    const double v_n = v.dot(n);
    const double nKn = n.dot(K * n);
    if (nKn == 0) return Vector3d::Zero(); // both bodies static

    // j = -(1 + ε) vₙ / (nᵀ K n) n
    return -(1 + epsilon) * v_n / nKn * n;
}

Vector3d static_friction_impulse(const Matrix3d& K, const Vector3d& v, const Vector3d& n,
                                 double restitution)
{
    if (K.isZero(0)) return Vector3d::Zero(); // both bodies static

    const double epsilon = restitution;
    const double v_n = v.dot(n);

    // j = K⁻¹ (-v - ε vₙ n), solved by a factorization. Its error grows with the condition
    // number of K, while that of K.inverse() grows almost with its square (measured at condition
    // number 1e9: 6e-8 against 2e-2).
    return K.ldlt().solve(-v - epsilon * v_n * n);
}

bool inside_friction_cone(const Vector3d& j, const Vector3d& n, double friction)
{
    const double mu = friction;
    const double j_n = j.dot(n);
    const Vector3d j_T = j - j_n * n;

    // |j_T| ≤ μ jₙ,  jₙ ≥ 0
    return j_n >= 0 && j_T.norm() <= mu * j_n;
}

Vector3d sliding_friction_impulse(const Matrix3d& K, const Vector3d& v, const Vector3d& n,
                                  double restitution, double friction)
{
    const double epsilon = restitution, mu = friction;
    const double v_n = v.dot(n);
    const Vector3d v_T = v - v_n * n;
    if (v_T.norm() <= no_sliding * v.norm()) return frictionless_impulse(K, v, n, restitution);

    // T = (v - vₙ n)/|v - vₙ n|
    const Vector3d T = v_T / v_T.norm();
    const double nKd = n.dot(K * (n - mu * T));
    if (nKd <= 0) // the contact jams, or both bodies are static (K = 0) and the result is zero
        return onto_friction_cone(static_friction_impulse(K, v, n, restitution), n, mu);

    // jₙ = -(1 + ε) vₙ / (nᵀ K (n - μ T))    j = jₙ n - μ jₙ T
    const double j_n = -(1 + epsilon) * v_n / nKd;
    return j_n * n - mu * j_n * T;
}

Vector3d collision_impulse(const Matrix3d& K, const Vector3d& v, const Vector3d& n,
                           double restitution, double friction)
{
    if (v.dot(n) >= 0) return Vector3d::Zero(); // separating

    const Vector3d j = static_friction_impulse(K, v, n, restitution);
    if (inside_friction_cone(j, n, friction)) return j;
    return sliding_friction_impulse(K, v, n, restitution, friction);
}

Body apply_impulse(const Body& body, const Vector3d& x, const Vector3d& j)
{
    if (body.is_static()) return body;

    const Matrix3d& I_inverse = body.inverse_inertia;
    const Vector3d r = x - body.position;

    // V += j/M    L += (x - X) × j    ω += I⁻¹ (x - X) × j
    Body after = body;
    after.velocity += body.inverse_mass * j;
    after.angular_momentum += r.cross(j);
    after.angular_velocity += I_inverse * r.cross(j);
    return after;
}

std::optional<int> deepest_approaching_point(const std::vector<ContactPoint>& contacts)
{
    std::optional<int> deepest;
    for (int i = 0; i < static_cast<int>(contacts.size()); ++i) {
        const ContactPoint& contact = contacts[i];
        if (contact.relative_velocity.dot(contact.normal) >= 0) continue; // separating
        if (!deepest || contact.depth > contacts[*deepest].depth) deepest = i;
    }
    return deepest;
}

} // namespace rigor
