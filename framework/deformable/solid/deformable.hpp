// SPDX-License-Identifier: MIT
// Solids that bend, flow and break: their state, and the time step of a world that has them. Linear
// tetrahedra with corotated linear elasticity (Müller and Gross 2004, "Interactive virtual
// materials"), a plastic strain in each element, masses lumped at the nodes.
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

/// How nodes are moved through a time step.
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

/// Where a handle has its nodes at a time. Between two moments it moves evenly.
struct HandleMoment {
    double time = 0;                          // [s]
    Vector3d displacement = Vector3d::Zero(); // from the nodes' first places [m]
    Vector3d rotation = Vector3d::Zero();     // axis times angle, about the pivot, first [rad]
};

/// Nodes that go where they are told, in some or all of x, y and z.
struct Handle {
    std::vector<int> nodes;
    std::vector<Vector3d> first_places; // of the nodes [m]; empty: where the first step finds them
    std::array<bool, 3> axes = {true, true, true}; // which coordinates it holds
    Vector3d pivot = Vector3d::Zero();             // world space [m]
    std::vector<HandleMoment> path;                // times ascending; empty: held in place
    double release = never;                        // when it lets go [s]
};

/// A force spread evenly over nodes, for a while.
struct NodeLoad {
    std::vector<int> nodes;
    Vector3d force = Vector3d::Zero(); // the sum over the nodes [N]
    double start = 0, end = never;     // [s]
};

struct Workspace;

/// Room to work in. A copy of a solid begins without, and makes its own.
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

    std::shared_ptr<Workspace> content; // shared by nobody: it frees what this header need not know
};

/// A deformable solid and its state.
struct Deformable {
    std::string name;
    SolidMaterial material;
    NodeIntegrator integrator = NodeIntegrator::implicit_step;
    FractureMethod fracture_method = FractureMethod::faces;

    TetrahedralMesh rest;                  // as it is without stress, from which strains count [m]
    std::vector<Vector3d> positions;       // of each node, world space [m]
    std::vector<Vector3d> velocities;      // of each node [m/s]
    std::vector<double> masses;            // of each node [kg]
    std::vector<Matrix3d> plastic_strains; // ε_p of each element
    std::vector<Handle> handles;
    std::vector<NodeLoad> loads;
    std::vector<double>
        inverted_times; // of each element, for how long it is; empty: none ever was [s]

    // Of each element and face, whether a crack runs there, open or still closed. Empty without cracks.
    // With virtual nodes: of `uncracked`, along whose faces what is crushed comes off.
    std::vector<std::array<bool, 4>> crack_faces;
    double least_height = 0; // that a cut may leave an element; the first cut says [m]

    // With virtual nodes: the solid before its first crack, its cracks, and what of each element is
    // filled. Empty without cracks: then every element is.
    TetrahedralMesh uncracked;
    std::vector<ElementCrack> cracks;
    EmbeddedMesh embedded;

    int topology = 0; // counts the changes of the mesh

    KeptWorkspace workspace; // what a step derives from all of this; never state
};

} // namespace rigor
