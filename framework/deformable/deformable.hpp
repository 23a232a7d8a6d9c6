// SPDX-License-Identifier: MIT
// Solids that bend, flow and break: their state, and the time step of a world that has them. Linear
// tetrahedra with corotated linear elasticity (Müller and Gross 2004, "Interactive virtual
// materials"), a plastic strain in each element, masses lumped at the nodes.
//
// Stresses and strains of an element are in its rest space: F = R S is its deformation gradient,
// ε = ½ (S + Sᵀ) - δ its total strain, σ of the elastic strain ε - ε_p.
#pragma once

#include "formulas/types.hpp"
#include "rigid/bodies/world.hpp"

#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace rigor {

inline constexpr double never = std::numeric_limits<double>::infinity();

/// What a solid is made of.
struct SolidMaterial {
    double density = 1000;       // ρ [kg/m³]
    double youngs_modulus = 1e6; // E > 0 [Pa]
    double poisson_ratio = 0.3;  // ν, -1 … 0.5, both excluded
    double damping = 0;          // of strain: the force β K v [s]
    double drag = 0;             // of motion: the force -α m v [1/s]
    double yield_stress = never; // σ_Y [Pa]
    double strength = never;     // largest principal stress that it bears [Pa]
    Material surface;            // restitution and friction, as of a rigid body

    double lame_lambda() const // λ [Pa]
    {
        return youngs_modulus * poisson_ratio / ((1 + poisson_ratio) * (1 - 2 * poisson_ratio));
    }
    double shear_modulus() const { return youngs_modulus / (2 * (1 + poisson_ratio)); } // G [Pa]
};

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
struct WorkspaceOf {
    WorkspaceOf();
    WorkspaceOf(const WorkspaceOf&);
    WorkspaceOf(WorkspaceOf&&) noexcept;
    WorkspaceOf& operator=(WorkspaceOf) noexcept;
    ~WorkspaceOf();

    std::unique_ptr<Workspace> content;
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
        inside_out_times; // of each element, for how long it is; empty: none ever was [s]

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

    WorkspaceOf workspace; // what a step derives from all of this; never state
};

/// A point of the drawn surface, which moves with an element: Σ weights[i] x_corner i.
struct EmbeddedPoint {
    int element = 0;
    Eigen::Vector4d weights = Eigen::Vector4d::Zero(); // barycentric, sum 1
};

/// A triangle of the drawn surface, counter-clockwise seen from outside.
struct EmbeddedTriangle {
    std::array<int, 3> points = {0, 0, 0};
    int element = 0;       // that it belongs to
    bool is_crack = false; // opened by a crack
};

/// The surface of a deformable as its mesh is now; it changes only with `topology`.
struct EmbeddedSurface {
    std::vector<EmbeddedPoint> points;
    std::vector<EmbeddedTriangle> triangles;
};

/// Rigid bodies and deformable solids.
struct DeformableWorld {
    World rigid; // its gravity and time are those of all
    std::vector<Deformable> solids;
};

/// A solid at rest in the shape `rest`, moved to its place: masses lumped, everything else zero.
Deformable make_deformable(std::string name, TetrahedralMesh rest, const SolidMaterial& material,
                           const Matrix3d& rotation, const Vector3d& translation);

/// One time step: the nodes' motion with their contacts, plastic flow, fracture; then the rigid bodies'
/// step. Work is counted in world.rigid.counters.
///
/// Of a solid with a strength, an element that is inside out for longer than it takes to turn back, and
/// that no handle holds, has failed: it comes off along all its faces, a crack, and gets back the shape that
/// it has without stress. Mass, volume, momentum and angular momentum stay; energy is lost.
/// @return the contacts among rigid bodies that got an impulse
std::vector<ContactRecord> step(DeformableWorld& world, double time_step);

/// Stress of each element by its elastic strain, in its rest space [Pa].
std::vector<Matrix3d> element_stresses(const Deformable& solid);

/// The surface to draw, cracks included.
EmbeddedSurface drawn_surface(const Deformable& solid);

/// Of each element, the number of the piece that it belongs to, from 0. Elements of a piece hang
/// together by vertices.
std::vector<int> pieces(const Deformable& solid);

/// Sums over a deformable.
struct DeformableTotals {
    double mass = 0, volume = 0;                   // [kg], of the matter at rest [m³]
    double kinetic_energy = 0, elastic_energy = 0; // [J]
    Vector3d momentum = Vector3d::Zero();          // [kg m/s]
    Vector3d angular_momentum = Vector3d::Zero();  // about the origin [kg m²/s]
    Vector3d center_of_mass = Vector3d::Zero();    // [m]
};
DeformableTotals totals(const Deformable& solid);

} // namespace rigor
