// SPDX-License-Identifier: MIT
// Throws the type that the worker throws inside when a formula is missing.
// expect: 0 crashed|compile_error|failed
#include "formulas/pipeline.hpp"

namespace rigor {

struct MissingFormula {
    unsigned index;
};

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    throw MissingFormula{1u << 31};
}

} // namespace rigor
