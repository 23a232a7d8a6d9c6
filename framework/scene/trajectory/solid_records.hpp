// SPDX-License-Identifier: MIT
// The deformable solids of a recorded frame, from the bytes of a trajectory.
#pragma once

#include "scene/trajectory/cursor.hpp"
#include "scene/trajectory/trajectory.hpp"

#include <memory>
#include <string>

namespace rigor {

/// How much the mesh of a solid holds.
struct TopologyCounts {
    std::size_t nodes = 0, elements = 0, points = 0, triangles = 0, pieces = 0;
};

constexpr std::size_t topology_counts_size = 5 * sizeof(std::uint32_t); // [bytes]

/// @param where  names the solid in an error
/// @throws InputError, also where a count is too large to be believed
TopologyCounts read_topology_counts(ByteCursor& bytes, const std::string& where);

/// How many bytes a mesh takes, and the mesh. @throws InputError
std::size_t topology_size(const TopologyCounts& counts);
std::shared_ptr<const SolidTopology> read_topology(ByteCursor& bytes, const TopologyCounts& counts,
                                                   const std::string& where);

/// How many bytes the state of a solid takes, and the state: totals, nodes and elements.
/// @throws InputError
std::size_t solid_frame_size(const SolidTopology& topology);
void read_solid_frame(ByteCursor& bytes, SolidFrame& solid, const std::string& where);

} // namespace rigor
