// SPDX-License-Identifier: MIT
// Solutions of tasks A7.5 and A7.7, about fracture. Both find out which corners of tetrahedra are
// the same vertex. A7.5 joins the corners of tetrahedra that share a face which is not cut. A7.7
// (Molino, Bao and Fedkiw 2004) first copies each cracked tetrahedron once for each part of its
// corners, then joins the copies that share a real corner. Both use union-find on corners, and each
// group of corners becomes a vertex in the end.
#include "formulas/fracture.hpp"

#include "fracture_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

namespace rigor {

namespace {

using Eigen::Matrix4d;
using Eigen::Vector4d;

// The number of corner c of tetrahedron t, among the corners of all tetrahedra.
int corner(int t, int c)
{
    return 4 * t + c;
}

// Disjoint groups of corners (union-find). The lowest corner of a group represents it.
class Groups {
public:
    explicit Groups(std::size_t corners) : above_(corners)
    {
        std::iota(above_.begin(), above_.end(), 0);
    }
    int find(int i)
    {
        while (above_[i] != i)
            i = above_[i] = above_[above_[i]];
        return i;
    }
    void join(int i, int j)
    {
        i = find(i), j = find(j);
        above_[std::max(i, j)] = std::min(i, j);
    }

private:
    std::vector<int> above_;
};

using FaceVertices = std::array<int, 3>; // in ascending order

FaceVertices face_vertices(const Tetrahedron& t, int face)
{
    FaceVertices result = {t[(face + 1) % 4], t[(face + 2) % 4], t[(face + 3) % 4]};
    std::sort(result.begin(), result.end());
    return result;
}

struct SharedFace {
    FaceVertices vertices;
    int t1, t2; // the tetrahedra that share it
};

// The faces that two tetrahedra share and that have at least one vertex v with `is_some[v]`.
std::vector<SharedFace> shared_faces(const Tetrahedra& tetrahedra, const std::vector<bool>& is_some)
{
    std::vector<std::pair<FaceVertices, int>> faces;
    for (std::size_t t = 0; t < tetrahedra.size(); ++t)
        for (int f = 0; f < 4; ++f) {
            const FaceVertices face = face_vertices(tetrahedra[t], f);
            if (is_some[face[0]] || is_some[face[1]] || is_some[face[2]])
                faces.emplace_back(face, static_cast<int>(t));
        }
    std::sort(faces.begin(), faces.end());

    std::vector<SharedFace> result;
    for (std::size_t i = 1; i < faces.size(); ++i)
        if (faces[i - 1].first == faces[i].first)
            result.push_back({faces[i].first, faces[i - 1].second, faces[i].second});
    return result;
}

// Gives each group of corners its own vertex, if it is a group of a vertex v with `may_double[v]`.
// The first group of v keeps the vertex v, and each other group gets a new vertex, a copy of v.
// Returns for each vertex the one that it is a copy of, or itself.
std::vector<int> separate(Tetrahedra& tetrahedra, Groups& groups,
                          const std::vector<bool>& may_double)
{
    std::vector<int> parents(may_double.size());
    std::iota(parents.begin(), parents.end(), 0);
    std::vector<bool> is_taken(may_double.size(), false);
    std::map<int, int> vertex_of_group;
    for (std::size_t t = 0; t < tetrahedra.size(); ++t)
        for (int c = 0; c < 4; ++c) {
            int& v = tetrahedra[t][c];
            if (!may_double[v]) continue;
            const int group = groups.find(corner(static_cast<int>(t), c));
            const int next = is_taken[v] ? static_cast<int>(parents.size()) : v;
            const auto [entry, is_new] = vertex_of_group.emplace(group, next);
            if (is_new && is_taken[v]) parents.push_back(v);
            is_taken[v] = true;
            v = entry->second;
        }
    return parents;
}

// A tetrahedron inside a cracked one, given by the barycentric coordinates of its corners, one
// column for each corner.
using Piece = Matrix4d;

// A part of the material of a cracked tetrahedron. real: 1 for each corner that belongs to it.
struct Part {
    Tetrahedron real = {1, 1, 1, 1};
    std::vector<Piece> pieces = {Piece::Identity()};
};

// Halves a piece until none of its edges crosses the plane. h: the heights of its corners above the
// plane.
void clip(const Piece& piece, const Vector4d& h, std::vector<Piece>& above,
          std::vector<Piece>& below)
{
    Eigen::Index i = 0, j = 0;
    if (!(h.maxCoeff(&i) > 0 && h.minCoeff(&j) < 0)) {
        (h.sum() > 0 ? above : below).push_back(piece);
        return;
    }
    const double t = h[i] / (h[i] - h[j]);
    const Vector4d p = (1 - t) * piece.col(i) + t * piece.col(j);
    for (const Eigen::Index replaced : {i, j}) {
        Piece half = piece;
        Vector4d height = h;
        half.col(replaced) = p;
        height[replaced] = 0;
        clip(half, height, above, below);
    }
}

// Divides the parts that have corners on both sides of a crack. h: the heights of the corners above
// the plane of the crack.
void divide(std::vector<Part>& parts, const Vector4d& h)
{
    for (std::size_t i = 0, count = parts.size(); i < count; ++i) {
        Part above = {{}, {}}, below = {{}, {}};
        for (int c = 0; c < 4; ++c)
            (h[c] >= 0 ? above : below).real[c] = parts[i].real[c];
        const Tetrahedron nothing = {};
        if (above.real == nothing || below.real == nothing) continue;

        for (const Piece& piece : parts[i].pieces)
            clip(piece, piece.transpose() * h, above.pieces, below.pieces);
        parts[i] = above;
        parts.push_back(below);
    }
}

// The part that holds the first corner comes first.
bool comes_first(const Part& a, const Part& b)
{
    return a.real > b.real;
}

// A part's share of the volume of its tetrahedron.
double fraction(const Part& part)
{
    double sum = 0;
    for (const Piece& piece : part.pieces)
        sum += std::abs(piece.determinant());
    return std::min(sum, 1.0);
}

} // namespace

SplitMesh split_along_faces(const TetrahedralMesh& mesh, const std::vector<MeshFace>& faces)
{
    SplitMesh result = {mesh, {}, std::vector<int>(mesh.tetrahedra.size())};
    std::iota(result.parents.begin(), result.parents.end(), 0);
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
        result.origins.push_back({static_cast<int>(v), static_cast<int>(v), 0});
    Tetrahedra& tetrahedra = result.mesh.tetrahedra;
    if (!is_mesh(mesh)) return result;

    std::set<FaceVertices> cut;
    std::vector<bool> may_double(mesh.vertices.size(), false);
    for (const MeshFace& face : faces) {
        if (!is_index(face.tetrahedron, tetrahedra.size()) || !is_index(face.face, 4)) continue;
        const FaceVertices vertices = face_vertices(tetrahedra[face.tetrahedron], face.face);
        cut.insert(vertices);
        for (int v : vertices)
            may_double[v] = true;
    }

    // Around a vertex, tetrahedra that share a face which is not cut stay connected.
    Groups groups(4 * tetrahedra.size());
    for (const SharedFace& face : shared_faces(tetrahedra, may_double))
        if (!cut.contains(face.vertices))
            for (int v : face.vertices)
                groups.join(corner(face.t1, corner_of(tetrahedra[face.t1], v)),
                            corner(face.t2, corner_of(tetrahedra[face.t2], v)));

    const std::vector<int> parents = separate(tetrahedra, groups, may_double);
    for (std::size_t v = mesh.vertices.size(); v < parents.size(); ++v) {
        result.mesh.vertices.push_back(mesh.vertices[parents[v]]);
        result.origins.push_back({parents[v], parents[v], 0});
    }
    return result;
}

EmbeddedMesh virtual_nodes(const TetrahedralMesh& mesh, const std::vector<ElementCrack>& cracks)
{
    if (!is_mesh(mesh)) return {mesh, {}, {}, {}, {}};

    std::map<int, std::vector<Part>> cracked;
    std::vector<bool> may_double(mesh.vertices.size(), false);
    for (const ElementCrack& crack : cracks) {
        if (!is_index(crack.tetrahedron, mesh.tetrahedra.size())) continue;
        Vector4d h; // n · (x - p) for each corner
        for (int c = 0; c < 4; ++c) {
            const int v = mesh.tetrahedra[crack.tetrahedron][c];
            h[c] = crack.normal.dot(mesh.vertices[v] - crack.point);
            may_double[v] = true;
        }
        if (!h.allFinite()) continue;
        divide(cracked.try_emplace(crack.tetrahedron, 1).first->second, h);
    }

    EmbeddedMesh result;
    // For each corner, the copy in which it is real.
    std::vector<int> holder(4 * mesh.tetrahedra.size());
    for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t) {
        const int parent = static_cast<int>(t);
        std::vector<Part> parts(1);
        if (cracked.contains(parent)) parts = cracked.at(parent);
        std::sort(parts.begin(), parts.end(), comes_first);
        for (const Part& part : parts) {
            for (int c = 0; c < 4; ++c)
                if (part.real[c] == 1)
                    holder[corner(parent, c)] = static_cast<int>(result.parents.size());
            result.mesh.tetrahedra.push_back(mesh.tetrahedra[t]);
            result.parents.push_back(parent);
            result.real.push_back(part.real);
            result.fractions.push_back(fraction(part));
        }
    }

    // If the copies of two tetrahedra have a real corner of a shared face in common, they share the
    // whole face.
    Tetrahedra& copies = result.mesh.tetrahedra;
    Groups groups(4 * copies.size());
    for (const SharedFace& face : shared_faces(mesh.tetrahedra, may_double))
        for (int v : face.vertices) {
            const Tetrahedron &whole1 = mesh.tetrahedra[face.t1],
                              &whole2 = mesh.tetrahedra[face.t2];
            const int copy1 = holder[corner(face.t1, corner_of(whole1, v))];
            const int copy2 = holder[corner(face.t2, corner_of(whole2, v))];
            for (int w : face.vertices)
                groups.join(corner(copy1, corner_of(whole1, w)),
                            corner(copy2, corner_of(whole2, w)));
        }

    result.vertex_parents = separate(copies, groups, may_double);
    for (int parent : result.vertex_parents)
        result.mesh.vertices.push_back(mesh.vertices[parent]);
    return result;
}

} // namespace rigor
