// SPDX-License-Identifier: MIT
#pragma once

#include "geometry/distance/signed_distance.hpp"
#include "rigid/bodies/counters.hpp"
#include "rigid/bodies/world.hpp"

namespace rigor {

/// Thrown if `sample_level_set` or `level_set_normal` returned a value that is not finite.
struct NonFiniteLevelSet {
    const char* quantity;
    const Shape* shape; // the shape that has the level set
};

/// Signed distance to a shape in its object space. For a mesh it comes from the level set through
/// the formulas `sample_level_set` and `level_set_normal`; for any other shape it is exact.
class DistanceField {
public:
    /// Builds the level set of a mesh if it does not exist yet.
    DistanceField(const Shape& shape, Counters& counters);

    /// @throws NonFiniteLevelSet if the formula's result is not finite
    double distance(const Vector3d& p) const;
    /// The outward unit normal.
    /// @throws NonFiniteLevelSet if the formula's result is not finite
    Vector3d normal(const Vector3d& p) const;
    /// For a ball near the surface of the shape: the distance between the two surfaces, and the
    /// outward normal of the shape on the line through the ball's center.
    ///
    /// If the center is inside the grid of a mesh, the level set is sampled at the center. Outside
    /// the grid, the level set gives little more than the distance to the grid. So it is sampled at
    /// a point between the center and the nearest triangle.
    SurfaceDistance ball(const Vector3d& center, double radius) const;
    /// The distance of `ball` without its normal.
    double ball_distance(const Vector3d& center, double radius) const;

    /// For a mesh only: the distance and the normal of a ball, as `ball` finds them for a center
    /// outside the grid. But the level set is sampled between the center and the point `target` of
    /// the surface, instead of the nearest point.
    SurfaceDistance ball_towards(const Vector3d& center, double radius,
                                 const Vector3d& target) const;

    /// For a mesh, the distance to its bounds, computed without a formula. Outside the bounds it is
    /// a lower bound of `distance`. Inside the bounds it is 0, although `distance` may be negative
    /// there. For any other shape, a number below every distance.
    double at_least(const Vector3d& p) const;
    /// An error bound of the distance at places where the gradient of the distance changes its
    /// direction within a cell; 0 if the distance is exact [m].
    double uncertainty() const { return grid_ ? grid_->cell_size : 0; }

private:
    bool is_in_grid(const Vector3d& p) const;
    double way_to_grid(double away) const;
    Vector3d nearest_point(const Vector3d& p) const;

    const Shape& shape_;
    Counters& counters_;
    const SolidMesh* mesh_ = nullptr;
    const LevelSet* grid_ = nullptr; // level set of the mesh
};

/// The deepest of some points in a distance field, in the frame of the field.
struct DeepestPoint {
    Vector3d point = Vector3d::Zero();
    double gap = 0; // signed distance of the point, negative inside; 0: no point was inside [m]

    void consider(const Vector3d& p, double distance)
    {
        if (distance >= gap) return;
        point = p;
        gap = distance;
    }
};

} // namespace rigor
