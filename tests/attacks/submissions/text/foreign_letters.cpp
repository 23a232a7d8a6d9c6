// SPDX-License-Identifier: MIT
// Names in other alphabets, one of which is defined nowhere.
// expect: 0 crashed|compile_error
#include "formulas/pipeline.hpp"

namespace rigor {

double ενέργεια(double 質量);

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    return ενέργεια(1);
}

} // namespace rigor
