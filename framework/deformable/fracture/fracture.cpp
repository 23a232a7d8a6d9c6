// SPDX-License-Identifier: MIT
// Opens cracks normal to the largest principal tension where it exceeds the strength (Rankine's
// criterion). If a bound shows that no stress exceeds the strength, nothing is done (optimization
// `stress_bound`). Otherwise the stresses are smoothed, and the elements whose smoothed stress
// exceeds the strength are sorted. The most stressed of them crack, within the limits of
// fracture.hpp. Last, the mesh is changed by one of three methods: along faces, by splitting
// elements, or with virtual nodes (Molino, Bao and Fedkiw 2004).
#include "deformable/fracture/fracture.hpp"

#include "deformable/fracture/checked_answers.hpp"
#include "deformable/fracture/crack_edges.hpp"
#include "deformable/fracture/remesh.hpp"
#include "formulas/fracture.hpp"
#include "formulas/plasticity.hpp"
#include "geometry/tetrahedra/tetrahedra.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace rigor {

namespace {

// An element whose largest principal stress exceeds the strength, and the normal of its crack.
struct Candidate {
    int element = 0;
    double stress = 0; // the largest principal stress [Pa]
    Vector3d normal = Vector3d::UnitX();
};

// An upper bound of the eigenvalues of a stress: mean stress + ⅔ von Mises stress [Pa].
double bound_of(const Matrix3d& stress)
{
    return stress.trace() / 3 + 2.0 / 3 * von_mises(stress);
}

// An upper bound of the eigenvalues of the stress that this elastic strain causes [Pa].
double bound_of(const Matrix3d& strain, double lambda, double G)
{
    const double trace = strain.trace();
    Matrix3d dev = strain;
    dev.diagonal().array() -= trace / 3;
    return (lambda + 2 * G / 3) * trace + 2.0 / 3 * 2 * G * std::sqrt(1.5) * dev.norm();
}

bool may_crack(const ElementWorkspace& work, const SolidMaterial& m)
{
    const double lambda = m.lame_lambda(), G = m.shear_modulus();
    return std::any_of(work.strains.begin(), work.strains.end(), [&](const ElementStrain& s) {
        return bound_of(s.elastic, lambda, G) > m.strength;
    });
}

// The elements whose tension exceeds the strength, the most stressed first.
std::vector<Candidate> candidates(const Deformable& solid, const ElementWorkspace& work,
                                  World& world)
{
    const SolidMaterial& m = solid.material;
    const double lambda = m.lame_lambda(), G = m.shear_modulus();
    std::vector<Matrix3d> stresses;
    std::vector<double> volumes;
    for (int e = 0; e < work.elements.size(); ++e) {
        stresses.push_back(isotropic_stress(work.strains[e].elastic, lambda, G));
        volumes.push_back(work.elements.volume(e));
    }
    const std::vector<Matrix3d> smooth =
        checked_stresses(smooth_stress(stresses, work.stress_neighbours, volumes), stresses.size());
    std::vector<Candidate> found;
    for (int e = 0; e < work.elements.size(); ++e) {
        if (world.settings.optimisations.stress_bound && bound_of(smooth[e]) <= m.strength) {
            ++world.counters.eigenvalues_skipped;
            continue;
        }
        ++world.counters.eigenvalues;
        const auto normal = checked_normal(crack_plane(smooth[e], m.strength));
        if (normal) found.push_back({e, normal->dot(smooth[e] * *normal), *normal});
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const Candidate& a, const Candidate& b) { return a.stress > b.stress; });
    return found;
}

std::array<Vector3d, 4> corners(const TetrahedralMesh& mesh, int element)
{
    std::array<Vector3d, 4> x;
    for (int i = 0; i < 4; ++i)
        x[i] = mesh.vertices[mesh.tetrahedra[element][i]];
    return x;
}

// The nodes of the elements chosen to crack in this step; no other element at these nodes cracks.
class CrackedNodes {
public:
    explicit CrackedNodes(const Deformable& solid) : is_taken_(solid.rest.vertices.size(), 0) {}
    bool any(const std::array<int, 4>& nodes) const
    {
        return std::any_of(nodes.begin(), nodes.end(), [&](int v) { return is_taken_[v] != 0; });
    }
    void add(const std::array<int, 4>& nodes)
    {
        for (const int v : nodes)
            is_taken_[v] = 1;
    }

private:
    std::vector<char> is_taken_;
};

// Cracks elements along their faces. @return the number of cracks
int crack_faces(Deformable& solid, const ElementWorkspace& work,
                const std::vector<Candidate>& found)
{
    CrackedNodes taken(solid);
    int cracks = 0;
    if (solid.crack_faces.empty())
        solid.crack_faces.assign(solid.rest.tetrahedra.size(), {false, false, false, false});
    for (const Candidate& c : found) {
        if (cracks == most_cracks) break;
        const auto& t = solid.rest.tetrahedra[c.element];
        const int f = checked_face(closest_face(corners(solid.rest, c.element), c.normal));
        const int other = work.face_neighbours[c.element][f];
        if (other < 0 || solid.crack_faces[c.element][f] || taken.any(t)) continue;
        taken.add(t);
        const auto& back = work.face_neighbours[other];
        const auto g = std::find(back.begin(), back.end(), c.element) - back.begin();
        // If the neighbor does not list this element, an earlier split by a wrong formula has made
        // a face that three elements share.
        if (g == 4) continue;
        solid.crack_faces[c.element][f] = solid.crack_faces[other][g] = true;
        ++cracks;
    }
    if (cracks == 0) return 0;
    // The faces of earlier cracks are passed again, because the two sides of an earlier crack may
    // not be separated yet.
    remesh(solid, checked_split_along_faces(
                      split_along_faces(solid.rest, marked_faces(solid.crack_faces)), solid.rest));
    return cracks;
}

// The smallest height of an element over one of its faces [m].
double least_height(const TetrahedralMesh& mesh, int element)
{
    double largest = 0; // twice the area of the largest face
    const auto x = corners(mesh, element);
    for (const auto& [i, j, k] : tetrahedron_faces)
        largest = std::max(largest, (x[j] - x[i]).cross(x[k] - x[i]).norm());
    return largest > 0 ? 6 * tetrahedron_volume(mesh, element) / largest : 0;
}

double least_height(const TetrahedralMesh& mesh)
{
    double least = never;
    for (int t = 0; t < static_cast<int>(mesh.tetrahedra.size()); ++t)
        least = std::min(least, least_height(mesh, t));
    return least;
}

// Whether a split makes no sliver and not too many elements. A sliver would need shorter substeps
// than all other elements.
bool is_fine_enough(const Deformable& solid, const SplitMesh& split)
{
    if (split.mesh.tetrahedra.size() > most_tetrahedra) return false;
    std::vector<int> children(solid.rest.tetrahedra.size(), 0);
    for (const int parent : split.parents)
        ++children[parent];
    for (int t = 0; t < static_cast<int>(split.parents.size()); ++t)
        if (children[split.parents[t]] > 1 && least_height(split.mesh, t) < solid.least_height)
            return false;
    return true;
}

// The vertex of an element through which its crack runs: the vertex with the largest `pull`, the
// sum of the stresses of all candidates at this vertex.
int crack_tip(const Deformable& solid, const std::vector<double>& pull, int element)
{
    const auto& t = solid.rest.tetrahedra[element];
    return *std::max_element(t.begin(), t.end(), [&](int a, int b) { return pull[a] < pull[b]; });
}

// Cracks elements by splitting them. Each crack changes the mesh and may renumber the vertices, so
// the vertex of the next crack is found by its position at rest. @return the number of cracks
int crack_elements(Deformable& solid, const std::vector<Candidate>& found)
{
    // The least height of an element after a cut, as a share of the least height in the mesh before
    // the first crack. With a fifth, the stable substep stays above about a fifth of its first
    // value.
    constexpr double least_share = 0.2;
    if (solid.least_height == 0) solid.least_height = least_share * least_height(solid.rest);
    std::vector<double> pull(solid.rest.vertices.size(), 0.0);
    for (const Candidate& c : found)
        for (const int v : solid.rest.tetrahedra[c.element])
            pull[v] += c.stress;
    struct Tip {
        Vector3d place, normal;
    };
    std::vector<Tip> tips;
    CrackedNodes taken(solid);
    for (const Candidate& c : found) {
        if (static_cast<int>(tips.size()) == most_cracks) break;
        const auto& t = solid.rest.tetrahedra[c.element];
        if (taken.any(t)) continue;
        taken.add(t);
        tips.push_back({solid.rest.vertices[crack_tip(solid, pull, c.element)], c.normal});
    }
    int cracks = 0;
    for (const Tip& tip : tips) {
        const auto& vertices = solid.rest.vertices;
        const auto at = std::find(vertices.begin(), vertices.end(), tip.place);
        if (at == vertices.end()) continue;
        const SplitMesh split = checked_split_element(
            split_element(solid.rest, static_cast<int>(at - vertices.begin()), tip.normal),
            solid.rest);
        const bool is_changed = split.mesh.vertices.size() != vertices.size();
        if (!is_changed || !is_fine_enough(solid, split)) continue;
        remesh(solid, split);
        ++cracks;
    }
    return cracks;
}

// Cracks elements with virtual nodes. @return the number of cracks
int crack_with_virtual_nodes(Deformable& solid, const std::vector<Candidate>& found)
{
    // The largest number of cracks in an element of the uncracked mesh. Each crack may double the
    // number of copies of this element. The value was chosen by trial.
    constexpr int most_in_element = 3;
    if (solid.uncracked.tetrahedra.empty()) solid.uncracked = solid.rest;
    std::vector<int> count(solid.uncracked.tetrahedra.size(), 0);
    for (const ElementCrack& crack : solid.cracks)
        ++count[crack.tetrahedron];
    const CrackEdges edges(solid);
    const bool is_embedded = !solid.embedded.parents.empty();
    CrackedNodes taken(solid);
    int cracks = 0;
    // Whether a crack of this step continues an old one. From then on, elements with less stress
    // may continue cracks, but start none.
    bool one_goes_on = false;
    for (const Candidate& c : found) {
        if (cracks == most_cracks) break;
        const int parent = is_embedded ? solid.embedded.parents[c.element] : c.element;
        const auto real = is_embedded ? solid.embedded.real[c.element] : std::array{1, 1, 1, 1};
        const bool is_divisible = std::accumulate(real.begin(), real.end(), 0) > 1;
        const auto& t = solid.rest.tetrahedra[c.element];
        if (!is_divisible || count[parent] >= most_in_element || taken.any(t)) continue;
        // An element gets no second crack whose normal is within about 45° of that of an earlier
        // one: once the earlier crack has opened, the stress that would cause the second is gone.
        if (edges.has_similar(parent, c.normal)) continue;
        const bool goes_on = edges.meets(parent, real);
        if (one_goes_on && !goes_on) continue;
        one_goes_on |= goes_on;
        taken.add(t);
        ++count[parent];
        solid.cracks.push_back(edges.continued(parent, real, c.normal));
        ++cracks;
    }
    if (cracks > 0)
        remesh(solid,
               checked_embedding(virtual_nodes(solid.uncracked, solid.cracks), solid.uncracked));
    return cracks;
}

} // namespace

void fracture(Deformable& solid, const ElementWorkspace& work, World& world)
{
    if (world.settings.optimisations.stress_bound && !may_crack(work, solid.material)) {
        world.counters.eigenvalues_skipped += work.elements.size();
        return;
    }
    const std::vector<Candidate> found = candidates(solid, work, world);
    if (found.empty()) return;
    const int topology = solid.topology;
    int cracks = 0;
    switch (solid.fracture_method) {
    case FractureMethod::faces:
        cracks = crack_faces(solid, work, found);
        break;
    case FractureMethod::elements:
        cracks = crack_elements(solid, found);
        break;
    case FractureMethod::virtual_nodes:
        cracks = crack_with_virtual_nodes(solid, found);
        break;
    }
    world.counters.cracks += cracks;
    world.counters.mesh_changes += solid.topology - topology;
}

} // namespace rigor
