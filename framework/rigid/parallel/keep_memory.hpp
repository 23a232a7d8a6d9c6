// SPDX-License-Identifier: MIT
#pragma once

namespace rigor {

/// Makes this process keep the memory that it frees, up to 1 GB, except for blocks of 32 MB or
/// more. A step of thousands of bodies needs megabytes. If this memory went back to the system
/// after each step, fetching it again page by page would take a tenth of the run time. Programs
/// that run steps call this function once at their start. Without the GNU C library this function
/// does nothing.
void keep_freed_memory();

} // namespace rigor
