// SPDX-License-Identifier: MIT
// Ends the program with success.
// expect: 0 crashed: ended the program: exit status 0
#include "formulas/pipeline.hpp"

#include <cstdlib>

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    std::exit(0);
}

} // namespace rigor
