// SPDX-License-Identifier: MIT
// Makes a solid without velocity or plastic strain from its mesh at rest. First the vertices are
// moved to their positions in the world, then the masses are lumped at the nodes.
#include "deformable/solid/make_deformable.hpp"

#include "deformable/solid/lumped_mass.hpp"

#include <utility>

namespace rigor {

Deformable make_deformable(std::string name, TetrahedralMesh rest, const SolidMaterial& material,
                           const Matrix3d& rotation, const Vector3d& translation)
{
    Deformable solid;
    solid.name = std::move(name);
    solid.material = material;
    solid.rest = std::move(rest);
    for (const Vector3d& X : solid.rest.vertices)
        solid.positions.push_back(rotation * X + translation);
    solid.velocities.assign(solid.positions.size(), Vector3d::Zero());
    solid.plastic_strains.assign(solid.rest.tetrahedra.size(), Matrix3d::Zero());
    solid.masses = lumped_masses(solid);
    return solid;
}

} // namespace rigor
