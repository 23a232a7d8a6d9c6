// SPDX-License-Identifier: MIT
// Throws a text that is markup, a formula of a spreadsheet, and the end of a string.
// expect: 0 crashed: threw an exception
#include "formulas/pipeline.hpp"

#include <stdexcept>

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    throw std::runtime_error("=cmd|'/c calc'!A1,\"</pre><script>alert(1)</script>]]>&lt;");
}

} // namespace rigor
