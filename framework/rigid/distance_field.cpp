// SPDX-License-Identifier: MIT
#include "rigid/distance_field.hpp"

#include "formulas/collision.hpp"
#include "geometry/solid_mesh.hpp"

#include <cmath>

namespace rigor {

DistanceField::DistanceField(const Shape& shape, Counters& counters)
    : shape_(shape), counters_(counters)
{
    if (const Mesh* mesh = std::get_if<Mesh>(&shape))
        grid_ = &mesh->solid->level_set([&] { ++counters.level_sets_built; });
}

double DistanceField::distance(const Vector3d& p) const
{
    if (!grid_) return signed_distance(shape_, p).distance;
    ++counters_.level_set_samples;
    const double phi = sample_level_set(*grid_, p);
    if (!std::isfinite(phi)) throw NonFiniteLevelSet{"signed distance", &shape_};
    return phi;
}

Vector3d DistanceField::normal(const Vector3d& p) const
{
    if (!grid_) return signed_distance(shape_, p).normal;
    const Vector3d n = level_set_normal(*grid_, p);
    if (!n.allFinite()) throw NonFiniteLevelSet{"normal", &shape_};
    return n;
}

} // namespace rigor
