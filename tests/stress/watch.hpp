// SPDX-License-Identifier: MIT
// Runs a world and records the values that a case has limits for.
#pragma once

#include "rigid/bodies/world.hpp"
#include "stress/stress.hpp"

namespace rigor::stress {

/// Kinetic and potential energy of all moving bodies [J].
double kinetic_energy(const World& world);
double total_energy(const World& world);

/// The energy of lifting all moving bodies: the sum over them of mass times |g| times `height`.
double lifting_energy(const World& world, double height);

/// The largest overlap of any two bodies of which at least one can move [m]. Meshes are measured as
/// their bounding boxes, since the meshes of these scenes are slabs.
double deepest_overlap(const World& world);

class Watch {
public:
    /// @param energy_scale  unit of the energy gain [J]; if 0, the kinetic energy at the start
    Watch(World world, Record& record, double energy_scale);

    /// Takes steps. The overlap is measured every `every` steps and after the last step. Stops at a
    /// state that is not finite.
    ///
    /// @param each  called after every step
    void run(int steps, double time_step, int every = 1, const std::function<void()>& each = {});

    void limit_penetration(double most);
    void limit_energy(double most, char tolerance_class = 'I');

    /// The largest distance of a moving body from its place at the start [m].
    double farthest_moved() const;

    const World& world() const { return world_; }
    const World& start() const { return start_; }

private:
    bool step_once(double time_step);

    World world_, start_;
    Record& record_;
    double energy_ = 0, energy_scale_ = 1; // at the start [J]
};

} // namespace rigor::stress
