// SPDX-License-Identifier: MIT
// Where the launcher is: the program that puts up the walls (`main/`) and becomes another one.
#pragma once

namespace rigor {

inline constexpr const char* launcher_path = RIGOR_LAUNCHER;

} // namespace rigor
