// SPDX-License-Identifier: MIT
// An island as the formulas of topic `contact` see it: bodies and contacts with indices of their own.
#pragma once

#include "rigid/sweeps.hpp"

namespace rigor {

struct LocalIsland {
    std::vector<int> indices; // of the bodies in the world
    std::vector<Body> bodies; // static ones that are touched too
    std::vector<BodyContact> contacts;
};

/// @param held  contacts to look at, in the order they shall be in
LocalIsland local_island(const ContactProblem& problem, std::span<const Held> held);

/// Puts the result of a formula back into the problem.
///
/// @param formula  whose result it is, for the message
/// @throws std::out_of_range if it has another number of bodies or contacts
void take_result(ContactProblem& problem, const LocalIsland& local, std::span<const Held> held,
                 const ContactResult& result, const char* formula);

/// @throws std::out_of_range if a result has another number of bodies or contacts
void check_size(const LocalIsland& local, const ContactResult& result, const char* formula);

/// Contacts by `resolve_contacts`, then, if `shock`, by `contact_levels` and `shock_propagation`.
void resolve_one_at_a_time(ContactProblem& problem, std::span<const Held> held, bool shock);

} // namespace rigor
