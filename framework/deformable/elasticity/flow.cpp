// SPDX-License-Identifier: MIT
// Plastic flow of the elements whose von Mises stress is above the yield stress. For each such
// element the code calls `plastic_flow`, limits the plastic strain that this formula returns, and
// updates the elastic strain. The total strain is the sum of an elastic and a plastic part, as in
// O'Brien, Bargteil and Hodgins (2002), "Graphical modeling and animation of ductile fracture".
#include "deformable/elasticity/flow.hpp"

#include "deformable/elasticity/element.hpp"
#include "formulas/plasticity.hpp"

#include <cmath>

namespace rigor {

namespace {

// 3/2 ‖dev ε‖². The von Mises stress of the strain ε is 2 G times the square root of this.
double shear_strain2(const Matrix3d& strain)
{
    const double mean = strain.trace() / 3;
    Matrix3d dev = strain;
    dev.diagonal().array() -= mean;
    return 1.5 * dev.squaredNorm();
}

// The limit of ‖ε_p‖. Plastic flow may shorten an element, but not below a third of its length.
// So the eigenvalues of its shape without stress, δ + ε_p, have to stay above ⅓, and those of ε_p
// above -⅔. As ε_p has no trace, its eigenvalues are at least -√⅔ ‖ε_p‖.
constexpr double most = 0.8; // √(3/2) ⅔ = 0.816, rounded down

// Whether an element with this elastic strain yields, by the yield test of the solid.
bool yields(const Deformable& solid, const Matrix3d& strain)
{
    const SolidMaterial& m = solid.material;
    const double G = m.shear_modulus();
    if (solid.yield_test == YieldTest::strain)
        return von_mises_from_strain(strain, G) > m.yield_stress;
    // With G = ½ the formula returns √(3/2) ‖dev ε‖, a strain, since 2 G = 1.
    if (solid.yield_test == YieldTest::yield_strain)
        return von_mises_from_strain(strain, 0.5) > yield_strain(m.yield_stress, G);
    const Matrix3d stress = isotropic_stress(strain, m.lame_lambda(), G);
    if (solid.yield_test == YieldTest::deviator) return von_mises(stress) > m.yield_stress;
    if (solid.yield_test == YieldTest::frobenius)
        return von_mises_frobenius(stress) > m.yield_stress;
    Eigen::SelfAdjointEigenSolver<Matrix3d> eigen;
    eigen.compute(stress, Eigen::EigenvaluesOnly);
    const Vector3d& s = eigen.eigenvalues();
    return von_mises_principal(s[0], s[1], s[2]) > m.yield_stress;
}

} // namespace

FlowRule::FlowRule(const Deformable& solid, const Settings& settings)
    : solid_(&solid), lambda_(solid.material.lame_lambda()), G_(solid.material.shear_modulus()),
      yield_stress_(solid.material.yield_stress),
      is_optimised_(solid.yield_test == YieldTest::strain && settings.uses_optimised_formulas()),
      bound_(is_optimised_ ? yield_strain(yield_stress_, G_) : 0)
{
}

FlowRule::Flowed FlowRule::flowed(const Matrix3d& plastic, const Matrix3d& elastic) const
{
    Flowed result;
    result.flows =
        is_optimised_ ? shear_strain2(elastic) > bound_ * bound_ : yields(*solid_, elastic);
    if (result.flows && is_inverted(plastic, elastic)) result.flows = false;
    if (!result.flows) return result;
    const Matrix3d stress = isotropic_stress(elastic, lambda_, G_);
    result.asked = plastic_flow(plastic, stress, yield_stress_, G_);
    const double size = result.asked.norm();
    if (size > most) result.share = most / size;
    result.plastic_strain = result.share * result.asked;
    return result;
}

void flow(Deformable& solid, ElementWorkspace& work, const Settings& settings, Counters& counters)
{
    const FlowRule rule(solid, settings);
    for (int e = 0; e < work.elements.size(); ++e) {
        Matrix3d& strain = work.strains[e].elastic;
        const FlowRule::Flowed flowed = rule.flowed(solid.plastic_strains[e], strain);
        if (!flowed.flows) {
            ++counters.flow_skipped;
            continue;
        }
        strain -= flowed.plastic_strain - solid.plastic_strains[e];
        solid.plastic_strains[e] = flowed.plastic_strain;
        work.elements.set_plastic_strain(e, flowed.plastic_strain);
        ++counters.elements_flowed;
    }
}

} // namespace rigor
