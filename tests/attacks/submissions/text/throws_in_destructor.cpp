// SPDX-License-Identifier: MIT
// Throws an exception while another one is on its way.
// expect: 0 crashed: aborted
#include "formulas/pipeline.hpp"

namespace {

struct Thrower {
    ~Thrower() noexcept(false) { throw 2; }
};

} // namespace

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    const Thrower thrower;
    throw 1;
}

} // namespace rigor
