// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/detection/contact.hpp"

namespace rigor {

inline constexpr std::size_t most_contacts = 8; // of two shapes

/// Keeps at most so many of the touches from `first` on, spread over where the shapes meet.
///
/// The first is the outermost of the deepest; each next one is the farthest from those before it, by
/// place and direction, where one about to touch counts less than one that does. Then each gives way
/// to the deepest of those it stands for. A ring on a peg keeps touches on all sides.
///
/// @param reach  that they were found with: a touch as far apart as that counts nothing [m]
void reduce_contacts(std::vector<Contact>& contacts, std::size_t first, double reach,
                    std::size_t most = most_contacts);

} // namespace rigor
