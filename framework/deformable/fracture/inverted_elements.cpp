// SPDX-License-Identifier: MIT
// Separates elements that stay inverted for too long. The code counts the time of each inverted
// element and cracks all faces of those over the limit. An element that then shares no node gets
// its shape without stress, and a rigid motion with the same momentum and angular momentum.
#include "deformable/fracture/inverted_elements.hpp"

#include "deformable/elasticity/element.hpp"
#include "deformable/elasticity/polar_decomposition.hpp"
#include "deformable/fracture/checked_answers.hpp"
#include "deformable/fracture/remesh.hpp"
#include "deformable/solid/lumped_mass.hpp"
#include "formulas/fracture.hpp"
#include "geometry/tetrahedra/tetrahedra.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rigor {

namespace {

// The time that an element may stay inverted [s]: twenty times the time that a shear wave needs to
// cross it, plus ten steps. An element that can turn back does so within one or two such crossings.
double longest_inversion(const Deformable& solid, int element, double time_step)
{
    const SolidMaterial& m = solid.material;
    const double length = std::cbrt(tetrahedron_volume(solid.rest, element));
    return 20 * length * std::sqrt(m.density / m.shear_modulus()) + 10 * time_step;
}

bool is_held(const std::vector<HeldNode>& held, const std::array<int, 4>& nodes)
{
    return std::any_of(held.begin(), held.end(), [&](const HeldNode& h) {
        return std::find(nodes.begin(), nodes.end(), h.node) != nodes.end();
    });
}

// Adds the time step to the time of each inverted element, and sets the time of all other elements,
// and of those that a handle holds, to 0.
// @return whether an element has been inverted for too long
bool count_time(Deformable& solid, const ElementWorkspace& work, const std::vector<HeldNode>& held,
                double time_step)
{
    auto& times = solid.inverted_times;
    bool is_over = false;
    for (int e = 0; e < work.elements.size(); ++e) {
        if (!is_inverted(solid.plastic_strains[e], work.strains[e].elastic) ||
            is_held(held, work.elements.nodes(e))) {
            if (!times.empty()) times[e] = 0;
            continue;
        }
        if (times.empty()) times.assign(work.elements.size(), 0.0);
        times[e] += time_step;
        is_over |= times[e] > longest_inversion(solid, e, time_step);
    }
    return is_over;
}

// For each element, whether it shares no node with other elements.
std::vector<char> loose_elements(const TetrahedralMesh& mesh)
{
    std::vector<int> count(mesh.vertices.size(), 0);
    for (const auto& t : mesh.tetrahedra)
        for (const int v : t)
            ++count[v];
    std::vector<char> is_loose;
    for (const auto& t : mesh.tetrahedra)
        is_loose.push_back(
            std::all_of(t.begin(), t.end(), [&](int v) { return count[v] == 1; }) ? 1 : 0);
    return is_loose;
}

// Marks a crack along all faces of the separated elements.
void mark_faces(std::vector<std::array<bool, 4>>& crack_faces,
                const std::vector<std::array<int, 4>>& neighbours,
                const std::vector<char>& is_separated)
{
    crack_faces.resize(neighbours.size(), {false, false, false, false});
    for (std::size_t t = 0; t < neighbours.size(); ++t)
        for (int f = 0; f < 4; ++f) {
            const int other = neighbours[t][f];
            if (other >= 0 && (is_separated[t] || is_separated[other])) crack_faces[t][f] = true;
        }
}

// Separates elements of a solid with virtual nodes. If a copy has to be separated, the element of
// the uncracked mesh from which it was copied is separated, together with all its copies.
void separate_copies(Deformable& solid, const std::vector<char>& is_separated)
{
    if (solid.uncracked.tetrahedra.empty()) solid.uncracked = solid.rest;
    const auto& parents = solid.embedded.parents;
    std::vector<char> is_parent_separated(solid.uncracked.tetrahedra.size(), 0);
    for (std::size_t e = 0; e < is_separated.size(); ++e)
        if (is_separated[e]) is_parent_separated[parents.empty() ? e : parents[e]] = 1;
    mark_faces(solid.crack_faces, face_neighbours(solid.uncracked), is_parent_separated);
    SplitMesh split = checked_split_along_faces(
        split_along_faces(solid.uncracked, marked_faces(solid.crack_faces)), solid.uncracked);
    solid.uncracked = std::move(split.mesh);
    remesh(solid, checked_embedding(virtual_nodes(solid.uncracked, solid.cracks), solid.uncracked));
}

void separate_elements(Deformable& solid, const ElementWorkspace& work,
                       const std::vector<char>& is_separated)
{
    if (solid.fracture_method == FractureMethod::virtual_nodes)
        return separate_copies(solid, is_separated);
    mark_faces(solid.crack_faces, work.face_neighbours, is_separated);
    remesh(solid, checked_split_along_faces(
                      split_along_faces(solid.rest, marked_faces(solid.crack_faces)), solid.rest));
}

} // namespace

bool relax_element(Deformable& solid, int element)
{
    const auto& nodes = solid.rest.tetrahedra[element];
    double m = 0;
    Vector3d c = Vector3d::Zero(), P = Vector3d::Zero(), X_c = Vector3d::Zero();
    for (const int i : nodes) {
        m += solid.masses[i];
        c += solid.masses[i] * solid.positions[i];
        P += solid.masses[i] * solid.velocities[i];
        X_c += solid.masses[i] * solid.rest.vertices[i];
    }
    c /= m;
    X_c /= m;
    const Vector3d v_c = P / m;
    const Matrix3d S = Matrix3d::Identity() + solid.plastic_strains[element];
    const Matrix3d A = polar_decomposition(deformation_gradient(solid, element)).R * S;
    Vector3d L = Vector3d::Zero();
    Matrix3d I = Matrix3d::Zero();
    double energy = matter_volume(solid, element) * energy_density(solid, element);
    for (const int i : nodes) {
        const Vector3d v = solid.velocities[i] - v_c, r = A * (solid.rest.vertices[i] - X_c);
        energy += 0.5 * solid.masses[i] * v.squaredNorm();
        L += solid.masses[i] * (solid.positions[i] - c).cross(v);
        I += solid.masses[i] * (r.squaredNorm() * Matrix3d::Identity() - r * r.transpose());
    }
    const Vector3d w = I.ldlt().solve(L);
    if (!(0.5 * L.dot(w) <= energy)) return false;
    for (const int i : nodes) {
        const Vector3d r = A * (solid.rest.vertices[i] - X_c);
        solid.positions[i] = c + r;
        solid.velocities[i] = v_c + w.cross(r);
    }
    return true;
}

bool separate_inverted_elements(Deformable& solid, const ElementWorkspace& work,
                                const std::vector<HeldNode>& held, World& world, double time_step)
{
    if (!count_time(solid, work, held, time_step)) return false;
    const std::vector<char> was_loose = loose_elements(solid.rest);
    std::vector<char> is_separated(was_loose.size(), 0);
    int count = 0;
    for (int e = 0; e < static_cast<int>(is_separated.size()); ++e)
        if (solid.inverted_times[e] > longest_inversion(solid, e, time_step) && !was_loose[e]) {
            is_separated[e] = 1;
            ++count;
        }
    if (count > 0) {
        separate_elements(solid, work, is_separated);
        world.counters.cracks += count;
        ++world.counters.mesh_changes;
    }
    const std::vector<char> is_loose = loose_elements(solid.rest);
    for (int e = 0; e < static_cast<int>(is_loose.size()); ++e) {
        if (!(solid.inverted_times[e] > longest_inversion(solid, e, time_step))) continue;
        if (is_loose[e]) relax_element(solid, e);
        solid.inverted_times[e] = 0;
    }
    return true;
}

} // namespace rigor
