// SPDX-License-Identifier: MIT
// All integrators of free flight, for tests of what every one of them does.
#pragma once

#include "rigid/bodies/settings.hpp"

#include <iterator>

namespace rigor::testing {

inline constexpr Integrator all_integrators[] = {
    Integrator::matrix,      Integrator::linear,       Integrator::exponential,  Integrator::buss,
    Integrator::runge_kutta, Integrator::gram_schmidt, Integrator::euler_angles, Integrator::exact};
static_assert(std::size(all_integrators) == static_cast<std::size_t>(Integrator::exact) + 1);

} // namespace rigor::testing
