// SPDX-License-Identifier: MIT
// Computes deformation gradient, elastic strain, stress and energy of one corotated linear
// tetrahedron (Müller and Gross 2004). Each of these follows from the one before it.
#include "deformable/elasticity/element.hpp"

#include "deformable/elasticity/polar_decomposition.hpp"
#include "formulas/plasticity.hpp"

namespace rigor {

Matrix3d deformation_gradient(const Deformable& solid, int element)
{
    const auto& t = solid.rest.tetrahedra[element];
    Matrix3d D, D_rest;
    for (int i = 0; i < 3; ++i) {
        D.col(i) = solid.positions[t[i + 1]] - solid.positions[t[0]];
        D_rest.col(i) = solid.rest.vertices[t[i + 1]] - solid.rest.vertices[t[0]];
    }
    return D * D_rest.inverse();
}

Matrix3d elastic_strain(const Deformable& solid, int element)
{
    const Polar polar = polar_decomposition(deformation_gradient(solid, element));
    return polar.S - Matrix3d::Identity() - solid.plastic_strains[element];
}

Matrix3d stress_of(const Deformable& solid, int element)
{
    const SolidMaterial& m = solid.material;
    return isotropic_stress(elastic_strain(solid, element), m.lame_lambda(), m.shear_modulus());
}

std::vector<Matrix3d> element_stresses(const Deformable& solid)
{
    std::vector<Matrix3d> stresses;
    stresses.reserve(solid.rest.tetrahedra.size());
    for (int e = 0; e < static_cast<int>(solid.rest.tetrahedra.size()); ++e)
        stresses.push_back(stress_of(solid, e));
    return stresses;
}

double energy_density(const Deformable& solid, int element)
{
    const SolidMaterial& m = solid.material;
    const Matrix3d e = elastic_strain(solid, element);
    // ½ λ Tr(ε)² + G ‖ε‖², with the elastic strain ε
    return 0.5 * m.lame_lambda() * e.trace() * e.trace() + m.shear_modulus() * e.squaredNorm();
}

bool is_inverted(const Matrix3d& plastic, const Matrix3d& elastic)
{
    const Matrix3d strain = plastic + elastic;
    // If ‖strain‖ < 1, all its eigenvalues are above -1, so the determinant below is positive.
    if (strain.squaredNorm() < 1) return false;
    return (Matrix3d::Identity() + strain).determinant() <= 0;
}

} // namespace rigor
