// SPDX-License-Identifier: MIT
// With two corners on either side of a crack, the share is a sum of two fractions over differences
// between heights, which cancel where the heights of two corners are nearly equal.
#include "mistakes/fracture/copy_rules.hpp"

namespace rigor {

EmbeddedMesh virtual_nodes(const TetrahedralMesh& mesh, const std::vector<ElementCrack>& cracks)
{
    cutting::CopyRules rules;
    EmbeddedMesh result = cutting::copies_by(rules, mesh, cracks);
    for (std::size_t i = 0; i < result.parents.size(); ++i) {
        std::vector<ElementCrack> own;
        for (const ElementCrack& crack : cracks)
            if (crack.tetrahedron == result.parents[i]) own.push_back(crack);
        const std::array<int, 4>& real = result.real[i];
        if (own.size() != 1 || std::accumulate(real.begin(), real.end(), 0) != 2) continue;
        std::array<double, 4> h;
        for (int c = 0; c < 4; ++c)
            h[c] = own[0].normal.dot(mesh.vertices[mesh.tetrahedra[result.parents[i]][c]] -
                                     own[0].point);
        double share = 0; // Σ hᵢ³/Π (hᵢ - hⱼ) over the corners i of this side
        for (int c = 0; c < 4; ++c) {
            if (real[c] == 0) continue;
            double part = h[c] * h[c] * h[c];
            for (int other = 0; other < 4; ++other)
                if (other != c) part /= h[c] - h[other];
            share += part;
        }
        if (std::isfinite(share)) result.fractions[i] = share;
    }
    return result;
}

} // namespace rigor
