// SPDX-License-Identifier: MIT
#include "deformable/workspace.hpp"

#include "geometry/tetrahedra/tetrahedra.hpp"

#include <tuple>
#include <utility>

namespace rigor {

namespace {

bool is_same(const SolidMaterial& a, const SolidMaterial& b)
{
    const auto all = [](const SolidMaterial& m) {
        return std::tie(m.density, m.youngs_modulus, m.poisson_ratio, m.damping, m.drag,
                        m.yield_stress, m.strength);
    };
    return all(a) == all(b);
}

// Nodes that may touch something: those of the boundary, but for corners of copies that hold no matter there.
std::vector<char> surface_nodes(const Deformable& solid,
                                const std::vector<std::array<int, 4>>& neighbours)
{
    std::vector<char> is_surface(solid.rest.vertices.size(), 0);
    for (std::size_t t = 0; t < neighbours.size(); ++t)
        for (int f = 0; f < 4; ++f) {
            if (neighbours[t][f] >= 0) continue;
            for (const int i : tetrahedron_faces[f])
                if (solid.embedded.real.empty() || solid.embedded.real[t][i])
                    is_surface[solid.rest.tetrahedra[t][i]] = 1;
        }
    return is_surface;
}

std::vector<std::vector<int>>
uncracked_neighbours(const Deformable& solid, const std::vector<std::array<int, 4>>& neighbours)
{
    std::vector<std::vector<int>> lists(neighbours.size());
    const bool has_cracks = !solid.crack_faces.empty() && solid.embedded.parents.empty();
    for (std::size_t t = 0; t < neighbours.size(); ++t)
        for (int f = 0; f < 4; ++f)
            if (neighbours[t][f] >= 0 && !(has_cracks && solid.crack_faces[t][f]))
                lists[t].push_back(neighbours[t][f]);
    return lists;
}

} // namespace

WorkspaceOf::WorkspaceOf() = default;
WorkspaceOf::WorkspaceOf(const WorkspaceOf&) {}
WorkspaceOf::WorkspaceOf(WorkspaceOf&&) noexcept = default;
WorkspaceOf& WorkspaceOf::operator=(WorkspaceOf other) noexcept
{
    content = std::move(other.content);
    return *this;
}
WorkspaceOf::~WorkspaceOf() = default;

Workspace::Workspace(const Deformable& solid)
    : topology(solid.topology), material(solid.material),
      face_neighbours(rigor::face_neighbours(solid.rest)),
      stress_neighbours(uncracked_neighbours(solid, face_neighbours)),
      is_surface(surface_nodes(solid, face_neighbours)), elements(solid),
      forces(solid.rest.vertices.size()), is_held(solid.rest.vertices.size(), 0)
{
}

Workspace& workspace_of(Deformable& solid)
{
    auto& content = solid.workspace.content;
    const bool is_current =
        content && content->topology == solid.topology &&
        is_same(content->material, solid.material) &&
        content->elements.size() == static_cast<int>(solid.rest.tetrahedra.size());
    if (!is_current)
        content = std::make_unique<Workspace>(solid);
    else
        for (int e = 0; e < content->elements.size(); ++e)
            content->elements.set_plastic_strain(e, solid.plastic_strains[e]);
    return *content;
}

} // namespace rigor
