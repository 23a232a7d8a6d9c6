// SPDX-License-Identifier: MIT
// Finds the connected pieces of a solid by union-find on its vertices: each element joins its four
// vertices, then the sets are numbered in the order of the elements.
#include "deformable/solid/pieces.hpp"

#include <numeric>

namespace rigor {

std::vector<int> pieces(const Deformable& solid)
{
    std::vector<int> parent(solid.rest.vertices.size());
    std::iota(parent.begin(), parent.end(), 0);
    const auto root = [&](int v) {
        while (parent[v] != v)
            v = parent[v] = parent[parent[v]];
        return v;
    };
    for (const auto& t : solid.rest.tetrahedra)
        for (int i = 1; i < 4; ++i)
            parent[root(t[i])] = root(t[0]);

    std::vector<int> number(parent.size(), -1), pieces;
    int count = 0;
    for (const auto& t : solid.rest.tetrahedra) {
        int& n = number[root(t[0])];
        if (n < 0) n = count++;
        pieces.push_back(n);
    }
    return pieces;
}

} // namespace rigor
