// SPDX-License-Identifier: MIT
// The processor that a thread runs on. Two processes that ask and answer in turn are fast only if
// they run on different ones.
#pragma once

namespace rigor {

/// Whether this thread may use one processor only.
bool has_one_processor();

/// Whether the machine has at least as many processors as threads that run or wait for one, so that
/// a thread that waits could run elsewhere. Takes some microseconds.
bool has_idle_processor();

/// Makes this thread go on on another processor. Afterwards it may use the same processors as
/// before.
/// @return whether there is another one that it may use
bool leave_processor();

} // namespace rigor
