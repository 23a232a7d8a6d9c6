// SPDX-License-Identifier: MIT
// Builds meshes of tetrahedra. A block is made of cells of five tetrahedra each, a ball of an
// octahedron whose eighths are divided along the diagonals of their cells (Kuhn 1960). In a block,
// vertices are numbered last, and those that no tetrahedron uses are left out. In a ball, a vertex
// is numbered when it is first used.
#include "geometry/tetrahedra/tetrahedra_generators.hpp"

#include "geometry/tetrahedra/tetrahedra.hpp"

#include <algorithm>
#include <functional>
#include <utility>

namespace rigor {

namespace {

// The five tetrahedra of a cell, each by its corners. Corner c is at (c & 1, c >> 1 & 1, c >> 2).
constexpr int cell_tetrahedra[5][4] = {
    {0, 3, 6, 5}, {1, 5, 3, 0}, {2, 3, 6, 0}, {4, 6, 5, 0}, {7, 5, 6, 3}};

// Whether the block has the cells in column (x, y), at all z.
using IsThere = std::function<bool(int, int)>;

// The tetrahedra of all cells of a block. Neighboring cells are mirror images in x. A mirrored
// tetrahedron would be inverted, so two of its vertices are swapped.
TetrahedralMesh cells_as_tetrahedra(const Vector3d& size, const std::array<int, 3>& cells,
                                    const IsThere& is_there)
{
    const auto [nx, ny, nz] = cells;
    const auto node = [&, nx = nx, ny = ny](int x, int y, int z) {
        return x + (nx + 1) * (y + (ny + 1) * z);
    };
    std::vector<int> number((nx + 1) * (ny + 1) * (nz + 1), -1);
    TetrahedralMesh mesh;
    for (int z = 0; z < nz; ++z)
        for (int y = 0; y < ny; ++y)
            for (int x = 0; x < nx; ++x) {
                if (!is_there(x, y)) continue;
                const int mirror = (x + y + z) % 2;
                for (const auto& corners : cell_tetrahedra) {
                    std::array<int, 4> t{};
                    for (int i = 0; i < 4; ++i) {
                        const int c = corners[i] ^ mirror;
                        t[i] = node(x + (c & 1), y + (c >> 1 & 1), z + (c >> 2));
                        number[t[i]] = 0;
                    }
                    if (mirror) std::swap(t[2], t[3]);
                    mesh.tetrahedra.push_back(t);
                }
            }
    for (int z = 0; z <= nz; ++z)
        for (int y = 0; y <= ny; ++y)
            for (int x = 0; x <= nx; ++x) {
                int& n = number[node(x, y, z)];
                if (n < 0) continue;
                n = static_cast<int>(mesh.vertices.size());
                // p counts half cells from the middle of the block, so that opposite vertices
                // differ exactly in the sign of p.
                const Vector3d p(2.0 * x - nx, 2.0 * y - ny, 2.0 * z - nz);
                mesh.vertices.push_back(
                    p.cwiseQuotient(2 * Vector3d(nx, ny, nz)).cwiseProduct(size));
            }
    for (auto& t : mesh.tetrahedra)
        for (int& v : t)
            v = number[v];
    return mesh;
}

// Calls add(t) for each tetrahedron t into which Kuhn (1960) divides the region 0 ≤ z ≤ y ≤ x ≤ n:
// each unit cell is cut into six tetrahedra around its diagonal, and those in the region are taken.
template <class Add> void for_each_kuhn_tetrahedron(int n, const Add& add)
{
    constexpr int orders[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    for (int i = 0; i < n; ++i)
        for (int j = 0; j <= i; ++j)
            for (int k = 0; k <= j; ++k)
                for (const auto& order : orders) {
                    std::array<std::array<int, 3>, 4> t;
                    t[0] = {i, j, k};
                    for (int s = 0; s < 3; ++s) {
                        t[s + 1] = t[s];
                        ++t[s + 1][order[s]];
                    }
                    const bool is_inside = std::all_of(t.begin(), t.end(), [](const auto& p) {
                        return p[0] >= p[1] && p[1] >= p[2];
                    });
                    if (is_inside) add(t);
                }
}

} // namespace

TetrahedralMesh block_tetrahedra(const Vector3d& size, const std::array<int, 3>& cells)
{
    return cells_as_tetrahedra(size, cells, [](int, int) { return true; });
}

TetrahedralMesh notched_tetrahedra(const Vector3d& size, const std::array<int, 3>& cells,
                                   const std::array<int, 2>& notch)
{
    const int first = (cells[0] - notch[0]) / 2, bottom = cells[1] - notch[1];
    return cells_as_tetrahedra(size, cells, [&](int x, int y) {
        return x < first || x >= first + notch[0] || y < bottom;
    });
}

TetrahedralMesh ball_tetrahedra(double radius, int layers)
{
    const int n = layers, side = 2 * n + 1;
    std::vector<int> number(side * side * side, -1);
    TetrahedralMesh mesh;
    // The index of the vertex for a grid point of the octahedron |x| + |y| + |z| ≤ n.
    const auto vertex = [&](const std::array<int, 3>& p) {
        int& v = number[p[0] + n + side * (p[1] + n + side * (p[2] + n))];
        if (v >= 0) return v;
        const Vector3d q(p[0], p[1], p[2]);
        const double layer = q.lpNorm<1>(); // all points of one layer move onto one sphere
        mesh.vertices.push_back(layer > 0 ? Vector3d(radius * layer / n * q.normalized()) : q);
        return v = static_cast<int>(mesh.vertices.size()) - 1;
    };
    for (int octant = 0; octant < 8; ++octant) {
        const std::array<int, 3> sign = {octant & 1 ? -1 : 1, octant & 2 ? -1 : 1,
                                         octant & 4 ? -1 : 1};
        for_each_kuhn_tetrahedron(n, [&](const std::array<std::array<int, 3>, 4>& kuhn) {
            std::array<int, 4> t{};
            for (int i = 0; i < 4; ++i) { // maps Kuhn's region to the octant
                const auto& [a, b, c] = kuhn[i];
                t[i] = vertex({sign[0] * (a - b), sign[1] * (b - c), sign[2] * c});
            }
            mesh.tetrahedra.push_back(t);
            if (tetrahedron_volume(mesh, static_cast<int>(mesh.tetrahedra.size()) - 1) < 0)
                std::swap(mesh.tetrahedra.back()[2], mesh.tetrahedra.back()[3]);
        });
    }
    return mesh;
}

} // namespace rigor
