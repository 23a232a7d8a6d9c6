// SPDX-License-Identifier: MIT
// Runs a world and records what a case asks for.
#pragma once

#include "rigid/bodies/world.hpp"
#include "stress/stress.hpp"

namespace rigor::stress {

/// Kinetic and potential energy of all moving bodies [J].
double kinetic_energy(const World& world);
double total_energy(const World& world);

/// Sum over the moving bodies of mass times |g| times `height`: the energy of lifting all of them.
double lifting_energy(const World& world, double height);

/// The largest overlap of any two bodies, not both static [m]. Meshes are measured as the boxes that
/// bound them: here they are slabs.
double deepest_overlap(const World& world);

class Watch {
public:
    /// @param energy_scale  unit of the energy gain [J]; if 0, the kinetic energy at the start
    Watch(World world, Record& record, double energy_scale);

    /// Steps on; the overlap is measured after every `every` steps and after the last. Stops at a state
    /// that is not a number. @param each  called after every step
    void run(int steps, double time_step, int every = 1, const std::function<void()>& each = {});

    void limit_penetration(double most);
    void limit_energy(double most, char tolerance_class = 'I');

    /// How far the farthest moving body is from where it started [m].
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
