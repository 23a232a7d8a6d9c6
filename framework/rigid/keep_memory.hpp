// SPDX-License-Identifier: MIT
#pragma once

namespace rigor {

/// Has this process keep the memory that it frees, up to 1 GB. A step of thousands of bodies needs megabytes:
/// given back to the system after each step, they have to be fetched again page by page, which takes a tenth
/// of the time. For programs that run steps, once at their start; does nothing without the GNU C library.
void keep_freed_memory();

} // namespace rigor
