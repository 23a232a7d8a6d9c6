// SPDX-License-Identifier: MIT
// Makes a deformable solid from a mesh at rest.
#pragma once

#include "deformable/solid/deformable.hpp"

namespace rigor {

/// A solid at rest in the shape `rest`, moved by the rotation and then the translation. Its masses
/// are lumped; velocities and plastic strains are zero.
Deformable make_deformable(std::string name, TetrahedralMesh rest, const SolidMaterial& material,
                           const Matrix3d& rotation, const Vector3d& translation);

} // namespace rigor
