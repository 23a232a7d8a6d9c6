// SPDX-License-Identifier: MIT
#pragma once

#include <numeric>
#include <vector>

namespace rigor {

/// Disjoint sets of the numbers 0 … size - 1 (union–find with path halving).
class UnionFind {
public:
    explicit UnionFind(std::size_t size) : parents_(size)
    {
        std::iota(parents_.begin(), parents_.end(), 0);
    }

    /// The representative of the set that holds i.
    int find(int i)
    {
        while (parents_[i] != i)
            i = parents_[i] = parents_[parents_[i]];
        return i;
    }
    /// Makes one set of the sets that hold i and j.
    void unite(int i, int j) { parents_[find(j)] = find(i); }

private:
    std::vector<int> parents_;
};

} // namespace rigor
