// SPDX-License-Identifier: MIT
// The parts of a solid that an implicit step still has to solve for.
#pragma once

#include "deformable/solvers/block_matrix.hpp"

namespace rigor {

/// The parts are the connected pieces of the solid: no block of the matrix joins two of them. A
/// part is open if the next solve includes it. After the first solve, only parts whose contacts or
/// plastic flow have changed are opened again. If an open part touches a rigid body that has joined
/// the system (joined_bodies.hpp), all parts that touch any such body are opened too.
class OpenParts {
public:
    /// Opens all parts of a system.
    void open_all(const BlockMatrix& matrix);
    /// Closes all parts. They can then be opened again one by one. `was_open` tells which parts
    /// were open before this call.
    void close_all();

    bool is_open(int node) const { return is_open_[matrix_->part_of(node)] != 0; }
    bool was_open(int node) const { return was_open_[matrix_->part_of(node)] != 0; }
    void open(int node) { is_open_[matrix_->part_of(node)] = 1; }

    /// Lists the nodes of the open parts. @return whether there are any
    bool collect_nodes();
    /// The nodes listed by `collect_nodes`, ascending.
    const std::vector<int>& nodes() const { return nodes_; }

private:
    const BlockMatrix* matrix_ = nullptr;
    std::vector<char> is_open_, was_open_; // for each part
    std::vector<int> nodes_;
};

} // namespace rigor
