// SPDX-License-Identifier: MIT
// Eight weights instead of faces, columns instead of matrices, double cross products, LU for LDLᵀ.
// A level set is a weighted sum over the eight corners of a cell. K is computed column by column.
// Tangential parts come from double cross products, sticking contacts from an LU decomposition.
#include "formulas/collision.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

namespace {

// A point, clamped to the grid's box: its cell, and its place t in the cell, 0 … 1 along each axis.
struct Place {
    int cell[3];
    double t[3];
    double outside; // distance to the box [m]
};

Place place_of(const LevelSet& grid, const Vector3d& p)
{
    Place place = {};
    Vector3d beyond = Vector3d::Zero();
    for (int i = 0; i < 3; ++i) {
        const double most = (grid.size[i] - 1) * grid.cell_size, d = p[i] - grid.origin[i];
        beyond[i] = d < 0 ? -d : d > most ? d - most : 0;
        const double cells = d < 0 ? 0 : d > most ? grid.size[i] - 1 : d / grid.cell_size;
        place.cell[i] = std::clamp(static_cast<int>(std::floor(cells)), 0, grid.size[i] - 2);
        place.t[i] = cells - place.cell[i];
    }
    place.outside = beyond.norm();
    return place;
}

// Σ φ(corner) w_x w_y w_z over the eight corners of the cell. Along the axis `slope` the weight is
// ∓1 instead.
double weighted(const LevelSet& grid, const Place& place, int slope = -1)
{
    double sum = 0;
    for (int corner = 0; corner < 8; ++corner) {
        double weight = 1;
        std::size_t index = 0;
        for (int i = 2; i >= 0; --i) {
            const int up = corner >> i & 1;
            const double t = place.t[i];
            weight *= i == slope ? (up ? 1 : -1) : (up ? t : 1 - t);
            index = index * static_cast<std::size_t>(grid.size[i]) + place.cell[i] + up;
        }
        sum += weight * grid.distances[index];
    }
    return sum;
}

} // namespace

double sample_level_set(const LevelSet& grid, const Vector3d& p)
{
    const Place place = place_of(grid, p);
    return place.outside + weighted(grid, place);
}

Vector3d level_set_normal(const LevelSet& grid, const Vector3d& p)
{
    const Place place = place_of(grid, p);
    const Vector3d slope(weighted(grid, place, 0), weighted(grid, place, 1),
                         weighted(grid, place, 2));
    const double length = std::hypot(slope.x(), slope.y(), slope.z());
    return length > 0 ? Vector3d(slope / length) : Vector3d(0, 1, 0);
}

Vector3d relative_velocity(const Body& body1, const Body& body2, const Vector3d& x)
{
    const Vector3d r1 = x - body1.position, r2 = x - body2.position;
    return (body1.velocity - body2.velocity) + r2.cross(body2.angular_velocity) -
           r1.cross(body1.angular_velocity);
}

Matrix3d impulse_matrix(double inverse_mass, const Matrix3d& I_inverse, const Vector3d& X,
                        const Vector3d& x)
{
    // column i is the change of the velocity of x by a unit impulse along axis i
    const Vector3d r = x - X;
    Matrix3d K = Matrix3d::Zero();
    if (inverse_mass == 0) return K;
    for (int i = 0; i < 3; ++i) {
        const Vector3d w = I_inverse * r.cross(Vector3d::Unit(i));
        K.col(i) = w.cross(r) + inverse_mass * Vector3d::Unit(i);
    }
    return K;
}

Vector3d frictionless_impulse(const Matrix3d& K, const Vector3d& v, const Vector3d& n,
                              double restitution)
{
    const double softness = (n.transpose() * K * n).value();
    if (softness == 0) return Vector3d::Zero();
    return -n * (n.dot(v) + restitution * n.dot(v)) / softness;
}

Vector3d static_friction_impulse(const Matrix3d& K, const Vector3d& v, const Vector3d& n,
                                 double restitution)
{
    if ((K.array() == 0).all()) return Vector3d::Zero();
    return -K.partialPivLu().solve(v + restitution * n.dot(v) * n);
}

bool inside_friction_cone(const Vector3d& j, const Vector3d& n, double friction)
{
    const double push = n.dot(j);
    return push >= 0 && n.cross(j.cross(n)).norm() <= friction * push;
}

Vector3d sliding_friction_impulse(const Matrix3d& K, const Vector3d& v, const Vector3d& n,
                                  double restitution, double friction)
{
    const Vector3d sliding = n.cross(v.cross(n)); // |n| = 1: v without its part along n
    const double speed = sliding.norm();
    if (speed <= 1e-12 * v.norm()) return frictionless_impulse(K, v, n, restitution);

    const Vector3d direction = n - friction / speed * sliding;
    const double softness = (K * n).dot(direction); // K is symmetric
    if (softness > 0) return -(1 + restitution) * n.dot(v) / softness * direction;

    const Vector3d j = static_friction_impulse(K, v, n, restitution);
    const double push = n.dot(j);
    if (!(push > 0)) return Vector3d::Zero();
    const Vector3d across = j - push * n;
    const double shortened = std::min(1.0, friction * push / std::max(across.norm(), 1e-300));
    return push * n + shortened * across;
}

Vector3d collision_impulse(const Matrix3d& K, const Vector3d& v, const Vector3d& n,
                           double restitution, double friction)
{
    if (!(n.dot(v) < 0)) return Vector3d::Zero();
    const Vector3d sticks = static_friction_impulse(K, v, n, restitution);
    return inside_friction_cone(sticks, n, friction)
               ? sticks
               : sliding_friction_impulse(K, v, n, restitution, friction);
}

Body apply_impulse(const Body& body, const Vector3d& x, const Vector3d& j)
{
    Body after = body;
    if (body.inverse_mass == 0) return after;
    const Vector3d turn = -j.cross(x - body.position);
    after.angular_velocity = body.inverse_inertia * turn + body.angular_velocity;
    after.angular_momentum = turn + body.angular_momentum;
    after.velocity = j * body.inverse_mass + body.velocity;
    return after;
}

std::optional<int> deepest_approaching_point(const std::vector<ContactPoint>& contacts)
{
    // goes from the last to the first, so that the first of equally deep ones remains
    std::optional<int> deepest;
    for (int i = static_cast<int>(contacts.size()) - 1; i >= 0; --i)
        if (contacts[i].normal.dot(contacts[i].relative_velocity) < 0 &&
            (!deepest || contacts[i].depth >= contacts[*deepest].depth))
            deepest = i;
    return deepest;
}

} // namespace rigor
