// SPDX-License-Identifier: MIT
// The linear system of backward Euler:
//
//     A v = b,   A = (1 + α h) M + h (h + β) K,   b = M v₀ + h f(x₀)
//
// K = R K_rest Rᵀ for each element, with the rotations at the start of the step. Some coordinates
// are not free: a handle prescribes them, or a contact ties them to a rigid body, which then is
// part of the system with six coordinates of its own.
#pragma once

#include "deformable/solvers/block_factor.hpp"
#include "deformable/solvers/block_matrix.hpp"
#include "deformable/solvers/ties.hpp"

namespace rigor {

/// The system of one solid: its matrix, and the solution by conjugate gradients.
class ImplicitSystem {
public:
    /// The places of the blocks, and whether a factorisation is cheap: once for a mesh.
    void analyse(const Elements& elements, int nodes);
    bool is_analysed() const { return matrix_.nodes() > 0; }

    /// The blocks: once a step.
    void assemble(const Elements& elements, const std::vector<ElementStrain>& strains,
                  const std::vector<double>& masses, const SolidMaterial& material,
                  double time_step)
    {
        matrix_.assemble(elements, strains, masses, material, time_step);
    }
    const BlockMatrix& matrix() const { return matrix_; }

    /// Solves for the velocities of some parts, by conjugate gradients from those that are passed
    /// in. They come out within 1e-7 of the right-hand side in the preconditioner's norm. That is a
    /// factorisation of A with its ties, where this is cheap: then one iteration is enough, but for
    /// rounding and for bodies. Else it is the diagonal blocks of A.
    /// @param nodes  ascending, all of these parts, with every part that is tied to a body
    /// @param tied   of these nodes
    /// @return iterations
    int solve(const std::vector<Vector3d>& b, const std::vector<int>& nodes,
              const std::vector<TiedNode>& tied, std::vector<SystemBody>& bodies,
              std::vector<Vector3d>& velocities);

    /// A v - b of each of these nodes, of whole parts, after `solve`: where ties are, the impulses
    /// that they and their damping give [N s].
    const std::vector<Vector3d>& residual(const std::vector<Vector3d>& b,
                                          const std::vector<int>& nodes,
                                          const std::vector<Vector3d>& velocities);

private:
    Vector3d damping_impulse(const TiedNode& tie, const std::vector<Vector3d>& x) const;
    void add_damping(const std::vector<Vector3d>& x, std::vector<Vector3d>& y) const;
    void expand(std::vector<Vector3d>& x) const;
    void reduce(std::vector<Vector3d>& x) const;
    void multiply(const std::vector<Vector3d>& x, std::vector<Vector3d>& y) const;
    void factorise();
    void prepare_preconditioner(const std::vector<SystemBody>& bodies);
    void precondition(const std::vector<Vector3d>& r, std::vector<Vector3d>& z) const;
    int iterate(double enough);
    double dot(const std::vector<Vector3d>& a, const std::vector<Vector3d>& b) const;

    BlockMatrix matrix_; // A
    int nodes_ = 0;
    BlockFactor factor_; // factors of A with the ties
    bool is_factor_cheap_ = false;
    std::vector<Matrix3d> tied_blocks_;
    std::vector<Matrix3d> free_; // for each node, the projector on what no tie holds
    std::vector<char> is_tied_;

    // of the solve at hand
    const std::vector<int>* active_ = nullptr; // nodes
    std::vector<int> steps_;                   // in the factorisation
    const std::vector<TiedNode>* tied_ = nullptr;
    std::vector<SystemBody>* bodies_ = nullptr;
    std::vector<Matrix3d> inverse_diagonal_;
    std::vector<Matrix6d> inverse_bodies_;
    std::vector<Vector3d> x_, r_, z_, p_, q_; // nodes, then V and ω of each body
};

} // namespace rigor
