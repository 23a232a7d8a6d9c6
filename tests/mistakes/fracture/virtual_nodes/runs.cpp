// SPDX-License-Identifier: MIT
// The cracks of a tetrahedron are read as one run of the list; a later run replaces an earlier one.
#include "formulas/fracture.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>

namespace rigor {

namespace {

using Weights = std::array<double, 4>; // of the corners

struct Piece {
    std::array<Weights, 4> points;
    double share = 1;
};

// Some corners of a tetrahedron, one bit for each, and their material.
struct Part {
    unsigned corners = 0;
    std::vector<Piece> pieces;
};

void cut(const Piece& piece, const std::array<double, 4>& heights, Part& upper, Part& lower)
{
    std::size_t a = 4;
    std::size_t b = 4;
    for (std::size_t i = 0; i < 4; ++i) {
        if (heights[i] > 0) a = i;
        if (heights[i] < 0) b = i;
    }
    if (b == 4) {
        upper.pieces.push_back(piece);
        return;
    }
    if (a == 4) {
        lower.pieces.push_back(piece);
        return;
    }
    const double t = heights[a] / (heights[a] - heights[b]);
    Weights middle{};
    for (std::size_t i = 0; i < 4; ++i)
        middle[i] = (1.0 - t) * piece.points[a][i] + t * piece.points[b][i];
    Piece first = piece;
    std::array<double, 4> first_heights = heights;
    first.points[a] = middle;
    first_heights[a] = 0;
    first.share *= 1.0 - t;
    cut(first, first_heights, upper, lower);
    Piece second = piece;
    std::array<double, 4> second_heights = heights;
    second.points[b] = middle;
    second_heights[b] = 0;
    second.share *= t;
    cut(second, second_heights, upper, lower);
}

void divide(std::vector<Part>& parts, const std::array<double, 4>& heights)
{
    unsigned up = 0;
    for (unsigned i = 0; i < 4; ++i)
        if (heights[i] >= 0) up |= 1U << i;
    const std::size_t count = parts.size();
    for (std::size_t p = 0; p < count; ++p) {
        Part upper;
        Part lower;
        upper.corners = parts[p].corners & up;
        lower.corners = parts[p].corners & ~up;
        if (upper.corners == 0 || lower.corners == 0) continue;
        for (const Piece& piece : parts[p].pieces) {
            std::array<double, 4> at{};
            for (std::size_t k = 0; k < 4; ++k)
                for (std::size_t i = 0; i < 4; ++i)
                    at[k] += piece.points[k][i] * heights[i];
            cut(piece, at, upper, lower);
        }
        parts[p] = upper;
        parts.push_back(lower);
    }
}

unsigned lowest_bit(unsigned corners)
{
    return corners & (~corners + 1U);
}

struct Copy {
    std::size_t parent = 0;
    unsigned corners = 0;
    double share = 0;
};

std::size_t root_of(std::vector<std::size_t>& above, std::size_t corner)
{
    while (above[corner] != corner) {
        above[corner] = above[above[corner]];
        corner = above[corner];
    }
    return corner;
}

struct Side {
    std::array<int, 3> vertices; // sorted
    std::size_t tetrahedron;
    std::size_t face;
};

} // namespace

EmbeddedMesh virtual_nodes(const TetrahedralMesh& mesh, const std::vector<ElementCrack>& cracks)
{
    const std::size_t count = mesh.tetrahedra.size();
    std::vector<std::vector<std::size_t>> cracks_of(count);
    std::size_t begin = 0;
    while (begin < cracks.size()) {
        std::vector<std::size_t> run;
        std::size_t end = begin;
        while (end < cracks.size() && cracks[end].tetrahedron == cracks[begin].tetrahedron)
            run.push_back(end++);
        cracks_of[static_cast<std::size_t>(cracks[begin].tetrahedron)] = run;
        begin = end;
    }

    // The copies.
    std::vector<Copy> copies;
    std::vector<std::size_t> first_copy(count + 1, 0);
    for (std::size_t e = 0; e < count; ++e) {
        first_copy[e] = copies.size();
        Part whole;
        whole.corners = 15;
        Piece all;
        for (std::size_t k = 0; k < 4; ++k) {
            all.points[k].fill(0.0);
            all.points[k][k] = 1;
        }
        whole.pieces.push_back(all);
        std::vector<Part> parts{whole};
        for (const std::size_t c : cracks_of[e]) {
            std::array<double, 4> heights{};
            for (std::size_t i = 0; i < 4; ++i) {
                const std::size_t v = static_cast<std::size_t>(mesh.tetrahedra[e][i]);
                heights[i] = cracks[c].normal.dot(mesh.vertices[v] - cracks[c].point);
            }
            divide(parts, heights);
        }
        std::sort(parts.begin(), parts.end(), [](const Part& a, const Part& b) {
            return lowest_bit(a.corners) < lowest_bit(b.corners);
        });
        for (const Part& part : parts) {
            Copy copy{e, part.corners, 0.0};
            for (const Piece& piece : part.pieces)
                copy.share += piece.share;
            copies.push_back(copy);
        }
    }
    first_copy[count] = copies.size();

    // Corners that are one vertex.
    std::vector<std::size_t> above(4 * copies.size());
    std::iota(above.begin(), above.end(), std::size_t{0});
    std::vector<Side> sides;
    sides.reserve(4 * count);
    for (std::size_t e = 0; e < count; ++e) {
        const std::array<int, 4>& corners = mesh.tetrahedra[e];
        for (std::size_t f = 0; f < 4; ++f) {
            std::array<int, 3> key = {corners[(f + 1) % 4], corners[(f + 2) % 4],
                                      corners[(f + 3) % 4]};
            std::sort(key.begin(), key.end());
            sides.push_back({key, e, f});
        }
    }
    std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
        return a.vertices != b.vertices ? a.vertices < b.vertices : a.tetrahedron < b.tetrahedron;
    });
    for (std::size_t s = 0; s + 1 < sides.size(); ++s) {
        const Side& one = sides[s];
        const Side& two = sides[s + 1];
        if (one.vertices != two.vertices) continue;
        std::array<std::size_t, 4> partner{}; // of each corner of the first in the second
        for (std::size_t i = 0; i < 4; ++i) {
            if (i == one.face) continue;
            const int vertex = mesh.tetrahedra[one.tetrahedron][i];
            while (mesh.tetrahedra[two.tetrahedron][partner[i]] != vertex)
                ++partner[i];
        }
        for (std::size_t a = first_copy[one.tetrahedron]; a < first_copy[one.tetrahedron + 1];
             ++a) {
            for (std::size_t b = first_copy[two.tetrahedron]; b < first_copy[two.tetrahedron + 1];
                 ++b) {
                bool meet = false;
                for (std::size_t i = 0; i < 4; ++i)
                    meet = meet || (i != one.face && ((copies[a].corners >> i) & 1U) != 0 &&
                                    ((copies[b].corners >> partner[i]) & 1U) != 0);
                if (!meet) continue;
                for (std::size_t i = 0; i < 4; ++i) {
                    if (i == one.face) continue;
                    const std::size_t first = root_of(above, 4 * a + i);
                    const std::size_t second = root_of(above, 4 * b + partner[i]);
                    above[std::max(first, second)] = std::min(first, second);
                }
            }
        }
    }

    EmbeddedMesh result;
    result.mesh.vertices = mesh.vertices;
    result.vertex_parents.resize(mesh.vertices.size());
    std::iota(result.vertex_parents.begin(), result.vertex_parents.end(), 0);
    std::vector<bool> taken(mesh.vertices.size(), false);
    std::vector<int> numbers(above.size(), -1);
    for (std::size_t k = 0; k < copies.size(); ++k) {
        std::array<int, 4> corners{};
        std::array<int, 4> real{};
        for (std::size_t i = 0; i < 4; ++i) {
            const int vertex = mesh.tetrahedra[copies[k].parent][i];
            const std::size_t v = static_cast<std::size_t>(vertex);
            int& number = numbers[root_of(above, 4 * k + i)];
            if (number < 0) {
                number = vertex;
                if (taken[v]) {
                    number = static_cast<int>(result.mesh.vertices.size());
                    result.mesh.vertices.push_back(mesh.vertices[v]);
                    result.vertex_parents.push_back(vertex);
                }
                taken[v] = true;
            }
            corners[i] = number;
            real[i] = ((copies[k].corners >> i) & 1U) != 0 ? 1 : 0;
        }
        result.mesh.tetrahedra.push_back(corners);
        result.parents.push_back(static_cast<int>(copies[k].parent));
        result.real.push_back(real);
        result.fractions.push_back(copies[k].share);
    }
    return result;
}

} // namespace rigor
