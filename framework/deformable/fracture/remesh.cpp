// SPDX-License-Identifier: MIT
// Transfers the state of a solid to a split mesh. The code carries crack faces and plastic strains
// from parent elements, then positions, velocities, handles and loads from old nodes, then lumps
// the masses again. Last, it restores the angular momentum that a cut has lost (remesh.hpp).
#include "deformable/fracture/remesh.hpp"

#include "deformable/solid/lumped_mass.hpp"
#include "geometry/tetrahedra/tetrahedra.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace rigor {

namespace {

// The value at a new node: (1 - t) a + t b if the node lies between two old nodes with the values a
// and b, at the fraction t of the way; exactly a if the node is a copy of the first one.
template <class T> T between(const std::vector<T>& old, const VertexOrigin& origin)
{
    if (origin.first == origin.second) return old[origin.first];
    return (1 - origin.fraction) * old[origin.first] + origin.fraction * old[origin.second];
}

// The new nodes with material whose origins are both in `nodes`.
// @param places  a position for each of `nodes`, or empty; replaced by those of the new nodes
std::vector<int> carried_nodes(const std::vector<int>& nodes, std::size_t old_count,
                               const std::vector<VertexOrigin>& origins,
                               const std::vector<char>& has_matter, std::vector<Vector3d>& places)
{
    std::vector<int> listed(old_count, -1);
    for (std::size_t k = 0; k < nodes.size(); ++k)
        listed[nodes[k]] = static_cast<int>(k);
    std::vector<int> carried;
    std::vector<Vector3d> carried_places;
    for (int v = 0; v < static_cast<int>(origins.size()); ++v) {
        const VertexOrigin& o = origins[v];
        if (listed[o.first] < 0 || listed[o.second] < 0 || !has_matter[v]) continue;
        carried.push_back(v);
        if (!places.empty())
            carried_places.push_back(
                between(places, {listed[o.first], listed[o.second], o.fraction}));
    }
    places = std::move(carried_places);
    return carried;
}

void carry_nodes(Deformable& solid, const std::vector<VertexOrigin>& origins,
                 const std::vector<char>& has_matter)
{
    const std::size_t old_count = solid.positions.size();
    std::vector<Vector3d> positions, velocities;
    for (const VertexOrigin& origin : origins) {
        positions.push_back(between(solid.positions, origin));
        velocities.push_back(between(solid.velocities, origin));
    }
    solid.positions = std::move(positions);
    solid.velocities = std::move(velocities);
    for (Handle& handle : solid.handles)
        handle.nodes =
            carried_nodes(handle.nodes, old_count, origins, has_matter, handle.first_places);
    for (NodeLoad& load : solid.loads) {
        std::vector<Vector3d> none;
        load.nodes = carried_nodes(load.nodes, old_count, origins, has_matter, none);
    }
}

template <class T>
std::vector<T> of_parents(const std::vector<T>& old, const std::vector<int>& parents)
{
    std::vector<T> carried;
    carried.reserve(parents.size());
    for (const int parent : parents)
        carried.push_back(old[parent]);
    return carried;
}

void carry_elements(Deformable& solid, const std::vector<int>& parents)
{
    solid.plastic_strains = of_parents(solid.plastic_strains, parents);
    if (!solid.inverted_times.empty())
        solid.inverted_times = of_parents(solid.inverted_times, parents);
}

// The face of the parent that contains a child's face, or -1 if the child's face is inside the
// parent.
int face_of_parent(const Deformable& solid, const SplitMesh& split, int child, int face)
{
    const auto& parent = solid.rest.tetrahedra[split.parents[child]];
    for (int f = 0; f < 4; ++f) {
        const auto is_on_face = [&](int corner) {
            const VertexOrigin& o = split.origins[split.mesh.tetrahedra[child][corner]];
            const auto has = [&](int v) {
                return parent[f] != v && std::find(parent.begin(), parent.end(), v) != parent.end();
            };
            return has(o.first) && has(o.second);
        };
        const auto& corners = tetrahedron_faces[face];
        if (std::all_of(corners.begin(), corners.end(), is_on_face)) return f;
    }
    return -1;
}

// For each face of the new mesh, whether a crack runs along it: either the face is a part of a
// cracked face, or this split opened it.
std::vector<std::array<bool, 4>> carried_cracks(const Deformable& solid, const SplitMesh& split)
{
    const auto old_neighbours = face_neighbours(solid.rest),
               neighbours = face_neighbours(split.mesh);
    std::vector<std::array<bool, 4>> cracks(split.parents.size(), {false, false, false, false});
    for (int t = 0; t < static_cast<int>(cracks.size()); ++t)
        for (int f = 0; f < 4; ++f) {
            const int parent = split.parents[t], g = face_of_parent(solid, split, t, f);
            const bool was_crack =
                g >= 0 && !solid.crack_faces.empty() && solid.crack_faces[parent][g];
            const bool was_open = g >= 0 && old_neighbours[parent][g] < 0;
            cracks[t][f] = was_crack || (neighbours[t][f] < 0 && !was_open);
        }
    return cracks;
}

// Adds a rotation to the velocities of the nodes of cut elements (`is_near`). The rotation is about
// the center of mass of these nodes, and its angular momentum is L [kg m²/s].
void add_angular_momentum(Deformable& solid, const std::vector<char>& is_near, const Vector3d& L)
{
    double mass = 0;
    Vector3d center = Vector3d::Zero();
    for (std::size_t i = 0; i < is_near.size(); ++i)
        if (is_near[i]) {
            mass += solid.masses[i];
            center += solid.masses[i] * solid.positions[i];
        }
    center /= mass;
    Matrix3d I = Matrix3d::Zero();
    for (std::size_t i = 0; i < is_near.size(); ++i)
        if (is_near[i]) {
            const Vector3d r = solid.positions[i] - center;
            I += solid.masses[i] * (r.squaredNorm() * Matrix3d::Identity() - r * r.transpose());
        }
    const Vector3d w = I.ldlt().solve(L);
    // Nodes that lie on one line have no inertia about it, and w may not be finite. Then no
    // rotation is added.
    if (!w.allFinite()) return;
    for (std::size_t i = 0; i < is_near.size(); ++i)
        if (is_near[i]) solid.velocities[i] += w.cross(solid.positions[i] - center);
}

Vector3d angular_momentum(const Deformable& solid)
{
    Vector3d L = Vector3d::Zero();
    for (std::size_t i = 0; i < solid.masses.size(); ++i)
        L += solid.masses[i] * solid.positions[i].cross(solid.velocities[i]);
    return L;
}

} // namespace

std::vector<MeshFace> marked_faces(const std::vector<std::array<bool, 4>>& crack_faces)
{
    std::vector<MeshFace> faces;
    for (int t = 0; t < static_cast<int>(crack_faces.size()); ++t)
        for (int f = 0; f < 4; ++f)
            if (crack_faces[t][f]) faces.push_back({t, f});
    return faces;
}

void remesh(Deformable& solid, const SplitMesh& split)
{
    const Vector3d L = angular_momentum(solid);
    const bool is_cut = std::any_of(split.origins.begin(), split.origins.end(),
                                    [](const VertexOrigin& o) { return o.first != o.second; });
    solid.crack_faces = carried_cracks(solid, split);
    carry_elements(solid, split.parents);
    carry_nodes(solid, split.origins, std::vector<char>(split.origins.size(), 1));
    solid.rest = split.mesh;
    solid.masses = lumped_masses(solid);
    ++solid.topology;
    if (!is_cut) return;
    std::vector<char> is_near(solid.positions.size(), 0);
    for (const auto& t : solid.rest.tetrahedra) {
        const bool has_new = std::any_of(t.begin(), t.end(), [&](int v) {
            return split.origins[v].first != split.origins[v].second;
        });
        if (has_new)
            for (const int v : t)
                is_near[v] = 1;
    }
    add_angular_momentum(solid, is_near, L - angular_momentum(solid));
}

void remesh(Deformable& solid, EmbeddedMesh embedded)
{
    // The old copies of each element of the uncracked mesh.
    const int old_count = static_cast<int>(solid.rest.tetrahedra.size());
    std::vector<std::vector<int>> copies(solid.uncracked.tetrahedra.size());
    for (int t = 0; t < old_count; ++t)
        copies[solid.embedded.parents.empty() ? t : solid.embedded.parents[t]].push_back(t);

    // The parent of a new copy is the old copy that already had material at the first corner where
    // the new copy has material. Such an old copy exists, because cracks only divide material.
    std::vector<int> parents;
    std::vector<VertexOrigin> origins(embedded.mesh.vertices.size());
    std::vector<char> has_matter(embedded.mesh.vertices.size(), 0);
    for (std::size_t t = 0; t < embedded.mesh.tetrahedra.size(); ++t) {
        const auto& real = embedded.real[t];
        const auto corner = std::find(real.begin(), real.end(), 1) - real.begin();
        int old = -1;
        for (const int copy : copies[embedded.parents[t]])
            if (solid.embedded.real.empty() || solid.embedded.real[copy][corner]) old = copy;
        if (old < 0) // impossible with a correct formula: all material was in an old copy
            throw std::out_of_range("virtual_nodes returned matter that was in no element");
        parents.push_back(old);
        for (int i = 0; i < 4; ++i) {
            const int v = embedded.mesh.tetrahedra[t][i], from = solid.rest.tetrahedra[old][i];
            origins[v] = {from, from, 0};
            if (real[i]) has_matter[v] = 1;
        }
    }
    carry_elements(solid, parents);
    carry_nodes(solid, origins, has_matter);
    solid.rest = embedded.mesh;
    solid.embedded = std::move(embedded);
    solid.masses = lumped_masses(solid);
    ++solid.topology;
}

} // namespace rigor
