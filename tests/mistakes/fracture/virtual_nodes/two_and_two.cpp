// SPDX-License-Identifier: MIT
// With two corners on either side of a crack, the share is a sum of two fractions over differences
// between heights, which cancel where both pairs of heights are nearly equal.
#include "formulas/fracture.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numeric>

namespace rigor {

namespace {

using Heights = std::array<double, 4>;
using Cracks = std::vector<const ElementCrack*>;

std::size_t at(int i)
{
    return static_cast<std::size_t>(i);
}

/// A piece of a tetrahedron: its corners as weights of the whole's corners, and its share.
struct Piece {
    std::array<Eigen::Vector4d, 4> corners;
    double share = 1;
};

struct Part {
    unsigned corners = 15; // bit c: corner c belongs to it
    std::vector<Piece> pieces;
};

/// Splits a piece until nothing crosses the plane.
void cut(const Piece& piece, const Heights& heights, std::vector<Piece>& above,
         std::vector<Piece>& below)
{
    for (std::size_t a = 0; a < 4; ++a)
        for (std::size_t b = 0; b < 4; ++b) {
            if (heights[a] <= 0 || heights[b] >= 0) continue;
            const double t = heights[a] / (heights[a] - heights[b]);
            const Eigen::Vector4d middle = (1 - t) * piece.corners[a] + t * piece.corners[b];
            Piece with_a = piece, with_b = piece;
            Heights heights_a = heights, heights_b = heights;
            with_a.corners[b] = middle;
            with_a.share *= t;
            heights_a[b] = 0;
            with_b.corners[a] = middle;
            with_b.share *= 1 - t;
            heights_b[a] = 0;
            cut(with_a, heights_a, above, below);
            cut(with_b, heights_b, above, below);
            return;
        }
    const bool is_below = *std::min_element(heights.begin(), heights.end()) < 0;
    (is_below ? below : above).push_back(piece);
}

/// The parts of a tetrahedron, ordered by their first corner.
std::vector<Part> parts_of(const std::array<Vector3d, 4>& x, const Cracks& cracks)
{
    Piece whole;
    for (int c = 0; c < 4; ++c)
        whole.corners[at(c)] = Eigen::Vector4d::Unit(c);
    std::vector<Part> parts = {Part{15, {whole}}};
    for (const ElementCrack* crack : cracks) {
        Eigen::Vector4d heights = Eigen::Vector4d::Zero();
        unsigned above = 0;
        for (int c = 0; c < 4; ++c) {
            heights(c) = crack->normal.dot(x[at(c)] - crack->point);
            if (heights(c) >= 0) above |= 1u << c;
        }
        std::vector<Part> next;
        for (const Part& part : parts) {
            const unsigned upper = part.corners & above, lower = part.corners & ~above;
            if (upper == 0 || lower == 0) {
                next.push_back(part);
                continue;
            }
            Part up, down;
            up.corners = upper;
            down.corners = lower;
            for (const Piece& piece : part.pieces) {
                Heights piece_heights{};
                for (std::size_t c = 0; c < 4; ++c)
                    piece_heights[c] = piece.corners[c].dot(heights);
                cut(piece, piece_heights, up.pieces, down.pieces);
            }
            next.push_back(up);
            next.push_back(down);
        }
        parts = next;
    }
    std::sort(parts.begin(), parts.end(), [](const Part& a, const Part& b) {
        return (a.corners & (~a.corners + 1)) < (b.corners & (~b.corners + 1));
    });
    return parts;
}

double share_of(const Part& part)
{
    double share = 0;
    for (const Piece& piece : part.pieces)
        share += piece.share;
    return share;
}

double term(double h, double p, double q, double r)
{
    return h * h * h / ((h - p) * (h - q) * (h - r));
}

/// The share above the plane: a and b are above it, c and d are below.
double share_above(double a, double b, double c, double d)
{
    // Each corner of a side adds one term. The side whose heights differ more loses fewer digits.
    const double gap_above = std::abs(a - b), gap_below = std::abs(c - d);
    const double range = std::max(a, b) - std::min(c, d);
    if (std::max(gap_above, gap_below) <= 1e-12 * range) { // two pairs of equal heights
        const double k = -c / (a - c);
        return 1 - k * k * (3 - 2 * k);
    }
    if (gap_above >= gap_below) return term(a, b, c, d) + term(b, a, c, d);
    return 1 - (term(c, d, a, b) + term(d, c, a, b));
}

std::size_t leader(std::vector<std::size_t>& leaders, std::size_t i)
{
    while (leaders[i] != i) {
        leaders[i] = leaders[leaders[i]];
        i = leaders[i];
    }
    return i;
}

} // namespace

EmbeddedMesh virtual_nodes(const TetrahedralMesh& mesh, const std::vector<ElementCrack>& cracks)
{
    const std::size_t count = mesh.tetrahedra.size();
    std::vector<Cracks> lists(count);
    for (const ElementCrack& crack : cracks)
        lists[at(crack.tetrahedron)].push_back(&crack);

    EmbeddedMesh result;
    std::vector<std::vector<std::size_t>> copies(count);
    const auto add_copy = [&](std::size_t e, unsigned corners, double share) {
        copies[e].push_back(result.parents.size());
        result.parents.push_back(static_cast<int>(e));
        std::array<int, 4> real{};
        for (std::size_t c = 0; c < 4; ++c)
            real[c] = (corners >> c) % 2 == 1 ? 1 : 0;
        result.real.push_back(real);
        result.fractions.push_back(share);
    };
    for (std::size_t e = 0; e < count; ++e) {
        std::array<Vector3d, 4> x;
        for (std::size_t c = 0; c < 4; ++c)
            x[c] = mesh.vertices[at(mesh.tetrahedra[e][c])];
        const std::vector<Part> parts = parts_of(x, lists[e]);
        std::vector<double> above, below;
        if (lists[e].size() == 1)
            for (const Vector3d& corner : x) {
                const ElementCrack& crack = *lists[e].front();
                const double height = crack.normal.dot(corner - crack.point);
                (height >= 0 ? above : below).push_back(height);
            }
        const bool two_and_two = above.size() == 2 && below.size() == 2;
        for (const Part& part : parts) {
            double share = share_of(part);
            if (two_and_two) {
                const double upper = share_above(above[0], above[1], below[0], below[1]);
                std::size_t first = 0;
                while ((part.corners >> first) % 2 == 0)
                    ++first;
                const ElementCrack& crack = *lists[e].front();
                share = crack.normal.dot(x[first] - crack.point) >= 0 ? upper : 1 - upper;
            }
            add_copy(e, part.corners, share);
        }
    }

    // Corner i of copy k is number 4 k + i.
    std::vector<std::size_t> leaders(4 * result.parents.size());
    std::iota(leaders.begin(), leaders.end(), std::size_t{0});
    std::map<std::array<int, 3>, std::size_t> seen;
    for (std::size_t e = 0; e < count; ++e)
        for (std::size_t f = 0; f < 4; ++f) {
            const std::array<int, 4>& own = mesh.tetrahedra[e];
            std::array<int, 3> face = {own[(f + 1) % 4], own[(f + 2) % 4], own[(f + 3) % 4]};
            std::sort(face.begin(), face.end());
            const auto [place, is_new] = seen.try_emplace(face, e);
            if (is_new) continue;
            const std::size_t other = place->second;
            const std::array<int, 4>& others = mesh.tetrahedra[other];
            std::array<std::size_t, 4> twin{}; // the corner of the other one at the same vertex
            for (std::size_t c = 0; c < 4; ++c)
                for (std::size_t d = 0; d < 4; ++d)
                    if (others[d] == own[c]) twin[c] = d;
            for (const std::size_t a : copies[e])
                for (const std::size_t b : copies[other]) {
                    bool joined = false;
                    for (std::size_t c = 0; c < 4; ++c)
                        if (c != f && result.real[a][c] == 1 && result.real[b][twin[c]] == 1)
                            joined = true;
                    if (!joined) continue;
                    for (std::size_t c = 0; c < 4; ++c)
                        if (c != f)
                            leaders[leader(leaders, 4 * a + c)] = leader(leaders, 4 * b + twin[c]);
                }
        }

    std::vector<int> names(leaders.size(), -1); // the vertex of each group, at its leader
    std::vector<bool> used(mesh.vertices.size(), false);
    const auto add_vertex = [&](int parent) {
        const int name = static_cast<int>(result.vertex_parents.size());
        result.vertex_parents.push_back(parent);
        result.mesh.vertices.push_back(mesh.vertices[at(parent)]);
        used[at(parent)] = true;
        return name;
    };
    for (std::size_t k = 0; k < result.parents.size(); ++k) {
        std::array<int, 4> corners{};
        for (std::size_t c = 0; c < 4; ++c) {
            int& name = names[leader(leaders, 4 * k + c)];
            if (name < 0) name = add_vertex(mesh.tetrahedra[at(result.parents[k])][c]);
            corners[c] = name;
        }
        result.mesh.tetrahedra.push_back(corners);
    }
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
        if (!used[v]) add_vertex(static_cast<int>(v));
    return result;
}

} // namespace rigor
