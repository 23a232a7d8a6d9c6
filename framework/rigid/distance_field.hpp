// SPDX-License-Identifier: MIT
#pragma once

#include "geometry/signed_distance.hpp"
#include "rigid/world.hpp"

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
    /// How far the distance may be off where it changes its direction within a cell [m].
    double uncertainty() const { return grid_ ? grid_->cell_size : 0; }

private:
    const Shape& shape_;
    Counters& counters_;
    const LevelSet* grid_ = nullptr; // of a mesh
};

} // namespace rigor
