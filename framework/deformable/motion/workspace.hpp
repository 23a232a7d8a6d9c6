// SPDX-License-Identifier: MIT
// Data that a step derives from a solid, kept until its mesh or material changes. It includes all
// buffers, so that a step that changes neither allocates nothing.
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
    std::vector<char> is_surface; // for each node, whether it is on the boundary of matter
    double stable_step = 0;       // longest stable explicit substep; 0: not computed yet [s]

    // buffers of a step
    std::vector<Vector3d> forces;
    std::vector<HeldNode> held;
    std::vector<char> is_held; // for each node
    NodeContacts contacts;

    // only for implicit steps
    VelocitySystem velocity_system;
    JoinedBodies bodies;
    ContactSet contact_set;
    OpenParts parts;
    std::vector<SystemBody> no_bodies; // always empty
};

/// The workspace of a solid, made anew if its mesh or material has changed.
Workspace& workspace_of(Deformable& solid);

} // namespace rigor
