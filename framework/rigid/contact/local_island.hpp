// SPDX-License-Identifier: MIT
#pragma once

#include "formulas/contact.hpp"
#include "rigid/contact/contact_problem.hpp"

namespace rigor {

/// An island as the formulas of topic `contact` see it: bodies and contacts with indices of their own.
struct LocalIsland {
    std::vector<int> indices; // of the bodies, in the world
    std::vector<Body> bodies; // with the static ones that are touched
    std::vector<BodyContact> contacts;
};

/// @param active  indices of the contacts in the problem, in the order that they shall have
LocalIsland local_island(const ContactProblem& problem, std::span<const int> active);

/// Puts the result of a formula back into the problem.
///
/// @param formula  its name, for the message
/// @throws std::out_of_range if the result has another number of bodies or contacts
void take_result(ContactProblem& problem, const LocalIsland& local, std::span<const int> active,
                 const ContactResult& result, const char* formula);

/// @throws std::out_of_range if the result has another number of bodies or contacts
void check_size(const LocalIsland& local, const ContactResult& result, const char* formula);

} // namespace rigor
