// SPDX-License-Identifier: MIT
// The start of the pile, and the measurement of its penetration at the end. The pairs are found by
// sorting along x; their depth comes from the separating-axis test.
#include "run.hpp"

#include "support/random.hpp"
#include "support/shapes/depth.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigor {

namespace {

constexpr double spacing = 1.5, shift = 0.1, wall_thickness = 1; // [m]
constexpr double layer_shift = 0.5;                              // [m]
constexpr double largest_turn = 15 * std::numbers::pi / 180;     // [rad]
constexpr double touching = 0.01; // pairs closer than this count as touching [m]

std::vector<Wall> walls_around(double half_width, double height)
{
    const double w = half_width, t = wall_thickness, outer = 2 * (w + t);
    std::vector<Wall> walls = {{{0, -t / 2, 0}, {outer, t, outer}}};
    for (double side : {-1.0, 1.0}) {
        walls.push_back({{side * (w + t / 2), height / 2, 0}, {t, height, outer}});
        walls.push_back({{0, height / 2, side * (w + t / 2)}, {2 * w, height, t}});
    }
    return walls;
}

void take(PileMeasure& measure, double gap)
{
    if (gap >= touching) return;
    const double depth = std::max(0.0, -gap);
    measure.mean += depth;
    measure.largest = std::max(measure.largest, depth);
    ++measure.pairs;
}

} // namespace

PileStart pile_start(int side, unsigned seed)
{
    testing::Random random(seed);
    PileStart start;
    start.half_width = side * spacing / 2 + layer_shift;
    for (int y = 0; y < side; ++y) {
        const Vector3d layer =
            layer_shift * Vector3d(random.uniform(-1, 1), 0, random.uniform(-1, 1));
        for (int z = 0; z < side; ++z)
            for (int x = 0; x < side; ++x) {
                const Vector3d cell(x - (side - 1) / 2.0, y + 0.5, z - (side - 1) / 2.0);
                const double angle = random.uniform(0, largest_turn);
                const Vector3d axis = random.unit_vector();
                const Quaternion q{std::cos(angle / 2), std::sin(angle / 2) * axis};
                start.orientations.push_back(q);
                start.cubes.push_back(
                    {rotation_matrix(q), spacing * cell + layer + shift * random.vector()});
            }
    }
    start.walls = walls_around(start.half_width, side * spacing);
    return start;
}

PileMeasure measure_pile(const PileStart& start, const std::vector<Pose>& cubes)
{
    PileMeasure measure;
    const Box unit_cube{Vector3d::Ones()};
    std::vector<Pose> placed;
    for (const Pose& pose : cubes) {
        const bool inside = pose.R.allFinite() && pose.X.allFinite() && pose.X.y() > 0 &&
                            std::abs(pose.X.x()) < start.half_width &&
                            std::abs(pose.X.z()) < start.half_width;
        if (!inside)
            ++measure.escaped;
        else
            placed.push_back(pose);
    }
    for (const Pose& cube : placed)
        measure.height += cube.X.y() / static_cast<double>(placed.size());
    std::sort(placed.begin(), placed.end(),
              [](const Pose& a, const Pose& b) { return a.X.x() < b.X.x(); });
    const double reach = std::sqrt(3.0) + touching; // centers farther apart never touch
    for (std::size_t i = 0; i < placed.size(); ++i) {
        for (std::size_t j = i + 1; j < placed.size(); ++j) {
            if (placed[j].X.x() - placed[i].X.x() > reach) break;
            if ((placed[j].X - placed[i].X).norm() <= reach)
                take(measure, testing::box_separation(unit_cube, placed[i], unit_cube, placed[j]));
        }
        for (const Wall& wall : start.walls)
            take(measure, testing::box_separation(unit_cube, placed[i], Box{wall.size},
                                                  Pose{Matrix3d::Identity(), wall.center}));
    }
    if (measure.pairs > 0) measure.mean /= measure.pairs;
    return measure;
}

} // namespace rigor
