// SPDX-License-Identifier: MIT
// All integrators of free flight, for tests of what every one of them does.
#pragma once

#include "rigid/bodies/settings.hpp"

namespace rigor::testing {

inline constexpr Integrator all_integrators[] = {
    Integrator::matrix,      Integrator::linear,       Integrator::exponential,  Integrator::buss,
    Integrator::runge_kutta, Integrator::gram_schmidt, Integrator::euler_angles, Integrator::exact};

} // namespace rigor::testing
