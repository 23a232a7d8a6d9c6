// SPDX-License-Identifier: MIT
// Takes all memory that it gets, and keeps it.
// expect: 0 crashed: out of memory
#include "formulas/pipeline.hpp"

#include <vector>

namespace {

std::vector<std::vector<double>> kept;

} // namespace

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    for (;;)
        kept.emplace_back(1 << 22, 1.0);
}

} // namespace rigor
