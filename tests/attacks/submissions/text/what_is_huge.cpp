// SPDX-License-Identifier: MIT
// Throws an exception with a text of a hundred megabytes.
// expect: 0 crashed: threw an exception: xxxx
#include "formulas/pipeline.hpp"

#include <stdexcept>
#include <string>

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    throw std::runtime_error(std::string(100 << 20, 'x'));
}

} // namespace rigor
