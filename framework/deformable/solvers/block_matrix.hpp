// SPDX-License-Identifier: MIT
// The matrix of the implicit system of a solid, in 3 × 3 blocks.
#pragma once

#include "deformable/elasticity/element_flow.hpp"
#include "deformable/elasticity/elements.hpp"
#include "deformable/elasticity/turn_stiffness.hpp"

namespace rigor {

/// A symmetric matrix with a block for each pair of nodes that share an element. Its parts are the
/// connected pieces of the solid. No block connects two parts. So each part can be solved for
/// alone, unless contacts with the same rigid body couple it with other parts.
class BlockMatrix {
public:
    /// Finds which blocks the matrix has. This is needed once for each mesh.
    void analyse(const Elements& elements, int nodes);

    /// Computes the blocks, without plastic flow and tension. This is needed at the start of each
    /// step, and again before each series of calls of `soften`.
    void assemble(const Elements& elements, const std::vector<ElementStrain>& strains,
                  const std::vector<double>& masses, const SolidMaterial& material,
                  double time_step);

    /// Reduces the stiffness of an element by its linearized plastic flow (a, k and n, see
    /// element_flow.hpp):
    /// A_ij -= c V (a (½ gⱼ gᵢᵀ + ½ gᵢ·gⱼ δ - ⅓ gᵢ gⱼᵀ - (k gᵢ) (k gⱼ)ᵀ) + (n gᵢ) (n gⱼ)ᵀ), with
    /// the volume V of the element, g = R ∇N, and k and n in world space.
    ///
    /// @param factor  c = 2 G h² [Pa s²]
    void soften(const Elements& elements, const Matrix3d& R, const ElementFlow& flow,
                double factor);

    /// Adds a term of the geometric stiffness of an element: A_ij += h² cᵢ cⱼᵀ.
    void stiffen(const Elements& elements, const TurnStiffness& term, double time_step);

    /// xᵀ A x
    double quadratic_form(const std::vector<Vector3d>& x) const;

    /// y ← A x for these nodes. They must form whole parts (connected pieces of the solid): A_ij
    /// is stored only for i ≤ j, so the product with A_ji = A_ijᵀ would be missing otherwise.
    void multiply(const std::vector<int>& nodes, const std::vector<Vector3d>& x,
                  std::vector<Vector3d>& y) const;

    int nodes() const { return nodes_; }
    int parts() const { return parts_; }
    int part_of(int node) const { return part_of_[node]; }

    // Only the blocks on and above the diagonal are stored, row by row.
    const std::vector<int>& row_starts() const { return row_starts_; }
    const std::vector<int>& columns() const { return columns_; }
    const std::vector<Matrix3d>& blocks() const { return blocks_; }
    int diagonal_place(int node) const { return diagonal_[node]; }
    const Matrix3d& diagonal(int node) const { return blocks_[diagonal_[node]]; }

    /// Calls `visit(i, j, A_ij)` for each stored block, i ≤ j.
    template <class Visit> void for_each_block(const Visit& visit) const
    {
        for (int i = 0; i < nodes_; ++i)
            for (int k = row_starts_[i]; k < row_starts_[i + 1]; ++k)
                visit(i, columns_[k], blocks_[k]);
    }

private:
    void find_parts();

    int nodes_ = 0, parts_ = 0;
    std::vector<int> part_of_; // for each node, the index of its part
    std::vector<int> row_starts_, columns_, diagonal_;
    std::vector<Matrix3d> blocks_;
    // For each element, the indices in `blocks_` of its blocks ij, where i ≤ j are two of its
    // corners.
    std::vector<std::array<int, 10>> places_;
};

} // namespace rigor
