// SPDX-License-Identifier: MIT
// Constants that need all memory of the compiler.
// expect: 0 compile_error|passed
#include "formulas/pipeline.hpp"

#include <vector>

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    return 0.5 * mass * velocity.squaredNorm() +
           0.5 * angular_velocity.dot(inertia * angular_velocity);
}

} // namespace rigor

consteval std::size_t hoard()
{
    std::vector<double> all;
    for (std::size_t i = 0; i < (std::size_t{1} << 40); ++i)
        all.push_back(1);
    return all.size();
}

static_assert(hoard() > 0);
