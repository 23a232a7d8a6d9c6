// SPDX-License-Identifier: MIT
// The linear system of backward Euler:
//
//     A v = b,   A = (1 + α h) M + h (h + β) K + h² K_g,   b = M v₀ + h f(x₀)
//
// M contains the masses, α is the drag, β the damping and h the time step. K is the sum of the
// stiffnesses R K_rest Rᵀ of the elements, with their rotations R at the start of the step. K_g is
// their geometric stiffness, as far as tension makes it necessary (motion/tension.hpp). f is the
// sum of elastic forces, gravity and loads. Some coordinates are not unknowns: a handle prescribes
// them, or a contact ties them to a rigid body. A rigid body that has joined the system
// (motion/joined_bodies.hpp) has six unknowns of its own.
#pragma once

#include "deformable/solvers/block_factor.hpp"
#include "deformable/solvers/block_matrix.hpp"
#include "deformable/solvers/ties.hpp"

namespace rigor {

/// The system of one solid: its matrix, and the solution by conjugate gradients.
class ImplicitSystem {
public:
    /// Finds which blocks the matrix has, and whether a factorization is cheap. This is needed once
    /// for each mesh.
    void analyse(const Elements& elements, int nodes);
    bool is_analysed() const { return matrix_.nodes() > 0; }

    /// Computes the blocks, without plastic flow and tension. This is needed at the start of each
    /// step, and again before each series of calls of `soften`.
    void assemble(const Elements& elements, const std::vector<ElementStrain>& strains,
                  const std::vector<double>& masses, const SolidMaterial& material,
                  double time_step)
    {
        matrix_.assemble(elements, strains, masses, material, time_step);
    }
    /// Reduces the stiffness of an element by its plastic flow, see `BlockMatrix::soften`.
    void soften(const Elements& elements, const Matrix3d& R, const ElementFlow& flow, double factor)
    {
        matrix_.soften(elements, R, flow, factor);
    }
    /// Adds a term of the geometric stiffness, see `BlockMatrix::stiffen`.
    void stiffen(const Elements& elements, const TurnStiffness& term, double time_step)
    {
        matrix_.stiffen(elements, term, time_step);
    }
    const BlockMatrix& matrix() const { return matrix_; }

    /// Solves for the velocities of some parts (connected pieces of the solid) by conjugate
    /// gradients, which start from the velocities passed in. They end when the residual is at most
    /// 1e-7 of the right-hand side, in the norm of the preconditioner, or when a limit in `iterate`
    /// is reached. If a factorization of A with its ties is cheap, it is the preconditioner; then
    /// one iteration is enough, unless rounding errors or rigid bodies require more. Otherwise the
    /// preconditioner consists of the diagonal blocks of A.
    /// @param nodes  all nodes of these parts, ascending; every part tied to one of `bodies` must
    ///               be among them, because the body would otherwise lack the part's impulses
    /// @param tied   the ties of these nodes
    /// @return the number of iterations
    int solve(const std::vector<Vector3d>& b, const std::vector<int>& nodes,
              const std::vector<TiedNode>& tied, std::vector<SystemBody>& bodies,
              std::vector<Vector3d>& velocities);

    /// A v - b for each of these nodes, after `solve`. The nodes must form whole parts (connected
    /// pieces of the solid), because the sum for a node takes all its neighbors. For a tied node
    /// the result is the impulse that its ties, with their damping, gave it [N s].
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
    BlockFactor factor_; // the factorization of A with the ties
    bool is_factor_cheap_ = false;
    std::vector<Matrix3d> tied_blocks_;
    std::vector<Matrix3d> free_; // for each node, the projector on the untied directions
    std::vector<char> is_tied_;

    // The data of the current solve.
    const std::vector<int>* active_ = nullptr; // the nodes that are solved for
    std::vector<int> steps_;                   // the elimination steps of these nodes
    const std::vector<TiedNode>* tied_ = nullptr;
    std::vector<SystemBody>* bodies_ = nullptr;
    std::vector<Matrix3d> inverse_diagonal_;
    std::vector<Matrix6d> inverse_bodies_;
    // For each node a vector, then V, ω of each body.
    std::vector<Vector3d> x_, r_, z_, p_, q_, best_;
};

} // namespace rigor
