// SPDX-License-Identifier: MIT
// Common interface of the sweeps over an island's contacts, which differ in the formulas for the
// impulse of a single contact. A sweep is one iteration of projected Gauss–Seidel: it solves each
// contact in turn while all others are kept as they are.
#pragma once

#include "rigid/contact/contact_problem.hpp"

#include <memory>

namespace rigor {

/// The changes of a sweep: the largest change and the largest impulse, both as velocities [m/s],
/// and the sum of nᵀKn |Δj|² over all changes Δj of impulses.
struct SweepProgress {
    double change = 0, total = 0, squared = 0;
};

/// One kind of sweep. The impulses start from the contacts' `initial_impulse` and end as their
/// `contact_impulse`. Lists of impulses are in the order of the active contacts that were given
/// when the sweeps were made (see active_contacts.hpp).
class Sweeps {
public:
    virtual ~Sweeps() = default;

    /// Visits each contact once.
    /// @param steps  receives the change of each contact's impulse
    virtual SweepProgress sweep(std::vector<Vector3d>& steps) = 0;
    /// The current impulses.
    virtual std::vector<Vector3d> impulses() const = 0;
    /// Adds these changes to the impulses.
    virtual void add(const std::vector<Vector3d>& changes) = 0;
    /// Stores the resulting velocities and impulses in the problem.
    virtual void finish() = 0;
};

} // namespace rigor
