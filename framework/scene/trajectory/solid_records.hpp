// SPDX-License-Identifier: MIT
// The deformable solids of a recorded frame, read from the bytes of a trajectory.
#pragma once

#include "scene/trajectory/cursor.hpp"
#include "scene/trajectory/trajectory.hpp"

#include <memory>
#include <string>

namespace rigor {

/// The sizes of the mesh of a solid.
struct TopologyCounts {
    std::size_t nodes = 0, elements = 0, points = 0, triangles = 0, pieces = 0;
};

constexpr std::size_t topology_counts_size = 5 * sizeof(std::uint32_t); // [bytes]

/// @param where  names the solid in error messages
/// @throws InputError, also if a count is larger than its limit
TopologyCounts read_topology_counts(ByteCursor& bytes, const std::string& where);

/// The number of bytes of a mesh, and the mesh read from them. @throws InputError
std::size_t topology_size(const TopologyCounts& counts);
std::shared_ptr<const SolidTopology> read_topology(ByteCursor& bytes, const TopologyCounts& counts,
                                                   const std::string& where);

/// The number of bytes of the state of a solid, and the state read from them: totals, nodes and
/// elements. @throws InputError
std::size_t solid_frame_size(const SolidTopology& topology);
void read_solid_frame(ByteCursor& bytes, SolidFrame& solid, const std::string& where);

} // namespace rigor
