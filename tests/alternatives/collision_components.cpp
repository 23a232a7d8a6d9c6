// SPDX-License-Identifier: MIT
// A local frame (n, t, b) at the contact, component sums with fused multiply-add, and lerp by hand.
#include "formulas/collision.hpp"

#include <cmath>

namespace rigor {

namespace {

// The columns n, t and b, where t is along the sliding velocity if there is one.
Matrix3d contact_frame(const Vector3d& n, const Vector3d& v)
{
    Vector3d t = v - n.dot(v) * n;
    if (t.norm() <= 1e-12 * v.norm()) t = n.unitOrthogonal();
    t -= n.dot(t) * n;
    t.normalize();
    Matrix3d frame;
    frame << n, t, n.cross(t);
    return frame;
}

double dot(const Vector3d& a, const Vector3d& b)
{
    return std::fma(a.x(), b.x(), std::fma(a.y(), b.y(), a.z() * b.z()));
}

// The nearest point of the grid's box: its cell, and its place in the cell, 0 … 1 along each axis.
struct Place {
    std::array<std::size_t, 3> cell;
    std::array<double, 3> t;
    double outside = 0; // distance from the box [m]
};

Place place_of(const LevelSet& grid, const Vector3d& p)
{
    Place place;
    Vector3d missing;
    for (int i = 0; i < 3; ++i) {
        const double last = grid.size[i] - 1;
        const double s = (p[i] - grid.origin[i]) / grid.cell_size;
        const double inside = s < 0 ? 0 : s > last ? last : s;
        missing[i] = s - inside;
        const double cell = std::min(std::floor(inside), last - 1);
        place.cell[i] = static_cast<std::size_t>(cell);
        place.t[i] = inside - cell;
    }
    place.outside = grid.cell_size * missing.norm();
    return place;
}

double node(const LevelSet& grid, const Place& place, int i, int j, int k)
{
    const auto width = static_cast<std::size_t>(grid.size[0]),
               height = static_cast<std::size_t>(grid.size[1]);
    return grid
        .distances[((place.cell[2] + k) * height + place.cell[1] + j) * width + place.cell[0] + i];
}

} // namespace

double sample_level_set(const LevelSet& grid, const Vector3d& p)
{
    const Place at = place_of(grid, p);
    double z[2];
    for (int k = 0; k < 2; ++k) {
        double y[2];
        for (int j = 0; j < 2; ++j)
            y[j] = (1 - at.t[0]) * node(grid, at, 0, j, k) + at.t[0] * node(grid, at, 1, j, k);
        z[k] = (1 - at.t[1]) * y[0] + at.t[1] * y[1];
    }
    return (1 - at.t[2]) * z[0] + at.t[2] * z[1] + at.outside;
}

Vector3d level_set_normal(const LevelSet& grid, const Vector3d& p)
{
    const Place at = place_of(grid, p);
    Vector3d slope(0, 0, 0);
    for (int j = 0; j < 2; ++j)
        for (int k = 0; k < 2; ++k) {
            const auto weight = [&](int axis, int side) {
                return side == 1 ? at.t[axis] : 1 - at.t[axis];
            };
            slope.x() +=
                weight(1, j) * weight(2, k) * (node(grid, at, 1, j, k) - node(grid, at, 0, j, k));
            slope.y() +=
                weight(0, j) * weight(2, k) * (node(grid, at, j, 1, k) - node(grid, at, j, 0, k));
            slope.z() +=
                weight(0, j) * weight(1, k) * (node(grid, at, j, k, 1) - node(grid, at, j, k, 0));
        }
    return slope.isZero(0) ? Vector3d(0, 1, 0) : slope.stableNormalized();
}

Vector3d relative_velocity(const Body& body1, const Body& body2, const Vector3d& x)
{
    const Vector3d r1 = x - body1.position, r2 = x - body2.position;
    return (body1.velocity - body2.velocity) - r1.cross(body1.angular_velocity) +
           r2.cross(body2.angular_velocity);
}

Matrix3d impulse_matrix(double inverse_mass, const Matrix3d& I_inverse, const Vector3d& X,
                        const Vector3d& x)
{
    Matrix3d K = Matrix3d::Zero();
    if (inverse_mass == 0) return K;
    // K_ij = δ_ij / M + (r × e_i)ᵀ I⁻¹ (r × e_j)
    const Vector3d r = x - X;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            K(i, j) = r.cross(Vector3d::Unit(i)).dot(I_inverse * r.cross(Vector3d::Unit(j)));
    K.diagonal().array() += inverse_mass;
    return K;
}

Vector3d frictionless_impulse(const Matrix3d& K, const Vector3d& v, const Vector3d& n,
                              double restitution)
{
    double stiffness = 0;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            stiffness += n[i] * K(i, j) * n[j];
    if (stiffness == 0) return {0, 0, 0};
    return n * (-(dot(v, n) + restitution * dot(v, n)) / stiffness);
}

Vector3d static_friction_impulse(const Matrix3d& K, const Vector3d& v, const Vector3d& n,
                                 double restitution)
{
    if ((K.array() == 0).all()) return {0, 0, 0};
    return K.llt().solve(-(v + restitution * dot(v, n) * n));
}

bool inside_friction_cone(const Vector3d& j, const Vector3d& n, double friction)
{
    const double push = dot(j, n);
    if (push < 0) return false;
    const Vector3d side = j - push * n;
    return std::hypot(side.x(), side.y(), side.z()) <= friction * push;
}

Vector3d sliding_friction_impulse(const Matrix3d& K, const Vector3d& v, const Vector3d& n,
                                  double restitution, double friction)
{
    const double v_n = dot(v, n);
    if ((v - v_n * n).norm() <= 1e-12 * v.norm()) return frictionless_impulse(K, v, n, restitution);

    const Matrix3d frame = contact_frame(n, v), local = frame.transpose() * K * frame;
    const double resists = local(0, 0) - friction * local(0, 1);
    if (resists > 0) {
        const double push = -(1 + restitution) * v_n / resists;
        return frame * Vector3d(push, -friction * push, 0);
    }
    const Vector3d held = frame.transpose() * static_friction_impulse(K, v, n, restitution);
    if (held[0] <= 0) return {0, 0, 0};
    const double side = std::hypot(held[1], held[2]);
    const double share = side > friction * held[0] ? friction * held[0] / side : 1;
    return frame * Vector3d(held[0], share * held[1], share * held[2]);
}

Vector3d collision_impulse(const Matrix3d& K, const Vector3d& v, const Vector3d& n,
                           double restitution, double friction)
{
    if (!(v.dot(n) < 0)) return {0, 0, 0};
    const Vector3d held = static_friction_impulse(K, v, n, restitution);
    return inside_friction_cone(held, n, friction)
               ? held
               : sliding_friction_impulse(K, v, n, restitution, friction);
}

Body apply_impulse(const Body& body, const Vector3d& x, const Vector3d& j)
{
    Body after = body;
    if (body.inverse_mass == 0) return after;
    const Vector3d kick = -j.cross(x - body.position);
    for (int i = 0; i < 3; ++i) {
        after.velocity[i] = std::fma(body.inverse_mass, j[i], after.velocity[i]);
        after.angular_momentum[i] += kick[i];
        after.angular_velocity += body.inverse_inertia.col(i) * kick[i];
    }
    return after;
}

std::optional<int> deepest_approaching_point(const std::vector<ContactPoint>& contacts)
{
    std::optional<int> deepest; // from the last one, so that of equal depths the first is kept
    for (int i = static_cast<int>(contacts.size()) - 1; i >= 0; --i)
        if (contacts[i].relative_velocity.dot(contacts[i].normal) < 0 &&
            (!deepest || contacts[i].depth >= contacts[*deepest].depth))
            deepest = i;
    return deepest;
}

} // namespace rigor
