// SPDX-License-Identifier: MIT
// Signed distance from a shape: for a mesh by its level set, for other shapes exact. For a ball,
// the level set is sampled at the center of the ball if the center lies inside the grid. Otherwise
// it is sampled on the way from the center to the nearest triangle, about a cell before the
// surface, and the length of the way to this point is added.
#include "rigid/detection/shapes/distance_field.hpp"

#include "formulas/collision.hpp"
#include "geometry/shapes/solid_mesh.hpp"

#include <cmath>

namespace rigor {

namespace {

// Outside of the shape, a correct gradient points from the nearest point of the surface to the
// point p, so it is opposite to the direction from p to the surface. If the cosine of the angle
// between these two directions is below this value (the angle is above 120°), the gradient counts
// as correct, and the exact direction replaces it.
constexpr double points_back = -0.5;
// Largest error of a correct `sample_level_set` about a cell before the surface, divided by the
// size of a cell. The error of linear interpolation of a distance is smaller, even at an edge or a
// vertex.
constexpr double grid_error = 0.5;
constexpr double no_bound = -1e300; // a lower bound of every distance [m]

} // namespace

DistanceField::DistanceField(const Shape& shape, Counters& counters)
    : shape_(shape), counters_(counters)
{
    const Mesh* mesh = std::get_if<Mesh>(&shape);
    if (!mesh) return;
    mesh_ = mesh->solid.get();
    grid_ = &mesh_->level_set([&] { ++counters.level_sets_built; });
}

double DistanceField::distance(const Vector3d& p) const
{
    if (!grid_) return signed_distance(shape_, p).distance;
    ++counters_.level_set_samples;
    const double phi = sample_level_set(*grid_, p);
    if (!std::isfinite(phi)) throw NonFiniteLevelSet{"signed distance", &shape_};
    return phi;
}

double DistanceField::at_least(const Vector3d& p) const
{
    return mesh_ ? std::sqrt(squared_distance(mesh_->bounds(), p)) : no_bound;
}

bool DistanceField::is_in_grid(const Vector3d& p) const
{
    const Vector3d s = (p - grid_->origin) / grid_->cell_size;
    for (int i = 0; i < 3; ++i)
        if (!(s[i] >= 0 && s[i] <= grid_->size[i] - 1)) return false;
    return true;
}

// The length of the way from a point at the distance `away` from the surface to one cell before the
// surface. The end of the way lies in the grid, which extends two cells beyond the mesh.
double DistanceField::way_to_grid(double away) const
{
    return std::max(away - grid_->cell_size, 0.0);
}

Vector3d DistanceField::nearest_point(const Vector3d& p) const
{
    return mesh_->triangles().nearest(p).point;
}

SurfaceDistance DistanceField::ball_towards(const Vector3d& center, double radius,
                                            const Vector3d& target) const
{
    const double away = (target - center).norm();
    if (!(away > 0)) return {distance(center) - radius, normal(center)};
    const Vector3d d = (target - center) / away;
    const double way = way_to_grid(away);
    const Vector3d p = center + way * d, gradient = normal(p);
    const double phi = distance(p);
    // If the values of the formulas are correct up to the error of the grid, the exact direction
    // and distance replace them. A ball that rolls over triangles with the normal of one surface
    // and the distance from another would gain energy. Wrong values of the formulas are kept, so
    // that the simulation shows the mistake.
    const bool is_right_direction = gradient.dot(d) < points_back;
    const bool is_right_distance = std::abs(phi - (away - way)) < grid_error * grid_->cell_size;
    return {(is_right_direction && is_right_distance ? away : phi + way) - radius,
            is_right_direction ? Vector3d(-d) : gradient};
}

double DistanceField::ball_distance(const Vector3d& center, double radius) const
{
    if (!grid_ || is_in_grid(center)) return distance(center) - radius;
    const Vector3d to_surface = nearest_point(center) - center;
    const double away = to_surface.norm(), way = way_to_grid(away);
    return distance(center + way / away * to_surface) + way - radius;
}

SurfaceDistance DistanceField::ball(const Vector3d& center, double radius) const
{
    if (!grid_ || is_in_grid(center)) return {distance(center) - radius, normal(center)};
    return ball_towards(center, radius, nearest_point(center));
}

Vector3d DistanceField::normal(const Vector3d& p) const
{
    if (!grid_) return signed_distance(shape_, p).normal;
    const Vector3d n = level_set_normal(*grid_, p);
    if (!n.allFinite()) throw NonFiniteLevelSet{"normal", &shape_};
    return n;
}

} // namespace rigor
