// SPDX-License-Identifier: MIT
// Computes the data of a mesh that contacts need. The constructor computes bounds, volume, radius
// and convexity. The hull, the surface points, the tree and the level set are computed when they
// are first needed.
#include "geometry/shapes/solid_mesh.hpp"

#include "geometry/level_sets/level_set.hpp"
#include "geometry/meshes/mesh_checks.hpp"
#include "geometry/meshes/mesh_edges.hpp"

#include <algorithm>

namespace rigor {

SolidMesh::SolidMesh(TriangleMesh mesh, std::string name, int cells)
    : mesh_(std::move(mesh)), name_(std::move(name)), cells_(cells), bounds_(bounds_of(mesh_)),
      volume_(signed_volume(mesh_))
{
    for (const Vector3d& v : mesh_.vertices)
        radius_ = std::max(radius_, (v - center()).norm());
    is_convex_ = is_hull(mesh_);
}

const Hull& SolidMesh::hull() const
{
    return hull_.get([&] { return std::make_unique<Hull>(mesh_); });
}

double SolidMesh::facet_angle() const
{
    return facet_angle_.get([&] { return std::make_unique<double>(rigor::facet_angle(mesh_)); });
}

int SolidMesh::cells() const
{
    if (cells_ > 0) return cells_;
    return chosen_cells_.get([&] { return std::make_unique<int>(suggested_cells(mesh_)); });
}

const MeshSurface& SolidMesh::surface() const
{
    return surface_.get([&] {
        const double longest = (bounds_.high - bounds_.low).maxCoeff();
        return std::make_unique<MeshSurface>(mesh_, longest / cells());
    });
}

const TriangleTree& SolidMesh::triangles() const
{
    return triangles_.get([&] { return std::make_unique<TriangleTree>(mesh_); });
}

std::unique_ptr<LevelSet> SolidMesh::new_level_set() const
{
    return std::make_unique<LevelSet>(make_level_set(mesh_, cells()));
}

} // namespace rigor
