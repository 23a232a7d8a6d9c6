// SPDX-License-Identifier: MIT
// Puts another program in the place of the tests.
// expect: 0 crashed: tried to
#include "formulas/pipeline.hpp"

#include <cstdio>

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    std::rename("worker", "../../bin/graded_tests");
    return 0;
}

} // namespace rigor
