// SPDX-License-Identifier: MIT
// Keeps the data that a step derives from a solid. If the mesh or the material has changed, all
// this data is made again; otherwise only the plastic strains are copied.
#include "deformable/motion/workspace.hpp"

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

// Nodes that may be in contact: the corners of the boundary faces, without virtual corners
// (`EmbeddedMesh::real`).
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

} // namespace

Workspace::Workspace(const Deformable& solid)
    : ElementWorkspace(solid), topology(solid.topology), material(solid.material),
      is_surface(surface_nodes(solid, face_neighbours)), forces(solid.rest.vertices.size()),
      held_axes(solid.rest.vertices.size())
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
        content = std::make_shared<Workspace>(solid);
    else
        for (int e = 0; e < content->elements.size(); ++e)
            content->elements.set_plastic_strain(e, solid.plastic_strains[e]);
    return *content;
}

} // namespace rigor
