// SPDX-License-Identifier: MIT
// Where nodes of a solid meet rigid bodies.
#pragma once

#include "deformable/deformable.hpp"
#include "geometry/shapes/pose.hpp"
#include "rigid/detection/shapes/distance_field.hpp"

namespace rigor {

/// The rigid bodies as the solids meet them in a step. Impulses belong to the poses at its start, as in
/// the rigid step, so that angular momentum is kept to rounding; surfaces move on in substeps.
struct RigidSide {
    explicit RigidSide(const World& world);

    /// Moves the surfaces on.
    void advance(double time_step);
    /// Gives bodies the velocities that impulses gave them, and wakes those that got any.
    void give_back(World& to, double time_step) const;
    /// Whether other bodies hold it, or hold on to it.
    bool rests(int body) const;
    void push(int body, const Vector3d& point, const Vector3d& impulse);

    const World& world;
    std::vector<Body> bodies;
    std::vector<Pose> surfaces;
    std::vector<char> is_pushed;
};

/// A node that is, or soon may be, at the surface of a part of a rigid body.
struct NodeContact {
    int node = 0, body = 0;
    int part = 0;                        // among those that are near
    double gap = 0;                      // negative inside [m]
    Vector3d normal = Vector3d::UnitY(); // of the body, outwards
    double restitution = 0, friction = 0;
};

class NodeContacts {
public:
    /// The nodes that may meet a body within a step.
    void find(const Deformable& solid, const std::vector<char>& is_surface, const RigidSide& rigid,
              double time_step, Counters& counters);
    /// Gaps and normals where the nodes and the surfaces are now. Of a node in several parts' reach
    /// each counts.
    void measure(const Deformable& solid, const RigidSide& rigid);

    std::vector<NodeContact>& all() { return contacts_; }
    const std::vector<NodeContact>& all() const { return contacts_; }

private:
    struct NearPart {
        int body;
        Pose in_body;
        DistanceField field;
    };
    std::vector<NearPart> parts_;
    std::vector<NodeContact> contacts_;
};

/// A node as a body: its point is its center.
Body node_body(const Deformable& solid, int node, double inverse_mass);

/// Nodes that would be inside a body after `time_step` get the impulse of a collision, and the bodies
/// its opposite: `collision_impulse` with K = δ/m + K of the body. With restitution, before the forces of
/// a substep; without, after them: then a gap that is left may close within the substep.
void collide_nodes(Deformable& solid, const std::vector<char>& is_held,
                   const NodeContacts& contacts, RigidSide& rigid, double time_step,
                   bool with_restitution, Counters& counters);

/// Moves nodes out of bodies, without a velocity: by a fifth of their depth a step, and no faster than
/// the solid's radius a second.
void heal_nodes(Deformable& solid, const std::vector<char>& is_held, const NodeContacts& contacts,
                double step_share, double farthest);

} // namespace rigor
