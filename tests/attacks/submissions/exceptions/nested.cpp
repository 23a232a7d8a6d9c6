// SPDX-License-Identifier: MIT
// An exception in an exception, ten thousand deep.
// expect: 0 crashed
#include "formulas/pipeline.hpp"

#include <exception>
#include <stdexcept>

namespace rigor {

void deeper(int n)
{
    try {
        if (n == 0) throw std::runtime_error("\033[2J");
        deeper(n - 1);
    } catch (...) {
        std::throw_with_nested(std::runtime_error("around it"));
    }
}

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    deeper(10'000);
    return 1;
}

} // namespace rigor
