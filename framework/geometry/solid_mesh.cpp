// SPDX-License-Identifier: MIT
#include "geometry/solid_mesh.hpp"

#include "geometry/mesh_checks.hpp"

#include <algorithm>

namespace rigor {

SolidMesh::SolidMesh(TriangleMesh mesh, std::string name, int cells)
    : mesh_(std::move(mesh)), name_(std::move(name)), cells_(cells), volume_(signed_volume(mesh_))
{
    for (const Vector3d& v : mesh_.vertices)
        bounds_.include({v, v});
    for (const Vector3d& v : mesh_.vertices)
        radius_ = std::max(radius_, (v - center()).norm());
}

} // namespace rigor
