// SPDX-License-Identifier: MIT
// Assignment A7. Read: assignments/a7-fracture/README.md, then framework/formulas/fracture.hpp,
// which says what each function takes and returns, and what it does in special cases.
// Check: ./rigor check fracture, or one task, ./rigor check A7.3
#include "formulas/fracture.hpp"

namespace rigor {

// A7.1  σ̄ₑ = (Vₑ σₑ + Σ Vₘ σₘ) / (Vₑ + Σ Vₘ)
std::vector<Matrix3d> smooth_stress(const std::vector<Matrix3d>& stresses,
                                    const std::vector<std::vector<int>>& neighbours,
                                    const std::vector<double>& volumes)
{
    throw NotImplemented("fracture::smooth_stress");
}

// A7.2  σ n = σ₁ n,  |n| = 1
PrincipalStress principal_stress(const Matrix3d& stress)
{
    throw NotImplemented("fracture::principal_stress");
}

// A7.3  n if σ₁ is positive and exceeds the strength, here `threshold`; else empty
std::optional<Vector3d> crack_plane(const Matrix3d& stress, double threshold)
{
    throw NotImplemented("fracture::crack_plane");
}

// A7.4  the f with the largest |n_f · n|
int closest_face(const std::array<Vector3d, 4>& tetrahedron, const Vector3d& normal)
{
    throw NotImplemented("fracture::closest_face");
}

// A7.5  one vertex for each group of tetrahedra around it that faces connect
SplitMesh split_along_faces(const TetrahedralMesh& mesh, const std::vector<MeshFace>& faces)
{
    throw NotImplemented("fracture::split_along_faces");
}

// A7.6  halve the tetrahedra that cross the plane, then split the mesh along it
SplitMesh split_element(const TetrahedralMesh& mesh, int vertex, const Vector3d& normal)
{
    throw NotImplemented("fracture::split_element");
}

// A7.7  one copy of the tetrahedron for each part of its corners
EmbeddedMesh virtual_nodes(const TetrahedralMesh& mesh, const std::vector<ElementCrack>& cracks)
{
    throw NotImplemented("fracture::virtual_nodes");
}

} // namespace rigor
