// SPDX-License-Identifier: MIT
// The linear system of backward Euler:
//
//     A v = b,   A = (1 + α h) M + h (h + β) K,   b = M v₀ + h f(x₀)
//
// K = R K_rest Rᵀ, element by element, with the rotations of the step's start. Some coordinates do not
// move freely: a handle says where they go, or a contact ties them to a rigid body, which then is part of
// the system with its own six coordinates.
#pragma once

#include "deformable/elements.hpp"

#include <Eigen/Cholesky>

namespace rigor {

/// A node whose velocity within a subspace is prescribed: N v = N (c + V + ω × r), with the motion (V, ω)
/// of a rigid body that the system solves for, or of none.
struct TiedNode {
    int node = 0;
    Matrix3d N = Matrix3d::Zero(); // orthogonal projector: δ, n nᵀ, or axes
    Vector3d c = Vector3d::Zero(); // [m/s]
    int body = -1;                 // among the system's
    Vector3d r = Vector3d::Zero(); // from its center [m]
};

/// A rigid body that is part of the system.
struct SystemBody {
    double mass = 0;
    Matrix3d inertia = Matrix3d::Zero();                 // in world space
    Vector3d V = Vector3d::Zero(), w = Vector3d::Zero(); // without contacts, then with them
};

class ImplicitSystem {
public:
    /// The places of the blocks: once for a mesh.
    void analyse(const Elements& elements, int nodes);
    bool is_analysed() const { return !row_starts_.empty(); }

    /// The blocks: once a step.
    void assemble(const Elements& elements, const std::vector<ElementStrain>& strains,
                  const std::vector<double>& masses, const SolidMaterial& material,
                  double time_step);

    /// Solves for the velocities, by conjugate gradients from those that are passed in, preconditioned
    /// block by block. They come out within 1e-7 of the right-hand side in the preconditioner's norm.
    /// @return iterations
    int solve(const std::vector<Vector3d>& b, const std::vector<TiedNode>& tied,
              std::vector<SystemBody>& bodies, std::vector<Vector3d>& velocities);

    /// A v - b of each node after `solve`: where ties are, the impulses that they give [N s].
    const std::vector<Vector3d>& missing(const std::vector<Vector3d>& b,
                                         const std::vector<Vector3d>& velocities);
    /// Calls `visit(i, j, A_ij)` for each block that is kept: those with i ≤ j.
    template <class Visit> void for_each_block(const Visit& visit) const
    {
        for (int i = 0; i < nodes_; ++i)
            for (int k = row_starts_[i]; k < row_starts_[i + 1]; ++k)
                visit(i, columns_[k], blocks_[k]);
    }

private:
    void multiply(const std::vector<Vector3d>& x, std::vector<Vector3d>& y) const;
    void expand(std::vector<Vector3d>& x) const;
    void reduce(std::vector<Vector3d>& x) const;
    void prepare_preconditioner(const std::vector<SystemBody>& bodies);
    void precondition(const std::vector<Vector3d>& r, std::vector<Vector3d>& z) const;

    int nodes_ = 0;
    // A is symmetric: the blocks on and above the diagonal are kept, row by row
    std::vector<int> row_starts_, columns_, diagonal_;
    std::vector<Matrix3d> blocks_;
    std::vector<std::array<int, 10>> places_; // of each element's blocks ij, i ≤ j

    // of the solve at hand
    const std::vector<TiedNode>* tied_ = nullptr;
    std::vector<SystemBody>* bodies_ = nullptr;
    std::vector<Matrix3d> inverse_diagonal_;
    std::vector<Matrix6d> inverse_bodies_;
    std::vector<Vector3d> x_, r_, z_, p_, q_; // nodes, then V and ω of each body
};

} // namespace rigor
