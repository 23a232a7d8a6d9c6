// SPDX-License-Identifier: MIT
// Chooses the planes of new cracks so that they continue the cracks of neighboring elements. The
// code collects the points where earlier cracks cut edges. Then it tries the planes through one,
// two and three of the points on an element's edges. Among the planes through the most points it
// takes the one whose normal is nearest to the wanted normal.
#include "deformable/fracture/crack_edges.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace rigor {

namespace {

constexpr std::array<std::array<int, 2>, 6> tetrahedron_edges = {
    {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};
// cos 60°. The normal of a crack is less than 60° from the wanted normal, which the stress gives.
constexpr double least_cosine = 0.5;
// About cos 45°. Two cracks of an element whose planes enclose a smaller angle count as the same.
constexpr double similar_cosine = 0.7;
// Least distance of a corner from the plane of a crack, divided by that of the farthest corner.
// Between the plane and a nearer corner there would be almost no material.
constexpr double least_corner_height = 1e-6;

std::pair<int, int> edge_of(const std::array<int, 4>& t, const std::array<int, 2>& edge)
{
    return std::minmax(t[edge[0]], t[edge[1]]);
}

using Corners = std::array<Vector3d, 4>;

Corners corners_of(const TetrahedralMesh& mesh, int t)
{
    Corners x;
    for (int i = 0; i < 4; ++i)
        x[i] = mesh.vertices[mesh.tetrahedra[t][i]];
    return x;
}

// The best plane so far among those through the same number of cut points (one, two or three).
struct Best {
    const Corners& corners;
    const std::array<int, 4>& real;
    const Vector3d& wanted;
    std::optional<ElementCrack> crack;
    double cosine = least_cosine;

    void offer(const Vector3d& point, const Vector3d& direction)
    {
        const double length = direction.norm();
        if (length == 0) return;
        const Vector3d normal = direction / length;
        const double c = std::abs(normal.dot(wanted));
        if (!(c > cosine) || !separates(point, normal)) return;
        cosine = c;
        crack = ElementCrack{0, point, normal};
    }
    // Whether corners with material lie on both sides of the plane and none of them almost in it.
    // A crack splits the element into two copies, each with the material of one side. The material
    // between the plane and a corner that almost lies in it would have no volume, and the node of
    // this corner no mass. Distances are compared relative to the largest of them.
    bool separates(const Vector3d& point, const Vector3d& normal) const
    {
        int above = 0, below = 0;
        double nearest = never, farthest = 0;
        for (int i = 0; i < 4; ++i) {
            if (!real[i]) continue;
            const double height = normal.dot(corners[i] - point);
            ++(height >= 0 ? above : below);
            nearest = std::min(nearest, std::abs(height));
            farthest = std::max(farthest, std::abs(height));
        }
        return above > 0 && below > 0 && nearest > least_corner_height * farthest;
    }
};

} // namespace

CrackEdges::CrackEdges(const Deformable& solid)
    : solid_(solid), cracks_of_(solid.uncracked.tetrahedra.size())
{
    // A crack cuts only those edges that no earlier crack of the same element has cut.
    std::vector<std::array<bool, 6>> is_cut(solid.uncracked.tetrahedra.size());
    for (int k = 0; k < static_cast<int>(solid.cracks.size()); ++k) {
        const ElementCrack& crack = solid.cracks[k];
        const int t = crack.tetrahedron;
        cracks_of_[t].push_back(k);
        const Corners x = corners_of(solid.uncracked, t);
        for (int e = 0; e < 6; ++e) {
            const auto& [a, b] = tetrahedron_edges[e];
            const double h = crack.normal.dot(x[a] - crack.point),
                         g = crack.normal.dot(x[b] - crack.point);
            if (is_cut[t][e] || (h >= 0) == (g >= 0)) continue;
            is_cut[t][e] = true;
            cuts_.emplace(edge_of(solid.uncracked.tetrahedra[t], tetrahedron_edges[e]),
                          x[a] + h / (h - g) * (x[b] - x[a]));
        }
    }
}

bool CrackEdges::has_similar(int parent, const Vector3d& normal) const
{
    const auto& list = cracks_of_[parent];
    return std::any_of(list.begin(), list.end(), [&](int k) {
        return std::abs(solid_.cracks[k].normal.dot(normal)) > similar_cosine;
    });
}

std::vector<Vector3d> CrackEdges::cuts(int parent, const std::array<int, 4>& real) const
{
    std::vector<Vector3d> points;
    for (const auto& edge : tetrahedron_edges) {
        if (!real[edge[0]] || !real[edge[1]]) continue;
        const auto cut = cuts_.find(edge_of(solid_.uncracked.tetrahedra[parent], edge));
        if (cut != cuts_.end()) points.push_back(cut->second);
    }
    return points;
}

bool CrackEdges::meets(int parent, const std::array<int, 4>& real) const
{
    return !cuts(parent, real).empty();
}

ElementCrack CrackEdges::continued(int parent, const std::array<int, 4>& real,
                                   const Vector3d& normal) const
{
    const Corners x = corners_of(solid_.uncracked, parent);
    const std::vector<Vector3d> p = cuts(parent, real);
    const int n = static_cast<int>(p.size());
    Best three{x, real, normal, {}}, two{x, real, normal, {}}, one{x, real, normal, {}};
    for (int i = 0; i < n; ++i) {
        one.offer(p[i], normal);
        for (int j = 0; j < i; ++j) {
            const Vector3d d = (p[i] - p[j]).normalized();
            two.offer(p[i], normal - normal.dot(d) * d);
            for (int k = 0; k < j; ++k)
                three.offer(p[i], (p[j] - p[i]).cross(p[k] - p[i]));
        }
    }
    Vector3d middle = Vector3d::Zero(); // mean of the corners with material [m]
    int count = 0;
    for (int i = 0; i < 4; ++i)
        if (real[i]) {
            middle += x[i];
            ++count;
        }
    ElementCrack crack{parent, middle / count, normal};
    for (const Best* best : {&one, &two, &three})
        if (best->crack) crack = *best->crack;
    crack.tetrahedron = parent;
    return crack;
}

} // namespace rigor
