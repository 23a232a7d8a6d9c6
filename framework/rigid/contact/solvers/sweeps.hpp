// SPDX-License-Identifier: MIT
// What all sweeps over an island's contacts have in common, whichever formulas compute the impulse of a
// single contact. Sweeps are the projected Gauss–Seidel iteration: contact by contact, its law with all
// others as they are.
#pragma once

#include "rigid/contact/contact_problem.hpp"

#include <memory>

namespace rigor {

/// What a sweep changed: the largest change and the largest impulse, as velocities [m/s], and the
/// squared length of all changes.
struct Progress {
    double change = 0, total = 0, squared = 0;
};

/// One way to sweep. The impulses start from the contacts' `initial_impulse` and end as their
/// `contact_impulse`. Lists of impulses are in the order of the active contacts, which the sweeps are
/// made with (see active_contacts.hpp).
class Sweeps {
public:
    virtual ~Sweeps() = default;

    /// Visits each contact once. @param steps  becomes the change of each contact's impulse
    virtual Progress sweep(std::vector<Vector3d>& steps) = 0;
    /// The impulses as they are now.
    virtual std::vector<Vector3d> impulses() const = 0;
    /// Adds these changes to the impulses.
    virtual void add(const std::vector<Vector3d>& changes) = 0;
    /// Leaves bodies and contacts as the impulses made them.
    virtual void finish() = 0;
};

} // namespace rigor
