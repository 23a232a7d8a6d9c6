// SPDX-License-Identifier: MIT
// Reads the deformable solids of a frame. The sizes of a mesh are read and checked first, then its
// elements and surface, then totals, nodes and element values. A number that is not finite and an
// index out of range are refused.
#include "scene/trajectory/solid_records.hpp"

#include "deformable/elasticity/totals.hpp"
#include "deformable/surface/surface.hpp"
namespace rigor {

namespace {

// Larger counts are refused as damaged, before memory is reserved for them.
constexpr std::size_t most_nodes = 4'000'000, most_elements = 4'000'000, most_points = 8'000'000,
                      most_triangles = 8'000'000;
// Sizes of the records [bytes]
constexpr std::size_t element_bytes = 16;                 // an element: four indices
constexpr std::size_t point_bytes = 20;                   // a point of the surface
constexpr std::size_t triangle_bytes = 17;                // a triangle of the surface
constexpr std::size_t totals_bytes = 13 * sizeof(double); // the totals of a solid
constexpr std::size_t node_bytes = 6 * sizeof(double);    // place and velocity of a node
constexpr std::size_t measure_bytes = 2 * sizeof(float);  // stress and plastic strain, an element

int index(ByteCursor& bytes, const std::string& where, std::string_view what, std::size_t count)
{
    const std::int32_t number = bytes.take<std::int32_t>();
    if (number < 0 || static_cast<std::size_t>(number) >= count)
        fail(where, fmt::format("{} from 0 to {}", what, count - 1), fmt::format("{}", number));
    return number;
}

std::size_t some(const std::string& where, std::string_view what, std::size_t count,
                 std::size_t most)
{
    if (count == 0) fail(where, fmt::format("some {}", what), "none");
    return count_of(where, what, count, most);
}

void check_totals(const DeformableTotals& totals, const std::string& where)
{
    check_finite(totals.mass, where, "mass");
    check_finite(totals.volume, where, "volume");
    check_finite(totals.kinetic_energy, where, "kinetic energy");
    check_finite(totals.elastic_energy, where, "elastic energy");
    check_finite(totals.momentum, where, "momentum");
    check_finite(totals.angular_momentum, where, "angular momentum");
    check_finite(totals.center_of_mass, where, "center of mass");
}

} // namespace

TopologyCounts read_topology_counts(ByteCursor& bytes, const std::string& where)
{
    TopologyCounts counts;
    counts.nodes = some(where, "nodes", bytes.take<std::uint32_t>(), most_nodes);
    counts.elements = some(where, "elements", bytes.take<std::uint32_t>(), most_elements);
    counts.points = some(where, "points", bytes.take<std::uint32_t>(), most_points);
    counts.triangles = some(where, "triangles", bytes.take<std::uint32_t>(), most_triangles);
    counts.pieces = some(where, "pieces", bytes.take<std::uint32_t>(), counts.elements);
    return counts;
}

std::size_t topology_size(const TopologyCounts& counts)
{
    return counts.elements * element_bytes + counts.points * point_bytes +
           counts.triangles * triangle_bytes;
}

std::shared_ptr<const SolidTopology> read_topology(ByteCursor& bytes, const TopologyCounts& counts,
                                                   const std::string& where)
{
    const auto topology = std::make_shared<SolidTopology>();
    topology->nodes = counts.nodes;
    topology->pieces = counts.pieces;
    topology->elements.resize(counts.elements);
    for (std::array<int, 4>& element : topology->elements)
        for (int& node : element)
            node = index(bytes, where, "a node", topology->nodes);
    EmbeddedSurface& surface = topology->surface;
    surface.points.resize(counts.points);
    for (EmbeddedPoint& point : surface.points) {
        point.element = index(bytes, where, "an element", counts.elements);
        for (double& weight : point.weights) {
            weight = bytes.take<float>();
            check_finite(weight, where, "weight");
        }
    }
    surface.triangles.resize(counts.triangles);
    for (EmbeddedTriangle& triangle : surface.triangles) {
        for (int& point : triangle.points)
            point = index(bytes, where, "a point", counts.points);
        triangle.element = index(bytes, where, "an element", counts.elements);
        const std::uint8_t is_crack = bytes.take<std::uint8_t>();
        if (is_crack > 1) fail(where, "mark 0 or 1 of a crack", fmt::format("mark {}", is_crack));
        triangle.is_crack = is_crack == 1;
    }
    return topology;
}

std::size_t solid_frame_size(const SolidTopology& topology)
{
    return totals_bytes + topology.nodes * node_bytes + topology.elements.size() * measure_bytes;
}

void read_solid_frame(ByteCursor& bytes, SolidFrame& solid, const std::string& where)
{
    DeformableTotals& totals = solid.totals;
    for (double* number :
         {&totals.mass, &totals.volume, &totals.kinetic_energy, &totals.elastic_energy})
        *number = bytes.take<double>();
    totals.momentum = bytes.take<Vector3d>();
    totals.angular_momentum = bytes.take<Vector3d>();
    totals.center_of_mass = bytes.take<Vector3d>();
    check_totals(totals, where);
    for (std::size_t i = 0; i < solid.topology->nodes; ++i) {
        solid.positions.push_back(bytes.take<Vector3d>());
        solid.velocities.push_back(bytes.take<Vector3d>());
        check_finite(solid.positions.back(), where, "position");
        check_finite(solid.velocities.back(), where, "velocity");
    }
    for (std::size_t i = 0; i < solid.topology->elements.size(); ++i) {
        solid.stresses.push_back(bytes.take<float>());
        solid.plastic_strains.push_back(bytes.take<float>());
        check_finite(static_cast<double>(solid.stresses.back()), where, "stress");
        check_finite(static_cast<double>(solid.plastic_strains.back()), where, "plastic strain");
    }
}

} // namespace rigor
