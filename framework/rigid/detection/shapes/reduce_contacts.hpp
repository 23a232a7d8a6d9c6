// SPDX-License-Identifier: MIT
#pragma once

#include "rigid/detection/contact.hpp"

namespace rigor {

/// The largest number of contacts of two shapes that `reduce_contacts` keeps, unless a caller gives
/// another number. With more contacts, the solver would take more time; with fewer, a large contact
/// region would be represented less well.
inline constexpr std::size_t most_contacts = 8;

/// Keeps at most `most` of the contacts from index `first` on, spread over the region of contact.
///
/// The first contact that is kept is the outermost of the deepest contacts. Each next one is the
/// contact that is farthest from those already kept, by position and normal, where a contact with a
/// gap counts less than one that touches. So a ring on a peg keeps contacts on all sides. Last,
/// each kept contact is replaced by the deepest of the contacts that are nearer to it than to any
/// other kept contact.
///
/// @param reach  distance up to which the contacts were searched; a contact with this gap has no
///               weight [m]
void reduce_contacts(std::vector<Contact>& contacts, std::size_t first, double reach,
                     std::size_t most = most_contacts);

} // namespace rigor
