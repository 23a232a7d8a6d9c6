// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/bodies/world.hpp"
#include "rigid/contact/contact_problem.hpp"

namespace rigor {

/// Contacts of the same two bodies, one after the other.
std::vector<ContactPair> pairs_of(std::span<const ContactConstraint> contacts);

/// Puts pairs in order by their lowest contacts, the first of each: an order that does not depend on how the
/// bodies are numbered.
void sort_by_height(const ContactProblem& problem, std::vector<ContactPair>& pairs);

/// The islands in which two bodies would penetrate, in the order of their first pairs.
std::vector<Island> islands_of(const World& world, const ContactProblem& problem,
                               const std::vector<ContactPair>& pairs);

} // namespace rigor
