// SPDX-License-Identifier: MIT
#pragma once

#include "formulas/contact.hpp"
#include "rigid/contact/contact_problem.hpp"

namespace rigor {

/// An island in the form that the formulas of topic `contact` take: a list of bodies, and the
/// contacts between them. The contacts refer to the bodies by their indices in this list.
struct LocalIsland {
    std::vector<int> indices; // for each of `bodies`, its index in `ContactProblem::bodies`
    std::vector<Body> bodies; // all bodies that an active contact touches, static ones too
    std::vector<BodyContact> contacts;
};

/// @param active  indices in `problem.contacts`; the contacts of the local island are in the same
///                order
LocalIsland local_island(const ContactProblem& problem, std::span<const int> active);

/// Stores the result of a formula in the problem: the velocities of the bodies that are not static,
/// and the impulses as the `contact_impulse` of the active contacts.
///
/// @param formula  the name of the formula, for the error message
/// @throws std::out_of_range if the result does not have one body for each body of `local` and one
///                           impulse for each contact
void take_result(ContactProblem& problem, const LocalIsland& local, std::span<const int> active,
                 const ContactResult& result, const char* formula);

/// Checks the size of the result of a formula.
///
/// @param formula  the name of the formula, for the error message
/// @throws std::out_of_range if the result does not have one body for each body of `local` and one
///                           impulse for each contact
void check_size(const LocalIsland& local, const ContactResult& result, const char* formula);

} // namespace rigor
