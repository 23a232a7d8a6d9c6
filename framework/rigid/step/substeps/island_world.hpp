// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/bodies/world.hpp"
#include "rigid/contact/contact_problem.hpp"

#include <optional>
#include <vector>

namespace rigor {

/// A separate world with the bodies of an island and the static bodies near them.
struct IslandWorld {
    World world;
    std::vector<int> bodies; // for each body of `world`, its index in the whole world; ascending
};

/// The bodies of an island, and those that springs connect with them directly or through other
/// bodies, in ascending order. They can be moved alone and in parts.
/// @param near  all contact candidates of the step
/// @return nothing if they cannot, because one of them is in another island or may touch a body
///         that is not among them, or because a deformable solid presses on one of them
std::optional<std::vector<int>> bodies_moved_together(const World& world,
                                                      const ContactProblem& problem,
                                                      const Island& island,
                                                      const std::vector<Contact>& near);

/// Copies these bodies, in ascending order, and the static bodies that contacts in `near` or
/// springs connect with them.
IslandWorld island_world(const World& world, const std::vector<int>& moved,
                         const std::vector<Contact>& near);

} // namespace rigor
