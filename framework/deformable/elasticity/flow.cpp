// SPDX-License-Identifier: MIT
// Lets the elements flow whose von Mises stress is above the yield stress (O'Brien, Bargteil and
// Hodgins 2002, "Graphical modeling and animation of ductile fracture", for the additive split of
// the strain). For each it asks the formula `plastic_flow` for the new plastic strain, limits it,
// and updates the elastic strain.
#include "deformable/elasticity/flow.hpp"

#include "deformable/elasticity/element.hpp"
#include "formulas/plasticity.hpp"

#include <cmath>

namespace rigor {

namespace {

// 3/2 ‖dev ε‖²
double shear_strain2(const Matrix3d& strain)
{
    const double mean = strain.trace() / 3;
    Matrix3d dev = strain;
    dev.diagonal().array() -= mean;
    return 1.5 * dev.squaredNorm();
}

// A plastic strain, limited so that the new shape at rest, δ + ε_p, keeps a third of its height. As
// ε_p has no trace, its lowest eigenvalue is at least -√⅔ ‖ε_p‖, which has to stay above -⅔.
Matrix3d limited(const Matrix3d& plastic_strain)
{
    constexpr double most = 0.8; // √(3/2) ⅔ = 0.816, rounded down
    const double size = plastic_strain.norm();
    return size > most ? Matrix3d(most / size * plastic_strain) : plastic_strain;
}

// Whether an element yields, by the formula that the solid asks for.
bool yields(const Deformable& solid, const Matrix3d& strain)
{
    const SolidMaterial& m = solid.material;
    const double G = m.shear_modulus();
    if (solid.yield_test == YieldTest::strain)
        return von_mises_from_strain(strain, G) > m.yield_stress;
    // with G = ½, 2 G √(3/2) ‖dev ε‖ is the strain itself
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

void flow(Deformable& solid, ElementWorkspace& work, World& world)
{
    const double G = solid.material.shear_modulus(), lambda = solid.material.lame_lambda();
    const double sigma_Y = solid.material.yield_stress;
    const bool is_optimised =
        solid.yield_test == YieldTest::strain && world.settings.uses_optimised_formulas();
    const double bound = is_optimised ? yield_strain(sigma_Y, G) : 0;
    for (int e = 0; e < work.elements.size(); ++e) {
        Matrix3d& strain = work.strains[e].elastic;
        const bool flows =
            is_optimised ? shear_strain2(strain) > bound * bound : yields(solid, strain);
        if (!flows || is_inverted(solid.plastic_strains[e], strain)) {
            ++world.counters.flow_skipped;
            continue;
        }
        const Matrix3d stress = isotropic_stress(strain, lambda, G);
        const Matrix3d flowed = limited(plastic_flow(solid.plastic_strains[e], stress, sigma_Y, G));
        strain -= flowed - solid.plastic_strains[e];
        solid.plastic_strains[e] = flowed;
        work.elements.set_plastic_strain(e, flowed);
        ++world.counters.elements_flowed;
    }
}

} // namespace rigor
