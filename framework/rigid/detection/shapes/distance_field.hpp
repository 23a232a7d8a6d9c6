// SPDX-License-Identifier: MIT
#pragma once

#include "geometry/distance/signed_distance.hpp"
#include "rigid/bodies/counters.hpp"
#include "rigid/bodies/world.hpp"

namespace rigor {

/// What `sample_level_set` or `level_set_normal` returned is no number.
struct NonFiniteLevelSet {
    const char* quantity;
    const Shape* shape; // whose level set it was
};

/// Signed distance to a shape in its object space: of a mesh the level set through the formulas
/// `sample_level_set` and `level_set_normal`, of any other shape exact.
class DistanceField {
public:
    /// Makes the level set if the shape is a mesh and nobody has asked for it before.
    DistanceField(const Shape& shape, Counters& counters);

    /// @throws NonFiniteLevelSet
    double distance(const Vector3d& p) const;
    /// Outward, unit. @throws NonFiniteLevelSet
    Vector3d normal(const Vector3d& p) const;
    /// A ball nearest to the surface: how far its own surface is from the other one, and the normal
    /// there, through its center.
    ///
    /// The level set is asked at the center of the ball if that is inside its grid; else, where the
    /// grid knows no more than how far it is away, on the way to the nearest triangle.
    SurfaceDistance ball(const Vector3d& center, double radius) const;
    double ball_distance(const Vector3d& center, double radius) const;

    /// The same towards a point `target` of the surface that the center looks at.
    SurfaceDistance ball_towards(const Vector3d& center, double radius,
                                 const Vector3d& target) const;

    /// A distance that no point of the surface is nearer than, without a formula.
    double at_least(const Vector3d& p) const;
    /// How far the distance may be off where it changes its direction within a cell [m].
    double uncertainty() const { return grid_ ? grid_->cell_size : 0; }

private:
    bool is_in_grid(const Vector3d& p) const;
    double way_to_grid(double away) const;
    Vector3d nearest_point(const Vector3d& p) const;

    const Shape& shape_;
    Counters& counters_;
    const SolidMesh* mesh_ = nullptr;
    const LevelSet* grid_ = nullptr; // of the mesh
};

} // namespace rigor
