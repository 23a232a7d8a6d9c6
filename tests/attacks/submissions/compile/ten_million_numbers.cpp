// SPDX-License-Identifier: MIT
// A pack of ten million numbers.
// expect: 0 compile_error|passed
#include "formulas/pipeline.hpp"

#include <utility>

namespace rigor {

double kinetic_energy(double mass, const Vector3d& velocity, const Matrix3d& inertia,
                      const Vector3d& angular_velocity)
{
    return 0.5 * mass * velocity.squaredNorm() +
           0.5 * angular_velocity.dot(inertia * angular_velocity);
}

} // namespace rigor

template <std::size_t... n> constexpr std::size_t sum(std::index_sequence<n...>)
{
    return (n + ...);
}

static_assert(sum(std::make_index_sequence<10'000'000>()) > 0);
