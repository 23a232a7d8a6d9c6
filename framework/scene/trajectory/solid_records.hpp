// SPDX-License-Identifier: MIT
// The deformable solids of a recorded frame, read from the bytes of a trajectory.
#pragma once

#include "scene/trajectory/cursor.hpp"
#include "scene/trajectory/trajectory.hpp"

#include <memory>
#include <string>

namespace rigor {

/// The sizes of the mesh of a solid. Points and triangles are those of its drawn surface.
struct TopologyCounts {
    std::size_t nodes = 0, elements = 0, points = 0, triangles = 0, pieces = 0;
};

constexpr std::size_t topology_counts_size = 5 * sizeof(std::uint32_t); // [bytes]

/// Reads the sizes of a mesh. @param where  names the solid in error messages
/// @throws InputError if a count is zero or larger than its limit
TopologyCounts read_topology_counts(ByteCursor& bytes, const std::string& where);

/// The number of bytes that a mesh takes.
std::size_t topology_size(const TopologyCounts& counts);

/// Reads a mesh. @throws InputError if an index is out of range or a number is not finite
std::shared_ptr<const SolidTopology> read_topology(ByteCursor& bytes, const TopologyCounts& counts,
                                                   const std::string& where);

/// The number of bytes that the state of a solid takes: totals, nodes and elements.
std::size_t solid_frame_size(const SolidTopology& topology);

/// Reads the state of a solid whose `topology` is set. @throws InputError if a number is not finite
void read_solid_frame(ByteCursor& bytes, SolidFrame& solid, const std::string& where);

} // namespace rigor
