// SPDX-License-Identifier: MIT
// Throws a text that is not UTF-8.
// expect: 0 crashed: threw an exception: ????
#include "formulas/pipeline.hpp"

#include <stdexcept>

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    throw std::runtime_error("\xff\xfe\xc0\x80");
}

} // namespace rigor
