// SPDX-License-Identifier: MIT
// Keeps track of the parts of a solid that an implicit step still has to solve for. All parts are
// open at first; after each solve they are closed, and those whose contacts or plastic flow have
// changed are opened again, together with parts that rigid bodies couple with them.
#include "deformable/motion/open_parts.hpp"

#include <algorithm>

namespace rigor {

void OpenParts::open_all(const BlockMatrix& matrix)
{
    matrix_ = &matrix;
    is_open_.assign(matrix.parts(), 1);
}

void OpenParts::close_all()
{
    was_open_ = is_open_;
    std::fill(is_open_.begin(), is_open_.end(), 0);
}

bool OpenParts::collect_nodes()
{
    nodes_.clear();
    for (int i = 0; i < matrix_->nodes(); ++i)
        if (is_open(i)) nodes_.push_back(i);
    return !nodes_.empty();
}

} // namespace rigor
