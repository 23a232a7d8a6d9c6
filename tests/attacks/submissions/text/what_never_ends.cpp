// SPDX-License-Identifier: MIT
// Throws an exception whose text is computed without end.
// expect: 0 timed_out
#include "formulas/pipeline.hpp"

#include <exception>

namespace {

struct Endless : std::exception {
    const char* what() const noexcept override
    {
        for (volatile unsigned i = 0;; i = i + 1) {
        }
    }
};

} // namespace

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    throw Endless();
}

} // namespace rigor
