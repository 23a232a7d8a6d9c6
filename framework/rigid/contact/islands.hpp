// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/bodies/world.hpp"
#include "rigid/contact/contact_problem.hpp"

namespace rigor {

/// Groups the contacts by pairs of bodies. The contacts of a pair have to be neighbors in the list;
/// otherwise they make several pairs.
std::vector<ContactPair> pairs_of(std::span<const ContactConstraint> contacts);

/// Sorts pairs by the height of their lowest contact, which is the first contact of each pair. The
/// order does not depend on how the bodies are numbered, except for contacts with equal sort keys
/// (`HeightOrder::Key`).
void sort_by_height(const ContactProblem& problem, std::vector<ContactPair>& pairs);

/// The islands in which at least two bodies would penetrate in this step, in the order in which
/// their first pairs appear in `pairs`.
std::vector<Island> islands_of(const World& world, const ContactProblem& problem,
                               const std::vector<ContactPair>& pairs);

} // namespace rigor
