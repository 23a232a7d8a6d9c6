// SPDX-License-Identifier: MIT
// The linear system of backward Euler:
//
//     A v = b,   A = (1 + α h) M + h (h + β) K,   b = M v₀ + h f(x₀)
//
// K = R K_rest Rᵀ, element by element, with the rotations of the step's start. Some coordinates do not
// move freely: a handle says where they go, or a contact ties them to a rigid body, which then is part of
// the system with its own six coordinates.
#pragma once

#include "deformable/elasticity/elements.hpp"
#include "deformable/solvers/block_factor.hpp"

#include <Eigen/Cholesky>

namespace rigor {

/// A node whose velocity within a subspace is prescribed: N v = N (c + V + ω × r), with the motion (V, ω)
/// of a rigid body that the system solves for, or of none. What it does against that motion in the rest of
/// space is damped by the impulse -d (δ - N) (v - c - V - ω × r): so friction takes energy, whatever d is.
struct TiedNode {
    int node = 0;
    Matrix3d N = Matrix3d::Zero(); // orthogonal projector: δ, n nᵀ, or axes
    Vector3d c = Vector3d::Zero(); // [m/s]
    int body = -1;                 // among the system's
    Vector3d r = Vector3d::Zero(); // from its center [m]
    double damping = 0;            // d [kg]
};

/// A rigid body that is part of the system.
struct SystemBody {
    double mass = 0;
    Matrix3d inertia = Matrix3d::Zero();                 // in world space
    Vector3d V = Vector3d::Zero(), w = Vector3d::Zero(); // without contacts, then with them
};

/// The system of one solid. A is block diagonal with a block for each of its parts: the pieces of the
/// solid, which nothing but rigid bodies joins. So they are solved for together or apart.
class ImplicitSystem {
public:
    /// The places of the blocks: once for a mesh.
    void analyse(const Elements& elements, int nodes);
    bool is_analysed() const { return !row_starts_.empty(); }
    int parts() const { return parts_; }
    int part_of(int node) const { return part_of_[node]; }

    /// The blocks: once a step.
    void assemble(const Elements& elements, const std::vector<ElementStrain>& strains,
                  const std::vector<double>& masses, const SolidMaterial& material,
                  double time_step);

    /// Solves for the velocities of some parts, by conjugate gradients from those that are passed in. They
    /// come out within 1e-7 of the right-hand side in the preconditioner's norm. That is a factorisation
    /// of A with its ties, where this is cheap: then one iteration is enough, but for rounding and for
    /// bodies. Else it is the diagonal blocks of A.
    /// @param nodes  ascending, all of these parts, with every part that is tied to a body
    /// @param tied   of these nodes
    /// @return iterations
    int solve(const std::vector<Vector3d>& b, const std::vector<int>& nodes,
              const std::vector<TiedNode>& tied, std::vector<SystemBody>& bodies,
              std::vector<Vector3d>& velocities);

    /// A v - b of each of these nodes, of whole parts, after `solve`: where ties are, the impulses that
    /// they and their damping give [N s].
    const std::vector<Vector3d>& missing(const std::vector<Vector3d>& b,
                                         const std::vector<int>& nodes,
                                         const std::vector<Vector3d>& velocities);
    const Matrix3d& diagonal(int node) const { return blocks_[diagonal_[node]]; }
    /// Calls `visit(i, j, A_ij)` for each block that is kept: those with i ≤ j.
    template <class Visit> void for_each_block(const Visit& visit) const
    {
        for (int i = 0; i < nodes_; ++i)
            for (int k = row_starts_[i]; k < row_starts_[i + 1]; ++k)
                visit(i, columns_[k], blocks_[k]);
    }

private:
    void find_parts();
    void multiply(const std::vector<Vector3d>& x, std::vector<Vector3d>& y) const;
    Vector3d against_tie(const TiedNode& tie, const std::vector<Vector3d>& x) const;
    void add_damping(const std::vector<Vector3d>& x, std::vector<Vector3d>& y) const;
    void expand(std::vector<Vector3d>& x) const;
    void reduce(std::vector<Vector3d>& x) const;
    void factorise();
    void prepare_preconditioner(const std::vector<SystemBody>& bodies);
    void precondition(const std::vector<Vector3d>& r, std::vector<Vector3d>& z) const;
    int iterate(double enough);
    double dot(const std::vector<Vector3d>& a, const std::vector<Vector3d>& b) const;

    int nodes_ = 0, parts_ = 0;
    std::vector<int> part_of_; // of each node
    // A is symmetric: the blocks on and above the diagonal are kept, row by row
    std::vector<int> row_starts_, columns_, diagonal_;
    std::vector<Matrix3d> blocks_;
    std::vector<std::array<int, 10>> places_; // of each element's blocks ij, i ≤ j

    BlockFactor factor_; // of A with the ties
    bool is_factor_cheap_ = false;
    std::vector<Matrix3d> tied_blocks_;
    std::vector<Matrix3d> free_; // of each node, the projector on what no tie holds
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
