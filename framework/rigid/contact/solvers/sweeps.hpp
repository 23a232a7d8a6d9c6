// SPDX-License-Identifier: MIT
// Common interface of the sweeps over an island's contacts, which differ in the formulas for the
// impulse of a single contact. A sweep is one iteration of projected Gauss–Seidel: it solves each
// contact in turn while the impulses of all other contacts stay as they are.
#pragma once

#include "rigid/contact/contact_problem.hpp"

#include <memory>

namespace rigor {

/// The changes that a sweep made. Δj is the change of a contact's impulse j, n its normal, and K
/// its impulse matrix. `change` is the largest nᵀKn |Δj| and `total` the largest nᵀKn |j|, both
/// [m/s]; `squared` is the sum of nᵀKn |Δj|² [J].
struct SweepProgress {
    double change = 0, total = 0, squared = 0;
};

/// One kind of sweep. The impulses start from the contacts' `initial_impulse`, and the final
/// impulses are stored as their `contact_impulse`. Lists of impulses are in the order of the active
/// contacts (see active_contacts.hpp), which are passed to the function that makes the sweeps.
class Sweeps {
public:
    virtual ~Sweeps() = default;

    /// Visits each contact once.
    /// @param steps  receives the change of each contact's impulse
    virtual SweepProgress sweep(std::vector<Vector3d>& steps) = 0;
    /// The current impulses.
    virtual std::vector<Vector3d> impulses() const = 0;
    /// Adds these changes to the impulses, one for each contact.
    virtual void add(const std::vector<Vector3d>& changes) = 0;
    /// Stores the final velocities and impulses in the problem.
    virtual void finish() = 0;
};

} // namespace rigor
