// SPDX-License-Identifier: MIT
// What a hostile submission may have left behind on this machine.
#pragma once

#include <string>

namespace rigor::corpus {

/// Takes over every process that loses its parent, so that none goes unseen.
void adopt_orphans();

/// What is left: processes below this one, and files, shared memory, queues, semaphores, sockets
/// and keys with the names that the attacks give them. Empty if nothing is.
std::string leftovers();

} // namespace rigor::corpus
