// SPDX-License-Identifier: MIT
// The tension of a solid, as far as an implicit step must foresee its change.
#pragma once

#include "deformable/elasticity/element_workspace.hpp"
#include "deformable/elasticity/turn_stiffness.hpp"
#include "deformable/solid/handles.hpp"
#include "deformable/solvers/block_matrix.hpp"

namespace rigor {

/// Finds the terms of the geometric stiffness K_g that the system of an implicit step needs to be
/// stable. Displacements u change the elastic energy of an element, to second order, by
///
///     ½ uᵀ (K + K_g) u,   uᵀ K_g u = ½ V aᵀ (Tr S δ - S)⁻¹ (Tr σ δ - σ) a,   a = Σ (R ∇Nᵢ) × uᵢ
///
/// Here K = R K_rest Rᵀ is the stiffness for a constant rotation R, and a is twice the angle by
/// which u turns the element (the twist modes of Smith, de Goes and Kim 2019, "Analytic
/// eigensystems for isotropic distortion energies"). As strains are small, Tr S δ - S is taken as
/// 2 δ. With the principal stresses σ_k and their directions n_k in world space, the terms are
///
///     cᵢ = √(V q/2) n_k × (R ∇Nᵢ),   q = ½ (Tr σ - σ_k) - q₀,   if q > 0
///
/// Compression has no terms. So K_g is positive semi-definite, and the system stays positive
/// definite (Teran et al. 2005, "Robust quasistatic finite elements and flesh simulation").
///
/// q₀ is the part of the stress that the step may leave out. Let a motion x have the mass m, the
/// stiffness k in K, and g in the part of K_g that is left out. A step takes the force -(k + g) x
/// from its start, but solves with k alone:
///
///     (m + h² k) (x₊ - x) = m (x - x₋) - h² (k + g) x
///
/// This is stable for g < 4 m/h² + k. Beyond that, x changes its sign and grows in each step. So a
/// bar under tension would tear itself apart sideways, where the tension holds it most. As long as
/// it is stable, g is better left out, because it makes the step lose energy: a pendulum would soon
/// stop. The source says how q₀ is found.
class Tension {
public:
    /// @param matrix  the matrix of the solid, which knows its parts
    /// @param held    the nodes that handles hold
    void find(const Deformable& solid, const ElementWorkspace& work, const BlockMatrix& matrix,
              const std::vector<HeldNode>& held, double time_step);

    const std::vector<TurnStiffness>& terms() const { return terms_; }

private:
    // A connected piece of the solid.
    struct Part {
        double mass = 0;                    // [kg]
        Vector3d center = Vector3d::Zero(); // the mean of the held nodes, or the center of mass [m]
        int held_nodes = 0;                 // how many
        Matrix3d inertia = Matrix3d::Zero(); // about the center [kg m²]
        Matrix3d turn = Matrix3d::Zero();    // K_g of a turn of the whole part [N m]
        double share = 1;                    // the share of the stress that may be left out
    };
    void find_shares(const Deformable& solid, const ElementWorkspace& work,
                     const BlockMatrix& matrix, const std::vector<HeldNode>& held,
                     double time_step);
    void add_terms(const Deformable& solid, const ElementWorkspace& work, int element, double share,
                   double time_step);

    std::vector<int> tense_; // the elements that may have terms
    std::vector<Part> parts_;
    std::vector<TurnStiffness> terms_;
};

} // namespace rigor
