// SPDX-License-Identifier: MIT
// The path of the launcher, the program that puts up the sandbox around itself (`main/`) and
// becomes another program.
#pragma once

namespace rigor {

inline constexpr const char* launcher_path = RIGOR_LAUNCHER;

} // namespace rigor
