// SPDX-License-Identifier: MIT
// The material of a deformable solid.
#pragma once

#include "rigid/bodies/world.hpp"

#include <limits>

namespace rigor {

inline constexpr double never = std::numeric_limits<double>::infinity();

/// The material of a deformable solid.
struct SolidMaterial {
    double density = 1000;       // ρ [kg/m³]
    double youngs_modulus = 1e6; // E > 0 [Pa]
    double poisson_ratio = 0.3;  // ν, -1 … 0.5, both excluded
    double damping = 0;          // β in the force -β K v, against the strain rate [s]
    double drag = 0;             // α in the force -α m v, against the motion [1/s]
    double yield_stress = never; // σ_Y [Pa]
    double strength = never;     // largest principal stress that opens no crack [Pa]
    Material surface;            // restitution and friction in contacts

    double lame_lambda() const // λ [Pa]
    {
        return youngs_modulus * poisson_ratio / ((1 + poisson_ratio) * (1 - 2 * poisson_ratio));
    }
    double shear_modulus() const { return youngs_modulus / (2 * (1 + poisson_ratio)); } // G [Pa]
};

} // namespace rigor
