// SPDX-License-Identifier: MIT
// The material of a deformable solid.
#pragma once

#include "rigid/bodies/world.hpp"

#include <limits>

namespace rigor {

/// Infinity: a time that never comes [s], or a limit that does not exist [Pa].
inline constexpr double never = std::numeric_limits<double>::infinity();

struct SolidMaterial {
    double density = 1000;       // ρ [kg/m³]
    double youngs_modulus = 1e6; // E > 0 [Pa]
    double poisson_ratio = 0.3;  // ν, between -1 and 0.5, both excluded
    double damping = 0;          // β [s] in the force -β K v, where K is the stiffness
    double drag = 0;             // α [1/s] in the force -α m v on each node
    double yield_stress = never; // σ_Y [Pa]; if it is `never`, there is no plastic flow
    double strength = never;     // principal stress above which a crack opens [Pa]
    Material surface;            // restitution and friction in contacts

    double lame_lambda() const // λ [Pa]
    {
        return youngs_modulus * poisson_ratio / ((1 + poisson_ratio) * (1 - 2 * poisson_ratio));
    }
    double shear_modulus() const { return youngs_modulus / (2 * (1 + poisson_ratio)); } // G [Pa]
};

} // namespace rigor
