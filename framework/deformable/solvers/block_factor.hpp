// SPDX-License-Identifier: MIT
// A factorisation of a sparse symmetric matrix of 3 × 3 blocks, positive definite:
//
//     A = L D Lᵀ,   L with ones on its diagonal, D with 3 × 3 blocks on its own
//
// Row after row (Davis 2006, "Direct methods for sparse linear systems", 4.7), the nodes in an order that
// keeps L sparse.
#pragma once

#include "formulas/types.hpp"

#include <vector>

namespace rigor {

class BlockFactor {
public:
    /// The order of the nodes and the places of L's blocks: once for a pattern.
    /// @param row_starts, columns  of A's blocks on and above the diagonal, each row ascending
    /// @param most_work  products of blocks that a factorisation may take
    /// @return whether that is enough; if not there is nothing to factorise
    bool analyse(const std::vector<int>& row_starts, const std::vector<int>& columns,
                 double most_work);

    /// Where in the order of elimination some nodes are, ascending: all of some parts that A does not
    /// connect with others. What follows is about such nodes.
    void steps_of(const std::vector<int>& nodes, std::vector<int>& steps) const;

    /// The numbers. @param blocks  of A, in the order of its pattern
    void factorise(const std::vector<int>& steps, const std::vector<Matrix3d>& blocks);

    /// x ← A⁻¹ x
    void solve(const std::vector<int>& steps, std::vector<Vector3d>& x) const;

private:
    void place_entries(const std::vector<int>& row_starts, const std::vector<int>& columns);
    bool grow_tree(double most_work);
    void place_rows();

    // Nodes are numbered here in the order of their elimination.
    std::vector<int> node_of_, step_of_;
    // A's blocks left of the diagonal, row by row: where they are among its blocks, and whether transposed
    struct Entry {
        int column, block;
        bool is_transposed;
    };
    std::vector<int> entry_starts_, diagonal_;
    std::vector<int> parent_; // of each step in the elimination tree
    std::vector<Entry> entries_;
    // L below its diagonal, column by column, and where each row's blocks are in it
    struct Place {
        int column, at;
    };
    std::vector<int> column_starts_, rows_, place_starts_;
    std::vector<Place> places_;
    std::vector<Matrix3d> L_, inverse_D_;
    std::vector<Matrix3d> row_; // that is being computed
    double work_ = 0;
};

} // namespace rigor
