// SPDX-License-Identifier: MIT
// A new deformable solid.
#pragma once

#include "deformable/solid/deformable.hpp"

namespace rigor {

/// A solid at rest in the shape `rest`, moved to its place. Its masses are lumped, and everything
/// else is zero.
Deformable make_deformable(std::string name, TetrahedralMesh rest, const SolidMaterial& material,
                           const Matrix3d& rotation, const Vector3d& translation);

} // namespace rigor
