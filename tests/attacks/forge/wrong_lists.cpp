// SPDX-License-Identifier: MIT
// Formulas that answer with lists of other lengths than their arguments, and with indices of what
// does not exist. A caller that does not check them reads and writes beyond its own arrays.
#include "formulas/collision.hpp"
#include "formulas/contact.hpp"
#include "formulas/fracture.hpp"

namespace rigor {

ContactResult resolve_contacts(const std::vector<Body>&, const std::vector<BodyContact>&, int)
{
    return {};
}

ContactResult shock_propagation(const std::vector<Body>& bodies, const std::vector<BodyContact>&,
                                const std::vector<int>&, int)
{
    return {bodies, {}};
}

ContactResult resolve_simultaneously(const std::vector<Body>&,
                                     const std::vector<BodyContact>& contacts, int)
{
    return {{}, std::vector<Vector3d>(contacts.size(), Vector3d::Zero())};
}

std::vector<int> contact_levels(const std::vector<std::vector<int>>&, const std::vector<bool>&)
{
    return {1 << 30};
}

std::optional<int> deepest_approaching_point(const std::vector<ContactPoint>&)
{
    return 1 << 30;
}

std::vector<Matrix3d> smooth_stress(const std::vector<Matrix3d>&,
                                    const std::vector<std::vector<int>>&,
                                    const std::vector<double>&)
{
    return {};
}

int closest_face(const std::array<Vector3d, 4>&, const Vector3d&)
{
    return -(1 << 30);
}

SplitMesh split_along_faces(const TetrahedralMesh& mesh, const std::vector<MeshFace>&)
{
    return {mesh, {}, {}};
}

SplitMesh split_element(const TetrahedralMesh& mesh, int, const Vector3d&)
{
    return {{mesh.vertices, {{0, 1, 2, 1 << 30}}}, {}, {}};
}

EmbeddedMesh virtual_nodes(const TetrahedralMesh& mesh, const std::vector<ElementCrack>&)
{
    return {mesh, {}, {}, {}, {}};
}

} // namespace rigor
