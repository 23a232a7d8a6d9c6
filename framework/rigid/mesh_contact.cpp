// SPDX-License-Identifier: MIT
#include "rigid/mesh_contact.hpp"

#include "geometry/solid_mesh.hpp"
#include "rigid/distance_field.hpp"
#include "rigid/edge_contact.hpp"
#include "rigid/reduce_touches.hpp"
#include "rigid/smooth_contact.hpp"

#include <cmath>

namespace rigor {

namespace {

// A normal this far from where the other shape's distance grows belongs to the far side of a wall.
constexpr double opposite = 0.3;

// The points of a mesh that are near another shape.
class PointsInField {
public:
    // @param pose  of the mesh in the frame of the field
    PointsInField(const MeshSurface& surface, const Pose& pose, const DistanceField& field,
                  double reach)
        : surface_(surface), pose_(pose), field_(field), reach_(reach)
    {
    }

    // In the frame of the field, normals out of it.
    void find(std::vector<Touch>& touches) const
    {
        const auto enter = [&](const Bounds& box) {
            const Vector3d center = (box.low + box.high) / 2;
            const double radius = (box.high - box.low).norm() / 2;
            return field_.distance(pose_ * center) - radius - field_.uncertainty() < reach_;
        };
        const BoundingTree& tree = surface_.point_tree();
        tree.walk(enter, [&](int i) { add(surface_.points()[i], touches); });
    }

private:
    void add(const SurfacePoint& sample, std::vector<Touch>& touches) const
    {
        const Vector3d p = pose_ * sample.point;
        const double gap = field_.distance(p);
        if (gap >= reach_) return;
        const Vector3d gradient = field_.normal(p);
        const Vector3d own =
            surface_.nearest_normal(sample.cone, -(pose_.R.transpose() * gradient));
        const Vector3d n = -(pose_.R * own);
        if (n.dot(gradient) < opposite) return;
        touches.push_back({p - gap / 2 * n, n, gap});
    }

    const MeshSurface& surface_;
    const Pose& pose_;
    const DistanceField& field_;
    double reach_;
};

Pose inverse(const Pose& pose)
{
    return {pose.R.transpose(), -(pose.R.transpose() * pose.X)};
}

} // namespace

void touch_mesh(const Shape& shape1, const Pose& pose1, const Shape& shape2, const Pose& pose2,
                double reach, Counters& counters, std::vector<Touch>& touches)
{
    const SolidMesh& mesh2 = *std::get<Mesh>(shape2).solid;
    const Pose from_1 = inverse(pose2) * pose1, from_2 = inverse(from_1);
    Bounds near2 = mesh2.bounds(), near1 = bounds_of(shape1, {});
    near2.grow(reach);
    near1.grow(reach);
    if (!near2.overlaps(bounds_of(shape1, from_1)) || !near1.overlaps(bounds_of(shape2, from_2)))
        return;

    const DistanceField field1(shape1, counters), field2(shape2, counters);
    std::vector<Touch> found; // in the frame of shape 2, normals from 2 to 1
    PointsInField(mesh2.surface(), from_2, field1, reach).find(found);
    for (Touch& t : found)
        t = {from_1 * t.point, -(from_1.R * t.normal), t.gap};
    if (const Mesh* mesh1 = std::get_if<Mesh>(&shape1))
        PointsInField(mesh1->solid->surface(), from_1, field2, reach).find(found);
    else
        touch_smooth(shape1, from_1, field2, reach, found);
    touch_edges(shape1, from_1, mesh2.surface(), reach, found);

    reduce_touches(found, 0, reach);
    for (const Touch& t : found)
        touches.push_back({pose2 * t.point, pose2.R * t.normal, t.gap});
}

} // namespace rigor
