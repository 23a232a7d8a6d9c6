// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/bodies/world.hpp"
#include "rigid/contact/contact_problem.hpp"

#include <utility>

namespace rigor {

/// Free flight computes springs, applied forces and drag along the path without collisions. A body
/// that bounces leaves this path: a ball that a spring pulls to the ground would get the impulse of
/// a spring that goes on stretching, and gain ½ k v² h² at each bounce. Therefore islands that
/// forces act on and that collisions changed fly again, with their velocities after the collision
/// stage. Until `restore` is called, the states of these bodies in the world have these velocities.
///
/// This is done for islands of at most `most_refined` bodies (detection/overlap_depth.hpp) that are
/// solved in the world (`MovingFrame::is_world`). Integrators whose step has a single stage
/// (symplectic Euler) need none of this.
class BouncedFlight {
public:
    /// @param problem  after the collision stage. If a contact that bounced stays open in the new
    ///                 flight, its `gap_correction` is set so that `predicted_gap` says so.
    /// @param pulled   for each body, whether springs, applied forces or drag act on it
    BouncedFlight(World& world, ContactProblem& problem, const std::vector<bool>& pulled);
    ~BouncedFlight() { restore(); }
    BouncedFlight(const BouncedFlight&) = delete;
    BouncedFlight& operator=(const BouncedFlight&) = delete;

    /// Whether no body has flown again.
    bool is_empty() const { return flown_.empty(); }
    /// For each body, whether its island has flown again; or an empty list.
    const std::vector<bool>& bodies() const { return bodies_; }
    /// The states of all bodies of the world after the new flight.
    const std::vector<RigidState>& flown() const { return flown_; }
    /// Gives the bodies of the world their velocities before the collisions again. A second call
    /// changes nothing.
    void restore();

private:
    World& world_;
    std::vector<std::pair<int, RigidState>> before_; // the bodies with their states before
    std::vector<bool> bodies_;
    std::vector<RigidState> flown_;
};

} // namespace rigor
