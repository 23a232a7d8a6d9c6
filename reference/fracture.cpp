// SPDX-License-Identifier: MIT
// Solutions of tasks A7.1 to A7.4 and A7.6, about fracture; the others are in
// fracture_vertices.cpp. A7.1 to A7.3 smooth the stress and find the crack plane from its largest
// eigenvalue; A7.4 finds the face that is closest to this plane; A7.6 cuts elements along a plane
// (O'Brien and Hodgins 1999). `split_element` first finds the vertices above and below the plane,
// then halves the tetrahedra at the edges that cross it, then splits the mesh along the faces on
// the plane.
#include "formulas/fracture.hpp"

#include "fracture_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace rigor {

namespace {

// A vertex nearer to the plane than this fraction of the longest edge counts as lying on the plane.
// The contract, formulas/fracture.hpp, gives the value.
constexpr double snap_distance = 0.05;

// The tetrahedra that have at least `count` of the chosen vertices.
std::vector<int> tetrahedra_at(const Tetrahedra& tetrahedra, const std::set<int>& chosen, int count)
{
    std::vector<int> result;
    for (std::size_t t = 0; t < tetrahedra.size(); ++t)
        if (std::count_if(tetrahedra[t].begin(), tetrahedra[t].end(),
                          [&](int v) { return chosen.contains(v); }) >= count)
            result.push_back(static_cast<int>(t));
    return result;
}

// A plane through a vertex, with what is near this vertex.
struct Cut {
    std::vector<int> ring;        // the tetrahedra that have this vertex
    std::map<int, double> height; // heights of their vertices above the plane [m], 0 for a vertex
                                  // that counts as lying on the plane
};

Cut cut_at(const TetrahedralMesh& mesh, int vertex, const Vector3d& n)
{
    Cut cut = {tetrahedra_at(mesh.tetrahedra, {vertex}, 1), {}};

    double longest = 0;
    const std::vector<Vector3d>& x = mesh.vertices;
    for (int t : cut.ring)
        for (int a : mesh.tetrahedra[t]) {
            cut.height[a] = n.dot(x[a] - x[vertex]);
            for (int b : mesh.tetrahedra[t])
                longest = std::max(longest, (x[a] - x[b]).stableNorm());
        }
    for (auto& [v, h] : cut.height)
        if (!(std::abs(h) >= snap_distance * longest)) h = 0;
    cut.height[vertex] = 0;
    return cut;
}

// The edges that cross the plane, of the tetrahedra in `cut.ring`. Each edge goes from its vertex
// above the plane to the one below.
std::set<std::array<int, 2>> crossing_edges(const Tetrahedra& tetrahedra, const Cut& cut)
{
    std::set<std::array<int, 2>> edges;
    for (int t : cut.ring)
        for (int a : tetrahedra[t])
            for (int b : tetrahedra[t])
                if (cut.height.at(a) > 0 && cut.height.at(b) < 0) edges.insert({a, b});
    return edges;
}

// Halves each tetrahedron of `near` that has the edge a b, at the new vertex p of this edge. The
// second halves are appended to the mesh and to `near`.
void halve(SplitMesh& split, std::vector<int>& near, int a, int b, int p)
{
    for (std::size_t i = 0, count = near.size(); i < count; ++i) {
        const int t = near[i];
        const Tetrahedron whole = split.mesh.tetrahedra[t];
        const int ca = corner_of(whole, a), cb = corner_of(whole, b);
        if (ca == 4 || cb == 4) continue;

        split.mesh.tetrahedra[t][cb] = p;
        near.push_back(static_cast<int>(split.mesh.tetrahedra.size()));
        split.mesh.tetrahedra.push_back(whole);
        split.mesh.tetrahedra.back()[ca] = p;
        split.parents.push_back(split.parents[t]);
    }
}

// Whether a tetrahedron that the plane does not cut is above it. If all its vertices count as lying
// on the plane, the side of its center decides.
bool is_above(const TetrahedralMesh& mesh, const Tetrahedron& t, const Cut& cut, int vertex,
              const Vector3d& n)
{
    double sum = 0, center = 0;
    for (int v : t) {
        sum += cut.height.at(v);
        center += n.dot(mesh.vertices[v] - mesh.vertices[vertex]) / 4;
    }
    return sum != 0 ? sum > 0 : center >= 0;
}

using Face = std::array<int, 3>; // the vertices of a face, ascending

Face face_of(const Tetrahedron& t, int face)
{
    Face result = {t[(face + 1) % 4], t[(face + 2) % 4], t[(face + 3) % 4]};
    std::sort(result.begin(), result.end());
    return result;
}

// The faces between a tetrahedron above the plane and one below, both of which have the vertex. All
// vertices of these faces count as lying on the plane.
std::vector<MeshFace> faces_on_plane(const TetrahedralMesh& mesh, const std::vector<int>& near,
                                     const Cut& cut, int vertex, const Vector3d& n)
{
    std::set<Face> above;
    std::vector<MeshFace> below, result;
    for (int t : near) {
        const Tetrahedron& tetrahedron = mesh.tetrahedra[t];
        if (corner_of(tetrahedron, vertex) == 4) continue;
        const bool is_upper = is_above(mesh, tetrahedron, cut, vertex, n);
        for (int f = 0; f < 4; ++f) {
            if (is_upper)
                above.insert(face_of(tetrahedron, f));
            else
                below.push_back({t, f});
        }
    }
    for (const MeshFace& face : below)
        if (above.contains(face_of(mesh.tetrahedra[face.tetrahedron], face.face)))
            result.push_back(face);
    return result;
}

} // namespace

std::vector<Matrix3d> smooth_stress(const std::vector<Matrix3d>& stresses,
                                    const std::vector<std::vector<int>>& neighbours,
                                    const std::vector<double>& volumes)
{
    std::vector<Matrix3d> result = stresses;
    if (neighbours.size() != stresses.size() || volumes.size() != stresses.size()) return result;
    for (std::size_t e = 0; e < stresses.size(); ++e) {
        double V = volumes[e];
        for (int n : neighbours[e])
            V += is_index(n, volumes.size()) ? volumes[n] : 0;
        if (!(V > 0) || !std::isfinite(V)) continue;

        // σ̄ₑ = (Vₑ σₑ + Σ Vₘ σₘ) / (Vₑ + Σ Vₘ)
        result[e] = volumes[e] / V * stresses[e];
        for (int n : neighbours[e])
            if (is_index(n, volumes.size())) result[e] += volumes[n] / V * stresses[n];
    }
    return result;
}

PrincipalStress principal_stress(const Matrix3d& stress)
{
    // σ = Q diag(σ₃, σ₂, σ₁) Qᵀ
    const Eigen::SelfAdjointEigenSolver<Matrix3d> eigen(stress);
    return {eigen.eigenvalues()[2], eigen.eigenvectors().col(2)};
}

std::optional<Vector3d> crack_plane(const Matrix3d& stress, double threshold)
{
    const PrincipalStress principal = principal_stress(stress);
    if (principal.stress <= 0 || principal.stress <= threshold) return {}; // it does not crack
    return principal.direction;
}

int closest_face(const std::array<Vector3d, 4>& tetrahedron, const Vector3d& normal)
{
    const std::array<Vector3d, 4>& x = tetrahedron;
    int closest = 0;
    double best = 0;
    for (int f = 0; f < 4; ++f) {
        const Vector3d &a = x[(f + 1) % 4], &b = x[(f + 2) % 4], &c = x[(f + 3) % 4];
        const Vector3d n_f = (b - a).stableNormalized().cross((c - a).stableNormalized());
        const double alignment = std::abs(n_f.stableNormalized().dot(normal)); // |n_f · n|
        if (alignment > best) closest = f, best = alignment;
    }
    return closest;
}

SplitMesh split_element(const TetrahedralMesh& mesh, int vertex, const Vector3d& normal)
{
    SplitMesh result = split_along_faces(mesh, {}); // the mesh as it is
    std::vector<Vector3d>& x = result.mesh.vertices;
    if (!is_mesh(mesh) || !is_index(vertex, x.size())) return result;

    Cut cut = cut_at(mesh, vertex, normal);
    std::set<int> ring_vertices;
    bool is_some_above = false, is_some_below = false;
    for (const auto& [v, h] : cut.height) {
        ring_vertices.insert(v);
        is_some_above |= h > 0;
        is_some_below |= h < 0;
    }
    if (!is_some_above || !is_some_below) return result;

    std::vector<int> near = tetrahedra_at(mesh.tetrahedra, ring_vertices, 2);
    for (const auto& [a, b] : crossing_edges(mesh.tetrahedra, cut)) {
        // p = (1 - t) x_a + t x_b on the plane
        const double t = cut.height[a] / (cut.height[a] - cut.height[b]);
        const int p = static_cast<int>(x.size());
        x.push_back((1 - t) * x[a] + t * x[b]);
        result.origins.push_back({a, b, t});
        cut.height[p] = 0;
        halve(result, near, a, b, p);
    }

    const std::vector<MeshFace> faces = faces_on_plane(result.mesh, near, cut, vertex, normal);
    SplitMesh apart = split_along_faces(result.mesh, faces);
    for (VertexOrigin& origin : apart.origins)
        origin = result.origins[origin.first];
    apart.parents = result.parents; // `split_along_faces` keeps the order of the halved mesh
    return apart;
}

} // namespace rigor
