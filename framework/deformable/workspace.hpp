// SPDX-License-Identifier: MIT
// What a step derives from a solid, kept until the mesh or the material changes, and its room to work in:
// a step that changes neither allocates nothing.
#pragma once

#include "deformable/block_matrix.hpp"
#include "deformable/elements.hpp"
#include "deformable/node_contacts.hpp"

namespace rigor {

/// A node with some coordinates that a handle holds.
struct HeldNode {
    int node = 0;
    std::array<bool, 3> axes = {true, true, true};
    Vector3d velocity = Vector3d::Zero(); // of those coordinates, to be where the handle wants it
};

struct Workspace {
    explicit Workspace(const Deformable& solid);

    int topology;
    SolidMaterial material;
    std::vector<std::array<int, 4>> face_neighbours;
    std::vector<std::vector<int>>
        stress_neighbours;        // of each element, across faces that no crack runs along
    std::vector<char> is_surface; // of each node: on the boundary of the mesh, and with matter
    Elements elements;
    double stable_step = 0; // of explicit substeps, the longest; 0: not asked for yet [s]

    // of a step
    std::vector<Vector3d> forces;
    std::vector<HeldNode> held;
    std::vector<char> is_held; // of each node
    std::vector<ElementStrain> strains;
    NodeContacts contacts;

    // of an implicit step
    ImplicitSystem system;
    std::vector<Vector3d> momenta, right_side, next_velocities; // of each node
    std::vector<TiedNode> ties;
    std::vector<int> tied_by;        // of each node, the contact; -1: none
    std::vector<char> holds;         // of each contact, how
    std::vector<Vector3d> frictions; // of each contact that slides [N s]
    std::vector<Vector3d> impulses;  // of each contact, on its node [N s]
    std::vector<int> body_numbers;   // of each rigid body, in the system; -1: it is not in it
    std::vector<SystemBody> free_bodies, bodies;
};

/// The workspace of a solid, made anew if the mesh or the material is not what it was made for.
Workspace& workspace_of(Deformable& solid);

} // namespace rigor
