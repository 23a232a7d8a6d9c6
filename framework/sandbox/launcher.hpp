// SPDX-License-Identifier: MIT
// The path of the launcher (`main/`), the program that starts another program in a sandbox.
#pragma once

namespace rigor {

inline constexpr const char* launcher_path = RIGOR_LAUNCHER;

} // namespace rigor
