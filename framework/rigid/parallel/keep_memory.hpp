// SPDX-License-Identifier: MIT
#pragma once

namespace rigor {

/// Makes this process keep the memory that it frees, up to 1 GiB, except for blocks of 32 MiB or
/// more. A step of thousands of bodies allocates megabytes. If this memory went back to the system
/// after each step, the system would have to provide it again page by page, which would take a
/// tenth of the run time. The worker, which runs scenes, calls this function once at its start.
/// Without the GNU C library this function does nothing.
void keep_freed_memory();

} // namespace rigor
