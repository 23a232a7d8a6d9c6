// SPDX-License-Identifier: MIT
// Throws a text that clears a terminal and turns the order of letters round.
// expect: 0 crashed: threw an exception: ?[2J
#include "formulas/pipeline.hpp"

#include <stdexcept>

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    throw std::runtime_error("\033[2J\033]0;owned\007\u202E\u2066 1 of 1 points");
}

} // namespace rigor
