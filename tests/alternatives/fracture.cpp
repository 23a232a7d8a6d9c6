// SPDX-License-Identifier: MIT
// Running means, Jacobi rotations, labels that spread, edges halved from the last, reversed lists.
// Principal stresses come from Jacobi's method (1846). Corners of tetrahedra that belong together
// get the same label, spread along links until nothing changes, instead of union-find. Edges are
// halved from the last to the first, and lists of the mesh are reversed.
#include "formulas/fracture.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <utility>

namespace rigor {

namespace {

using Tetrahedron = std::array<int, 4>;
using Face = std::array<int, 3>;
// Pairs of corners, where corner c of tetrahedron t is 4 t + c.
using Links = std::vector<std::pair<int, int>>;

int corner_of(const Tetrahedron& t, int v)
{
    for (int c = 0; c < 4; ++c)
        if (t[c] == v) return c;
    return -1;
}

Face face_of(const Tetrahedron& t, int f)
{
    Face face = {t[f == 0 ? 1 : 0], t[f < 2 ? 2 : 1], t[f < 3 ? 3 : 2]};
    std::sort(face.begin(), face.end());
    return face;
}

// Adds to `parents` the vertices that no tetrahedron uses, which stay in the mesh.
std::vector<int> with_unused(std::vector<int> parents, const TetrahedralMesh& mesh)
{
    std::vector<bool> is_used(mesh.vertices.size());
    for (const auto& tetrahedron : mesh.tetrahedra)
        for (int v : tetrahedron)
            is_used[v] = true;
    for (std::size_t v = 0; v < is_used.size(); ++v)
        if (!is_used[v]) parents.push_back(static_cast<int>(v));
    return parents;
}

// The tetrahedra that have each face, by the vertices of the face.
std::map<Face, std::vector<int>> sides_of_faces(const std::vector<Tetrahedron>& tetrahedra)
{
    std::map<Face, std::vector<int>> sides;
    for (std::size_t t = tetrahedra.size(); t-- > 0;)
        for (int f = 0; f < 4; ++f)
            sides[face_of(tetrahedra[t], f)].push_back(static_cast<int>(t));
    return sides;
}

// For each corner, the largest number of a corner that links connect with it.
std::vector<int> spread(std::size_t corners, const Links& links)
{
    std::vector<int> label(corners);
    std::iota(label.begin(), label.end(), 0);
    for (bool is_changed = true; is_changed;) {
        is_changed = false;
        for (const auto& [a, b] : links)
            if (label[a] != label[b]) {
                label[a] = label[b] = std::max(label[a], label[b]);
                is_changed = true;
            }
    }
    return label;
}

// Makes a vertex for each label, in the order from the last corner to the first.
// @return the parent of each vertex
std::vector<int> relabel(std::vector<Tetrahedron>& tetrahedra, const std::vector<int>& label)
{
    std::map<int, int> number;
    std::vector<int> parents;
    for (std::size_t t = tetrahedra.size(); t-- > 0;)
        for (int c = 3; c >= 0; --c) {
            const int l = label[4 * t + c];
            if (!number.count(l)) {
                number[l] = static_cast<int>(parents.size());
                parents.push_back(tetrahedra[t][c]);
            }
            tetrahedra[t][c] = number[l];
        }
    return parents;
}

void link(Links& links, int copy1, const Tetrahedron& t1, int copy2, const Tetrahedron& t2, int v)
{
    links.push_back({4 * copy1 + corner_of(t1, v), 4 * copy2 + corner_of(t2, v)});
}

// Pieces of a tetrahedron. The columns of a matrix are the barycentric coordinates of the corners
// that the piece has.
using Pieces = std::vector<Eigen::Matrix4d>;

// Cuts a piece by a plane, recursively.
// @param h  the heights of its corners above the plane
void cut(const Eigen::Matrix4d& piece, Eigen::Vector4d h, Pieces& above, Pieces& below)
{
    for (int a = 3; a >= 0; --a)
        for (int b = 3; b >= 0; --b) {
            if (!(h[a] > 0 && h[b] < 0)) continue;
            const double t = h[b] / (h[b] - h[a]);
            Eigen::Matrix4d upper = piece, lower = piece;
            upper.col(b) = lower.col(a) = piece.col(b) + t * (piece.col(a) - piece.col(b));
            Eigen::Vector4d h_upper = h, h_lower = h;
            h_upper[b] = h_lower[a] = 0;
            cut(upper, h_upper, above, below);
            cut(lower, h_lower, above, below);
            return;
        }
    (h.maxCoeff() > 0 ? above : below).push_back(piece);
}

struct Part {
    Tetrahedron real;
    Pieces pieces;
};

// Divides a part by the cracks from `next` on, recursively.
void divide(const Part& part, const std::vector<Eigen::Vector4d>& planes, std::size_t next,
            std::vector<Part>& parts)
{
    if (next == planes.size()) {
        parts.push_back(part);
        return;
    }
    Part above = {part.real, {}}, below = {part.real, {}};
    for (int c = 0; c < 4; ++c)
        (planes[next][c] >= 0 ? below : above).real[c] = 0;
    const auto has_corner = [](const Part& p) { return p.real != Tetrahedron{0, 0, 0, 0}; };
    if (!has_corner(above) || !has_corner(below)) {
        divide(part, planes, next + 1, parts);
        return;
    }
    for (const Eigen::Matrix4d& piece : part.pieces)
        cut(piece, piece.transpose() * planes[next], above.pieces, below.pieces);
    divide(above, planes, next + 1, parts);
    divide(below, planes, next + 1, parts);
}

} // namespace

std::vector<Matrix3d> smooth_stress(const std::vector<Matrix3d>& stresses,
                                    const std::vector<std::vector<int>>& neighbours,
                                    const std::vector<double>& volumes)
{
    // a running mean: each neighbor moves it by its share of the volume so far
    std::vector<Matrix3d> means = stresses;
    for (std::size_t e = 0; e < stresses.size(); ++e) {
        double V = volumes[e];
        for (const int m : neighbours[e])
            if (volumes[m] > 0) {
                V += volumes[m];
                means[e] += volumes[m] / V * (stresses[m] - means[e]);
            }
    }
    return means;
}

PrincipalStress principal_stress(const Matrix3d& stress)
{
    // Jacobi (1846): each rotation makes one entry beside the diagonal zero
    Matrix3d A = stress, Q = Matrix3d::Identity();
    for (int sweep = 0; sweep < 50; ++sweep)
        for (const auto& [p, q] : {std::pair(0, 1), std::pair(1, 2), std::pair(0, 2)}) {
            const double angle = 0.5 * std::atan2(2 * A(p, q), A(q, q) - A(p, p));
            Matrix3d J = Matrix3d::Identity();
            J(p, p) = J(q, q) = std::cos(angle);
            J(p, q) = std::sin(angle);
            J(q, p) = -J(p, q);
            A = J.transpose() * A * J;
            Q = Q * J;
        }
    Eigen::Index largest = 0;
    A.diagonal().maxCoeff(&largest);
    const Vector3d d = Q.col(largest).normalized();
    return {d.dot(stress * d), -d};
}

std::optional<Vector3d> crack_plane(const Matrix3d& stress, double threshold)
{
    const PrincipalStress principal = principal_stress(stress);
    if (principal.stress > std::max(threshold, 0.0)) return principal.direction;
    return std::nullopt;
}

// All edges begin at the first vertex, so the face opposite to it has differences of edges.
int closest_face(const std::array<Vector3d, 4>& x, const Vector3d& normal)
{
    Vector3d edge[3] = {x[1] - x[0], x[2] - x[0], x[3] - x[0]};
    for (Vector3d& e : edge) // else squares of tiny or huge tetrahedra are no doubles
        e *= 1 / std::max({(x[1] - x[0]).lpNorm<Eigen::Infinity>(),
                           (x[2] - x[0]).lpNorm<Eigen::Infinity>(),
                           (x[3] - x[0]).lpNorm<Eigen::Infinity>(), 1e-300});
    const Vector3d areas[] = {(edge[1] - edge[0]).cross(edge[2] - edge[0]), edge[1].cross(edge[2]),
                              edge[2].cross(edge[0]), edge[0].cross(edge[1])};
    double values[4];
    for (int f = 0; f < 4; ++f) {
        const double area = areas[f].stableNorm();
        values[f] = area > 0 ? std::abs(areas[f].dot(normal)) / area : 0;
    }
    return static_cast<int>(std::max_element(values, values + 4) - values); // the first of equals
}

SplitMesh split_along_faces(const TetrahedralMesh& mesh, const std::vector<MeshFace>& faces)
{
    std::map<Face, std::vector<int>> sides = sides_of_faces(mesh.tetrahedra);
    for (const MeshFace& named : faces)
        sides.erase(face_of(mesh.tetrahedra[named.tetrahedron], named.face));
    Links links;
    for (const auto& [face, t] : sides)
        for (int v : face)
            if (t.size() == 2)
                link(links, t[0], mesh.tetrahedra[t[0]], t[1], mesh.tetrahedra[t[1]], v);

    SplitMesh result = {{{}, mesh.tetrahedra}, {}, std::vector<int>(mesh.tetrahedra.size())};
    std::iota(result.parents.begin(), result.parents.end(), 0);
    const std::vector<int> label = spread(4 * mesh.tetrahedra.size(), links);
    for (int parent : with_unused(relabel(result.mesh.tetrahedra, label), mesh)) {
        result.mesh.vertices.push_back(mesh.vertices[parent]);
        result.origins.push_back({parent, parent, 0});
    }
    return result;
}

SplitMesh split_element(const TetrahedralMesh& mesh, int vertex, const Vector3d& normal)
{
    double longest = 0;
    std::map<int, double> h;
    for (const Tetrahedron& t : mesh.tetrahedra)
        for (int a : t)
            for (int b : t)
                if (corner_of(t, vertex) >= 0) {
                    longest = std::max(longest, (mesh.vertices[a] - mesh.vertices[b]).norm());
                    h[a] = (mesh.vertices[a] - mesh.vertices[vertex]).dot(normal);
                }
    for (auto& [v, height] : h)
        if (std::abs(height) < 0.05 * longest) height = 0;

    // edges from below to above the plane, in descending order
    std::map<std::pair<int, int>, int, std::greater<>> edges;
    for (const Tetrahedron& t : mesh.tetrahedra)
        for (int a : t)
            for (int b : t)
                if (corner_of(t, vertex) >= 0 && h[a] < 0 && h[b] > 0) edges[{a, b}] = 0;
    SplitMesh fine = {mesh, {}, std::vector<int>(mesh.tetrahedra.size())};
    std::iota(fine.parents.begin(), fine.parents.end(), 0);
    for (int v = 0; v < static_cast<int>(mesh.vertices.size()); ++v)
        fine.origins.push_back({v, v, 0});
    for (auto& [edge, p] : edges) {
        const auto [a, b] = edge;
        const double t = -h[a] / (h[b] - h[a]);
        p = static_cast<int>(fine.origins.size());
        fine.origins.push_back({a, b, t});
        fine.mesh.vertices.push_back(mesh.vertices[a] + t * (mesh.vertices[b] - mesh.vertices[a]));
        h[p] = 0;
        std::vector<Tetrahedron> halves;
        std::vector<int> parents;
        for (std::size_t i = fine.parents.size(); i-- > 0;) { // this reverses the lists each time
            Tetrahedron whole = fine.mesh.tetrahedra[i];
            const int at_a = corner_of(whole, a), at_b = corner_of(whole, b);
            if (at_a >= 0 && at_b >= 0) {
                halves.push_back(whole);
                halves.back()[at_a] = p;
                parents.push_back(fine.parents[i]);
                whole[at_b] = p;
            }
            halves.push_back(whole);
            parents.push_back(fine.parents[i]);
        }
        fine.mesh.tetrahedra = halves;
        fine.parents = parents;
    }

    // 1 above the plane, -1 below it, 0 if the tetrahedron does not have the vertex
    const auto side = [&](const Tetrahedron& t) {
        if (corner_of(t, vertex) < 0) return 0;
        double sum = 0, middle = 0;
        for (int v : t) {
            sum += h[v];
            middle += normal.dot(fine.mesh.vertices[v] - mesh.vertices[vertex]);
        }
        return (sum == 0 ? middle >= 0 : sum > 0) ? 1 : -1;
    };
    std::vector<MeshFace> opened;
    const auto below = [](const auto& entry) { return entry.second < 0; };
    const auto above = [](const auto& entry) { return entry.second > 0; };
    const bool is_cut =
        std::any_of(h.begin(), h.end(), below) && std::any_of(h.begin(), h.end(), above);
    for (const auto& [face, t] : sides_of_faces(fine.mesh.tetrahedra)) {
        if (!is_cut || t.size() < 2) continue;
        const Tetrahedron& t0 = fine.mesh.tetrahedra[t[0]];
        if (side(t0) * side(fine.mesh.tetrahedra[t[1]]) >= 0) continue;
        for (int f = 0; f < 4; ++f)
            if (face_of(t0, f) == face) opened.push_back({t[0], f});
    }
    SplitMesh result = split_along_faces(fine.mesh, opened);
    result.parents = fine.parents;
    for (VertexOrigin& origin : result.origins)
        origin = fine.origins[origin.first];
    return result;
}

EmbeddedMesh virtual_nodes(const TetrahedralMesh& mesh, const std::vector<ElementCrack>& cracks)
{
    std::vector<std::vector<Eigen::Vector4d>> planes(mesh.tetrahedra.size());
    for (const ElementCrack& crack : cracks) {
        Eigen::Vector4d h;
        for (int c = 0; c < 4; ++c)
            h[c] = (mesh.vertices[mesh.tetrahedra[crack.tetrahedron][c]] - crack.point)
                       .dot(crack.normal);
        planes[crack.tetrahedron].push_back(h);
    }
    EmbeddedMesh result;
    std::vector<std::vector<int>> copies(mesh.tetrahedra.size());
    for (std::size_t t = 0; t < planes.size(); ++t) {
        std::vector<Part> parts;
        divide({{1, 1, 1, 1}, {Eigen::Matrix4d::Identity()}}, planes[t], 0, parts);
        std::sort(parts.begin(), parts.end(),
                  [](const Part& a, const Part& b) { return b.real < a.real; });
        for (const Part& part : parts) {
            double share = 0;
            for (const Eigen::Matrix4d& piece : part.pieces)
                share += std::abs(piece.determinant());
            copies[t].push_back(static_cast<int>(result.parents.size()));
            result.parents.push_back(static_cast<int>(t));
            result.real.push_back(part.real);
            result.fractions.push_back(std::clamp(share, 0.0, 1.0));
            result.mesh.tetrahedra.push_back(mesh.tetrahedra[t]);
        }
    }
    Links links;
    for (const auto& [face, t] : sides_of_faces(mesh.tetrahedra)) {
        if (t.size() < 2) continue;
        const Tetrahedron &t0 = mesh.tetrahedra[t[0]], &t1 = mesh.tetrahedra[t[1]];
        for (int copy0 : copies[t[0]])
            for (int copy1 : copies[t[1]]) {
                int common = 0;
                for (int v : face)
                    common +=
                        result.real[copy0][corner_of(t0, v)] * result.real[copy1][corner_of(t1, v)];
                for (int v : face)
                    if (common > 0) link(links, copy0, t0, copy1, t1, v);
            }
    }
    const std::vector<int> label = spread(4 * result.parents.size(), links);
    result.vertex_parents = with_unused(relabel(result.mesh.tetrahedra, label), mesh);
    for (int parent : result.vertex_parents)
        result.mesh.vertices.push_back(mesh.vertices[parent]);
    return result;
}

} // namespace rigor
