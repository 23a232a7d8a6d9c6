// SPDX-License-Identifier: MIT
// The state of a solid that bends, flows and breaks. It consists of linear tetrahedra with
// corotated linear elasticity (Müller and Gross 2004, "Interactive virtual materials"). Each
// element has a plastic strain, and masses are lumped at the nodes.
//
// Stresses and strains of an element are in the space of the mesh at rest. F = R S is the
// deformation gradient of the element, with a rotation R and a symmetric S. ε = S - δ is its total
// strain, where δ is the unit matrix, ε_p its plastic strain, and σ the stress of its elastic
// strain ε - ε_p.
#pragma once

#include "deformable/solid/solid_material.hpp"
#include "formulas/types.hpp"

#include <array>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace rigor {

/// How the nodes of a deformable solid move through a time step. (For rigid bodies, `Integrator`
/// does this.)
enum class NodeIntegrator {
    explicit_step,  ///< symplectic Euler, in substeps no longer than the mesh and material allow
    implicit_step,  ///< backward Euler: one sparse linear system, solved again while contacts or
                    ///< plastic flow change
    velocity_modes, ///< as one rigid body: the six velocity modes of the lecture
    matrix,         ///< as one rigid body, turned by `advance_matrix`, which makes it grow
};

/// Which formula of formulas/plasticity.hpp decides whether an element yields.
enum class YieldTest {
    strain,       ///< `von_mises_from_strain`
    yield_strain, ///< `von_mises_from_strain` with G = ½, compared with `yield_strain`
    deviator,     ///< `von_mises`
    frobenius,    ///< `von_mises_frobenius`
    principal,    ///< `von_mises_principal`
};

/// When the elements flow plastically.
enum class FlowTime {
    in_step,    ///< within the step, whose forces come from the stress after the flow
    after_step, ///< once after each step, as in the lecture; the step itself is elastic
};

/// Which formula of formulas/fracture.hpp changes the mesh where it cracks.
enum class FractureMethod {
    faces,         ///< `split_along_faces`, along the face that `closest_face` returns
    elements,      ///< `split_element`
    virtual_nodes, ///< `virtual_nodes`
};

/// Where a handle has moved its nodes at one time. Between two moments, displacement and rotation
/// are linear in time.
struct HandleMoment {
    double time = 0;                          // [s]
    Vector3d displacement = Vector3d::Zero(); // from the nodes' initial positions [m]
    // Axis times angle, about `Handle::pivot` [rad]. The nodes rotate first and are then displaced.
    Vector3d rotation = Vector3d::Zero();
};

/// Nodes whose motion is prescribed, in some or all of x, y and z.
struct Handle {
    std::vector<int> nodes;
    std::vector<Vector3d> first_places; // initial positions [m]; if empty, set at the first step
    std::array<bool, 3> axes = {true, true, true}; // the coordinates that the handle prescribes
    Vector3d pivot = Vector3d::Zero();             // center of the rotations, world space [m]
    std::vector<HandleMoment> path; // in order of time; if empty, the nodes stay in place
    double release = never;         // time after which the handle no longer acts on the nodes [s]
};

/// A force that acts between two times and is divided equally among nodes.
struct NodeLoad {
    std::vector<int> nodes;
    Vector3d force = Vector3d::Zero(); // the sum over the nodes [N]
    double start = 0, end = never;     // when the force begins and ends [s]
};

struct Workspace;

/// The data that a time step derives from a solid and keeps for the next step. A copy of a solid
/// starts without this data, and the next step makes the data again.
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

    // The content is never shared. A shared pointer is used because, unlike a unique pointer, it
    // can free a type that is incomplete here.
    std::shared_ptr<Workspace> content;
};

/// A deformable solid and its state.
struct Deformable {
    std::string name;
    SolidMaterial material;
    NodeIntegrator integrator = NodeIntegrator::implicit_step;
    FractureMethod fracture_method = FractureMethod::faces;
    YieldTest yield_test = YieldTest::strain;
    FlowTime flow_time = FlowTime::in_step;

    TetrahedralMesh rest;             // the mesh without stress, the reference of all strains [m]
    std::vector<Vector3d> positions;  // position of each node, world space [m]
    std::vector<Vector3d> velocities; // velocity of each node [m/s]
    std::vector<double> masses;       // mass of each node [kg]
    std::vector<Matrix3d> plastic_strains; // ε_p of each element
    std::vector<Handle> handles;
    std::vector<NodeLoad> loads;
    // For each element, how long it has been inverted [s]. It is empty until an element is inverted
    // for the first time.
    std::vector<double> inverted_times;

    // For each element and face, whether a crack runs along the face, even if its two sides are not
    // separated yet. The list may be empty if there are no cracks. With virtual nodes, it refers to
    // `uncracked` and marks only the faces at which inverted elements were separated from their
    // neighbors.
    std::vector<std::array<bool, 4>> crack_faces;
    // For `FractureMethod::elements`: no cut may leave an element with a height, over any of its
    // faces, below this [m]. It is 0 until an element is to be cut for the first time.
    double least_height = 0;

    // For virtual nodes: `uncracked` is the mesh without cracks (split only around elements that
    // stayed inverted), `cracks` lists the cracks of its elements, and `embedded` is the mesh of
    // the copies of its elements, with the share of each copy that material fills. Before the first
    // crack `embedded` is empty, and material fills every element.
    TetrahedralMesh uncracked;
    std::vector<ElementCrack> cracks;
    EmbeddedMesh embedded;

    int topology = 0; // number of changes of the mesh so far

    KeptWorkspace workspace; // derived from all members above, so it is not part of the state
};

/// Whether the elements flow within a step, and not only once after it.
inline bool flows_in_step(const Deformable& solid)
{
    return solid.material.yield_stress != never && solid.flow_time == FlowTime::in_step;
}

/// Whether a solid moves as one rigid body. Then only the density of its material matters.
inline bool is_rigid(const Deformable& solid)
{
    return solid.integrator == NodeIntegrator::velocity_modes ||
           solid.integrator == NodeIntegrator::matrix;
}

} // namespace rigor
