// SPDX-License-Identifier: MIT
// Throws an exception of a type of the worker's, and names a formula that does not exist.
// expect: 0 compile_error: is not defined
#include "formulas/pipeline.hpp"

namespace rigor {

struct MissingFormula {
    unsigned index;
};

} // namespace rigor

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    throw MissingFormula{4000000000};
}

} // namespace rigor
