// SPDX-License-Identifier: MIT
// What a step derives from a solid, kept until the mesh or the material changes, and its room to work in:
// a step that changes neither allocates nothing.
#pragma once

#include "deformable/contact/node_contacts.hpp"
#include "deformable/elasticity/element_workspace.hpp"
#include "deformable/motion/contact_set.hpp"
#include "deformable/motion/joined_bodies.hpp"
#include "deformable/motion/open_parts.hpp"
#include "deformable/motion/velocity_system.hpp"
#include "deformable/solid/handles.hpp"

namespace rigor {

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
    VelocitySystem velocity_system;
    JoinedBodies bodies;
    ContactSet contact_set;
    OpenParts parts;
    std::vector<SystemBody> no_bodies; // always empty
};

/// The workspace of a solid, made anew if the mesh or the material is not what it was made for.
Workspace& workspace_of(Deformable& solid);

} // namespace rigor
