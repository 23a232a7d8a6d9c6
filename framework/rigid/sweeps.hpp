// SPDX-License-Identifier: MIT
// What sweeps over an island's contacts have in common, whoever does the arithmetic of a contact.
#pragma once

#include "rigid/contact_problem.hpp"

#include <memory>

namespace rigor {

/// A contact that is held, and what of it stays the same from sweep to sweep.
struct Held {
    int contact = 0;         // its index in the problem
    double target = 0;       // v·n at the end of the stage: -gap/h where there is a gap [m/s]
    double normal_K = 0;     // nᵀKn [1/kg]
    double tangential_K = 0; // λ, the larger eigenvalue of K across n [1/kg]
};

/// The contacts of an island that anything can move, in the order of its pairs: from the lowest up.
Joined<Held> held_contacts(const ContactProblem& problem, const Island& island);

/// What a sweep changed: the largest change and the largest impulse, as velocities [m/s], and the
/// squared length of all changes.
struct Progress {
    double change = 0, total = 0, squared = 0;
};

/// One way to sweep: each contact once, its law with all the others in place. The impulses start from
/// the contacts' `guess` and end as their `holding`.
class Sweeps {
public:
    virtual ~Sweeps() = default;

    /// Visits each contact once. @param steps  what it changed of each held contact's impulse
    virtual Progress sweep(std::vector<Vector3d>& steps) = 0;
    /// The impulses as they are.
    virtual std::vector<Vector3d> impulses() const = 0;
    /// Changes the impulses by these.
    virtual void add(const std::vector<Vector3d>& changes) = 0;
    /// Leaves bodies and contacts as the impulses made them.
    virtual void finish() = 0;
};

/// By the formulas of topic `collision`: `collision_impulse` with ε = 0 answers for the velocity that
/// is left when the contact's own impulse is taken back, with K freed of its coupling between normal
/// and tangent, K̃ = (nᵀKn) n nᵀ + λ (δ - n nᵀ). The fixed point is the same for sticking; for sliding,
/// friction is then opposite to the velocity at the end of the step, so that a block on an incline
/// slides with g (sin θ - μ cos θ) to rounding and does not turn.
std::unique_ptr<Sweeps> collision_law_sweeps(ContactProblem& problem, std::span<const Held> held);

/// By `resolve_simultaneously`, one sweep a call.
std::unique_ptr<Sweeps> simultaneous_sweeps(ContactProblem& problem, std::span<const Held> held);

/// The same sweeps as the reference's formulas do, of either kind, without calling them.
///
/// @param island  with its blocks: they are swept by all of the problem's team
std::unique_ptr<Sweeps> optimised_sweeps(ContactProblem& problem, const Island& island,
                                         std::span<const Held> held);

} // namespace rigor
