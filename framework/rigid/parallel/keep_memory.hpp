// SPDX-License-Identifier: MIT
#pragma once

namespace rigor {

/// Makes this process keep the memory that it frees, up to 1 GB. A step of thousands of bodies
/// needs megabytes; if they went back to the system after each step, fetching them again page by
/// page would take a tenth of the time. Programs that run steps call it once at their start. It
/// does nothing without the GNU C library.
void keep_freed_memory();

} // namespace rigor
