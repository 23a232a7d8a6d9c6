// SPDX-License-Identifier: MIT
// A box with two edges of length 0 is taken for a thin rod, whose density is one per length; but
// its mass is 0.
#include "formulas/inertia.hpp"

namespace rigor {

MassProperties solid_box(double density, const Vector3d& size)
{
    const bool line = (size.array() == 0.0).count() == 2; // what is left is a thin rod

    MassProperties body;
    body.mass = line ? density * size.sum() : density * size.x() * size.y() * size.z();
    const Vector3d square = size.cwiseAbs2();
    const Vector3d moments(square.y() + square.z(), square.z() + square.x(),
                           square.x() + square.y());
    body.inertia = (body.mass / 12 * moments).asDiagonal();
    return body;
}

} // namespace rigor
