// SPDX-License-Identifier: MIT
// The deformable solids of a frame: the stages of a trajectory's reader that take them.
#include "errors/quotes.hpp"
#include "scene/json.hpp"
#include "scene/trajectory_cursor.hpp"

namespace rigor {

namespace {

constexpr std::size_t most_nodes = 4'000'000, most_elements = 4'000'000, most_points = 8'000'000,
                      most_triangles = 8'000'000;
constexpr std::size_t element_bytes = 16, point_bytes = 20, triangle_bytes = 17,
                      totals_bytes = 13 * sizeof(double), node_bytes = 6 * sizeof(double),
                      measure_bytes = 2 * sizeof(float);

template <class Cursor>
int index(Cursor& bytes, const std::string& where, std::string_view what, std::size_t count)
{
    const std::int32_t number = bytes.template take<std::int32_t>();
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

std::string TrajectoryReader::solid_place() const
{
    return fmt::format("step {}, solid {}", frame_.step,
                       in_quotes(scene_.solids[frame_.solids.size()].name));
}

void TrajectoryReader::next_solid()
{
    if (frame_.solids.size() == scene_.solids.size())
        finish_frame();
    else
        next(&TrajectoryReader::read_solid, 1);
}

void TrajectoryReader::read_solid(Cursor& bytes)
{
    const std::uint8_t is_new = bytes.take<std::uint8_t>();
    if (is_new > 1)
        fail(solid_place(), "mark 0 or 1 of a new mesh", fmt::format("mark {}", is_new));
    if (is_new) {
        next(&TrajectoryReader::read_topology_counts, 5 * sizeof(std::uint32_t));
        return;
    }
    if (!topologies_[frame_.solids.size()])
        fail(solid_place(), "a mesh in the first frame", "none");
    topology_.reset();
    expect_solid_frame();
}

void TrajectoryReader::read_topology_counts(Cursor& bytes)
{
    const std::string where = solid_place();
    topology_ = std::make_shared<SolidTopology>();
    topology_->nodes = some(where, "nodes", bytes.take<std::uint32_t>(), most_nodes);
    element_count_ = some(where, "elements", bytes.take<std::uint32_t>(), most_elements);
    point_count_ = some(where, "points", bytes.take<std::uint32_t>(), most_points);
    triangle_count_ = some(where, "triangles", bytes.take<std::uint32_t>(), most_triangles);
    topology_->pieces = some(where, "pieces", bytes.take<std::uint32_t>(), element_count_);
    next(&TrajectoryReader::read_topology, element_count_ * element_bytes +
                                               point_count_ * point_bytes +
                                               triangle_count_ * triangle_bytes);
}

void TrajectoryReader::read_topology(Cursor& bytes)
{
    const std::string where = solid_place();
    topology_->elements.resize(element_count_);
    for (std::array<int, 4>& element : topology_->elements)
        for (int& node : element)
            node = index(bytes, where, "a node", topology_->nodes);
    EmbeddedSurface& surface = topology_->surface;
    surface.points.resize(point_count_);
    for (EmbeddedPoint& point : surface.points) {
        point.element = index(bytes, where, "an element", element_count_);
        for (double& weight : point.weights) {
            weight = bytes.take<float>();
            check_finite(weight, where, "weight");
        }
    }
    surface.triangles.resize(triangle_count_);
    for (EmbeddedTriangle& triangle : surface.triangles) {
        for (int& point : triangle.points)
            point = index(bytes, where, "a point", point_count_);
        triangle.element = index(bytes, where, "an element", element_count_);
        const std::uint8_t is_crack = bytes.take<std::uint8_t>();
        if (is_crack > 1) fail(where, "mark 0 or 1 of a crack", fmt::format("mark {}", is_crack));
        triangle.is_crack = is_crack == 1;
    }
    topologies_[frame_.solids.size()] = topology_;
    expect_solid_frame();
}

void TrajectoryReader::expect_solid_frame()
{
    const SolidTopology& topology = *topologies_[frame_.solids.size()];
    next(&TrajectoryReader::read_solid_frame,
         totals_bytes + topology.nodes * node_bytes + topology.elements.size() * measure_bytes);
}

void TrajectoryReader::read_solid_frame(Cursor& bytes)
{
    const std::string where = solid_place();
    SolidFrame solid;
    solid.topology = topologies_[frame_.solids.size()];
    solid.is_new_topology = topology_ != nullptr;
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
    frame_.solids.push_back(std::move(solid));
    next_solid();
}

} // namespace rigor
