// SPDX-License-Identifier: MIT
#include "cli/states_table.hpp"

#include "report/csv.hpp"

#include <vector>

namespace rigor {

namespace {

void add(std::vector<std::string>& cells, const Vector3d& v)
{
    for (const double x : v)
        cells.push_back(csv_number(x));
}

} // namespace

std::string states_header()
{
    return csv_line({"time", "name", "X.x", "X.y", "X.z", "q.s", "q.x", "q.y", "q.z", "V.x", "V.y",
                     "V.z", "omega.x", "omega.y", "omega.z", "L.x", "L.y", "L.z"});
}

std::string states_lines(const Scene& scene, const Statistics& statistics, const Frame& frame)
{
    std::string text;
    const auto begin = [&](const std::string& name, const Vector3d& X) {
        std::vector<std::string> cells = {csv_number(frame.time), name};
        add(cells, X);
        return cells;
    };
    for (std::size_t i = 0; i < frame.bodies.size(); ++i) {
        const RigidState& state = frame.bodies[i];
        std::vector<std::string> cells = begin(scene.bodies[i].name, state.position);
        cells.push_back(csv_number(state.orientation.s));
        add(cells, state.orientation.v);
        add(cells, state.velocity);
        add(cells, statistics.angular_velocity(i, state));
        add(cells, state.angular_momentum);
        text += csv_line(cells);
    }
    for (std::size_t i = 0; i < frame.solids.size(); ++i) {
        const DeformableTotals& of = frame.solids[i].totals;
        const Vector3d X = of.center_of_mass;
        std::vector<std::string> cells = begin(scene.solids[i].name, X);
        cells.resize(cells.size() + 4); // no orientation
        add(cells, of.momentum / of.mass);
        cells.resize(cells.size() + 3); // no angular velocity
        add(cells, of.angular_momentum - X.cross(of.momentum));
        text += csv_line(cells);
    }
    return text;
}

} // namespace rigor
