// SPDX-License-Identifier: MIT
#pragma once

#include <numeric>
#include <vector>

namespace rigor {

/// Things that belong together once they were joined, directly or through others (union–find).
class Groups {
public:
    explicit Groups(std::size_t size) : parents_(size)
    {
        std::iota(parents_.begin(), parents_.end(), 0);
    }

    /// The group that i is in, named by one of its members.
    int of(int i)
    {
        while (parents_[i] != i)
            i = parents_[i] = parents_[parents_[i]];
        return i;
    }
    void join(int i, int j) { parents_[of(j)] = of(i); }

private:
    std::vector<int> parents_;
};

} // namespace rigor
