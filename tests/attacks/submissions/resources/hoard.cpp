// SPDX-License-Identifier: MIT
// Takes all memory that it gets, and keeps it. It writes none of it, since on some machines two
// gigabytes take longer to fill than a call may last.
// expect: 0 crashed: out of memory
#include "formulas/pipeline.hpp"

#include <memory>
#include <vector>

namespace {

std::vector<std::unique_ptr<double[]>> kept;

} // namespace

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    for (;;)
        kept.emplace_back(new double[1 << 22]);
}

} // namespace rigor
