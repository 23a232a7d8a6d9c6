// SPDX-License-Identifier: MIT
// A factorization of a sparse, symmetric, positive definite matrix of 3 × 3 blocks:
//
//     A = L D Lᵀ,   L with ones on its diagonal, D with 3 × 3 blocks on its diagonal
//
// L is computed row by row (Davis 2006, "Direct methods for sparse linear systems", 4.7), with the
// nodes in an order that keeps L sparse.
//
// Eigen has such a factorization, but this one has two advantages. First, it can factorize only
// those parts of A again whose contacts or plastic flow have changed. (A part is a piece of the
// solid that A does not connect with other pieces.) Second, it allocates no memory during a step.
#pragma once

#include "formulas/types.hpp"

#include <vector>

namespace rigor {

class BlockFactor {
public:
    /// Finds the order of the nodes and which blocks L has. This is needed once for each pattern of
    /// A.
    /// @param row_starts, columns  the pattern of A's blocks on and above the diagonal, in each row
    ///                             with ascending columns
    /// @param most_work  the largest number of products of two blocks that a factorization may take
    /// @return whether a factorization takes at most `most_work` products; if not, the analysis was
    ///         broken off, and `factorise` cannot be called
    bool analyse(const std::vector<int>& row_starts, const std::vector<int>& columns,
                 double most_work);

    /// Lists in `steps` the steps in which these nodes are eliminated, ascending. `factorise` and
    /// `solve` compute with these steps only. So the nodes must form whole parts: a node that A
    /// connects with one of them, but that is not among them, would be left out.
    void steps_of(const std::vector<int>& nodes, std::vector<int>& steps) const;

    /// Computes the rows of L and D for these steps (see `steps_of`).
    /// @param blocks  all blocks of A, in the order of A's pattern
    void factorise(const std::vector<int>& steps, const std::vector<Matrix3d>& blocks);

    /// x ← A⁻¹ x, for the nodes of these steps. @param x  one vector for each node of A
    void solve(const std::vector<int>& steps, std::vector<Vector3d>& x) const;

private:
    void place_entries(const std::vector<int>& row_starts, const std::vector<int>& columns);
    bool grow_tree(double most_work);
    void place_rows();

    // In all members below, a node is numbered by its step of elimination. `node_of_` and
    // `step_of_` convert between these steps and the indices of nodes in A.
    std::vector<int> node_of_, step_of_;
    // A's blocks left of the diagonal, row by row: their indices in the list of A's blocks, and
    // whether that list has the transposed block. `diagonal_` has the indices of the diagonal
    // blocks.
    struct Entry {
        int column, block;
        bool is_transposed;
    };
    std::vector<int> entry_starts_, diagonal_;
    std::vector<int> parent_; // for each step, its parent in the elimination tree
    std::vector<Entry> entries_;
    // The blocks of L below its diagonal are stored column by column. `row_blocks_` lists them row
    // by row, with their columns and their indices in `L_`.
    struct RowBlock {
        int column, at;
    };
    std::vector<int> column_starts_, rows_, row_block_starts_;
    std::vector<RowBlock> row_blocks_;
    std::vector<Matrix3d> L_, inverse_D_;
    std::vector<Matrix3d> row_; // the row of L D that is being computed
    double work_ = 0;
};

} // namespace rigor
