// SPDX-License-Identifier: MIT
#pragma once

#include "formulas/contact.hpp"
#include "rigid/contact/contact_problem.hpp"

namespace rigor {

/// An island as input for the formulas of topic `contact`: a list of bodies, and the contacts
/// between them. The contacts refer to the bodies by their places in this list.
struct LocalIsland {
    std::vector<int> indices; // indices of the bodies in the world
    std::vector<Body> bodies; // the island's bodies and the static bodies that they touch
    std::vector<BodyContact> contacts;
};

/// @param active  indices of the contacts in the problem; the contacts of the local island have the
///                same order
LocalIsland local_island(const ContactProblem& problem, std::span<const int> active);

/// Stores the result of a formula in the problem.
///
/// @param formula  the name of the formula, for the error message
/// @throws std::out_of_range if the result has another number of bodies or contacts
void take_result(ContactProblem& problem, const LocalIsland& local, std::span<const int> active,
                 const ContactResult& result, const char* formula);

/// @throws std::out_of_range if the result has another number of bodies or contacts
void check_size(const LocalIsland& local, const ContactResult& result, const char* formula);

} // namespace rigor
