// SPDX-License-Identifier: MIT
// The state of a solid that bends, flows and breaks. Linear tetrahedra with corotated linear
// elasticity (Müller and Gross 2004, "Interactive virtual materials"), a plastic strain in each
// element, masses lumped at the nodes.
//
// Stresses and strains of an element are in its rest space: F = R S is its deformation gradient,
// ε = ½ (S + Sᵀ) - δ its total strain, σ of the elastic strain ε - ε_p.
#pragma once

#include "deformable/solid/solid_material.hpp"
#include "formulas/types.hpp"

#include <array>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace rigor {

/// How the nodes move through a time step.
enum class NodeIntegrator {
    explicit_step, ///< symplectic Euler, in substeps no longer than the mesh and material allow
    implicit_step, ///< backward Euler, one sparse linear system a step
};

/// What a crack does to the mesh.
enum class FractureMethod {
    faces,         ///< `split_along_faces`, along the face that `closest_face` says
    elements,      ///< `split_element`
    virtual_nodes, ///< `virtual_nodes`
};

/// Where a handle has its nodes at one time. Between two moments its motion is linear in time.
struct HandleMoment {
    double time = 0;                          // [s]
    Vector3d displacement = Vector3d::Zero(); // from the nodes' initial places [m]
    Vector3d rotation =
        Vector3d::Zero(); // axis times angle, about the pivot, before the displacement [rad]
};

/// Nodes whose motion is prescribed, in some or all of x, y and z.
struct Handle {
    std::vector<int> nodes;
    std::vector<Vector3d> first_places; // initial places [m]; empty: taken at the first step
    std::array<bool, 3> axes = {true, true, true}; // the coordinates that it prescribes
    Vector3d pivot = Vector3d::Zero();             // world space [m]
    std::vector<HandleMoment> path;                // times ascending; empty: held in place
    double release = never;                        // the time when the nodes become free [s]
};

/// A force spread evenly over nodes between two times.
struct NodeLoad {
    std::vector<int> nodes;
    Vector3d force = Vector3d::Zero(); // the sum over the nodes [N]
    double start = 0, end = never;     // [s]
};

struct Workspace;

/// What a time step derives from a solid and keeps for the next one. A copy of a solid begins
/// without it and makes its own.
struct KeptWorkspace {
    KeptWorkspace() = default;
    KeptWorkspace(const KeptWorkspace&) {}
    KeptWorkspace(KeptWorkspace&&) noexcept = default;
    KeptWorkspace& operator=(KeptWorkspace other) noexcept
    {
        content = std::move(other.content);
        return *this;
    }
    ~KeptWorkspace() = default;

    std::shared_ptr<Workspace> content; // never shared; frees a type that is incomplete here
};

/// A deformable solid and its state.
struct Deformable {
    std::string name;
    SolidMaterial material;
    NodeIntegrator integrator = NodeIntegrator::implicit_step;
    FractureMethod fracture_method = FractureMethod::faces;

    TetrahedralMesh rest;             // the mesh without stress, the reference of all strains [m]
    std::vector<Vector3d> positions;  // position of each node, world space [m]
    std::vector<Vector3d> velocities; // velocity of each node [m/s]
    std::vector<double> masses;       // mass of each node [kg]
    std::vector<Matrix3d> plastic_strains; // ε_p of each element
    std::vector<Handle> handles;
    std::vector<NodeLoad> loads;
    // For each element, how long it has been inverted [s]. Empty as long as none ever was.
    std::vector<double> inverted_times;

    // For each element and face, whether a crack runs there, open or still closed. Empty without
    // cracks. With virtual nodes these are faces of `uncracked`, along which inverted elements were
    // separated.
    std::vector<std::array<bool, 4>> crack_faces;
    double least_height = 0; // smallest height that a cut may leave; set by the first cut [m]

    // With virtual nodes: the solid before its first crack, its cracks, and the share of each
    // element that matter fills. Empty without cracks, when matter fills every element.
    TetrahedralMesh uncracked;
    std::vector<ElementCrack> cracks;
    EmbeddedMesh embedded;

    int topology = 0; // number of changes of the mesh so far

    KeptWorkspace workspace; // derived from all of the above; never state
};

} // namespace rigor
