// SPDX-License-Identifier: MIT
#pragma once

#include "scene/trajectory/trajectory.hpp"

#include <filesystem>

namespace rigor {

/// The trajectory of a file, as far as the file goes. @throws InputError
Trajectory load_trajectory(const std::filesystem::path& file);

} // namespace rigor
