// SPDX-License-Identifier: MIT
#pragma once

#include "scene/trajectory/trajectory.hpp"

#include <filesystem>

namespace rigor {

/// Reads the trajectory in a file. If the file was cut off, the trajectory has the frames before
/// the cut. @throws InputError
Trajectory load_trajectory(const std::filesystem::path& file);

} // namespace rigor
