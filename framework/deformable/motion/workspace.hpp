// SPDX-License-Identifier: MIT
// What a step derives from a solid, kept until the mesh or the material changes, and its room to work in:
// a step that changes neither allocates nothing.
#pragma once

#include "deformable/contact/node_contacts.hpp"
#include "deformable/elasticity/element_workspace.hpp"
#include "deformable/solid/handles.hpp"
#include "deformable/solvers/block_matrix.hpp"

namespace rigor {

/// Momentum that a part of a solid should have and has not, and its mass.
struct LeftOver {
    Vector3d momentum = Vector3d::Zero();
    double mass = 0;
};

struct Workspace : ElementWorkspace {
    explicit Workspace(const Deformable& solid);

    int topology;
    SolidMaterial material;
    std::vector<char> is_surface; // of each node: on the boundary of the mesh, and with matter
    double stable_step = 0;       // of explicit substeps, the longest; 0: not asked for yet [s]

    // of a step
    std::vector<Vector3d> forces;
    std::vector<HeldNode> held;
    std::vector<char> is_held; // of each node
    NodeContacts contacts;

    // of an implicit step
    ImplicitSystem system;
    std::vector<Vector3d> momenta, next_velocities; // of each node
    std::vector<TiedNode> ties;
    std::vector<int> tied_by;       // of each node, the contact; -1: none
    std::vector<char> holds;        // of each contact, how
    std::vector<double> dampings;   // of each contact that slides: friction over speed [kg]
    std::vector<Vector3d> impulses; // of each contact, on its node [N s]
    std::vector<int> body_numbers;  // of each rigid body, in the system; -1: it is not in it
    std::vector<SystemBody> free_bodies, bodies, no_bodies;
    std::vector<char> is_open,
        was_open; // of each part of the system: whether it is solved for again
    std::vector<int> open_nodes;
    char bodies_are_open = 0;
    std::vector<LeftOver> left_over; // of each part
};

/// The workspace of a solid, made anew if the mesh or the material is not what it was made for.
Workspace& workspace_of(Deformable& solid);

} // namespace rigor
