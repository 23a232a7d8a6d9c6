// SPDX-License-Identifier: MIT
// Finds the bounds of the parts, samples the density there, on a grid or at random points, and
// gives the samples to the formula of the method. A bounding box needs the bounds and the exact
// mass, and a rod its length and its mass per length.
#include "scene/run/approximate_mass.hpp"

#include "formulas/inertia.hpp"
#include "geometry/distance/signed_distance.hpp"
#include "geometry/shapes/shape_bounds.hpp"
#include "rigid/bodies/mass.hpp"

#include <cmath>
#include <numbers>
#include <random>

namespace rigor {

namespace {

// More cells or samples approximate the mass better, but take more time.
constexpr int default_cells = 20;      // number of grid cells along the longest edge
constexpr int default_samples = 10000; // number of random points

Bounds whole_bounds(const std::vector<Part>& parts)
{
    Bounds all;
    for (const Part& part : parts)
        all.include(bounds_of(part.shape, part_pose(Pose(), part)));
    return all;
}

double density_at(const std::vector<Part>& parts, const Vector3d& x)
{
    double density = 0;
    for (const Part& part : parts) {
        const Vector3d p = rotation_matrix(part.orientation).transpose() * (x - part.position);
        if (signed_distance(part.shape, p).distance <= 0) density += part.density;
    }
    return density;
}

// The density at the centers of cubic cells that cover the bounding box.
struct CellSamples {
    double cell_size = 0; // [m]
    std::vector<DensitySample> samples;
};

CellSamples cell_samples(const std::vector<Part>& parts, int cells)
{
    const Bounds bounds = whole_bounds(parts);
    const Vector3d extent = bounds.high - bounds.low;
    CellSamples grid;
    const double h = grid.cell_size = extent.maxCoeff() / cells;
    const Vector3d rounding = Vector3d::Constant(1e-9); // [cells]; rounding adds no layer of cells
    const Eigen::Vector3i count = (extent / h - rounding).array().ceil().cast<int>();
    for (int i = 0; i < count.x(); ++i)
        for (int j = 0; j < count.y(); ++j)
            for (int k = 0; k < count.z(); ++k) {
                const Vector3d x = bounds.low + h * Vector3d(i + 0.5, j + 0.5, k + 0.5);
                grid.samples.push_back({x, density_at(parts, x)});
            }
    return grid;
}

MassProperties by_particles(const CellSamples& grid)
{
    const double cell = grid.cell_size * grid.cell_size * grid.cell_size;
    std::vector<Particle> particles;
    for (const DensitySample& sample : grid.samples)
        if (sample.density > 0) particles.push_back({sample.density * cell, sample.position});
    return particle_mass_properties(particles);
}

MassProperties by_random_points(const std::vector<Part>& parts, int count)
{
    const Bounds bounds = whole_bounds(parts);
    const Vector3d extent = bounds.high - bounds.low;
    std::mt19937_64 random(1); // same numbers in each run: the C++ standard defines them
    const auto share = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; }; // 0 … 1
    std::vector<DensitySample> samples;
    for (int i = 0; i < count; ++i) {
        const double x = share(), y = share(), z = share();
        const Vector3d p = bounds.low + Vector3d(x, y, z).cwiseProduct(extent);
        samples.push_back({p, density_at(parts, p)});
    }
    return sampled_mass_properties(samples, extent.prod());
}

MassProperties by_bounding_box(const std::vector<Part>& parts)
{
    const Bounds bounds = whole_bounds(parts);
    double mass = 0;
    for (const Part& part : parts)
        mass += part.density * volume(part.shape);
    return bounding_box_mass_properties({bounds.low, bounds.high}, mass);
}

MassProperties by_thin_rod(const Part& part)
{
    const auto& cylinder = std::get<Cylinder>(part.shape);
    const double section = std::numbers::pi * cylinder.radius * cylinder.radius;
    return thin_rod(part.density * section, cylinder.height);
}

} // namespace

MassProperties approximate_mass(const BodyDescription& body)
{
    const int cells = body.mass_samples > 0 ? body.mass_samples : default_cells;
    switch (body.mass_method) {
    case MassMethod::particles:
        return by_particles(cell_samples(body.parts, cells));
    case MassMethod::grid: {
        const CellSamples grid = cell_samples(body.parts, cells);
        return grid_mass_properties(grid.samples, grid.cell_size);
    }
    case MassMethod::samples:
        return by_random_points(body.parts,
                                body.mass_samples > 0 ? body.mass_samples : default_samples);
    case MassMethod::bounding_box:
        return by_bounding_box(body.parts);
    case MassMethod::thin_rod:
        return by_thin_rod(body.parts.front());
    case MassMethod::exact:
        break;
    }
    return mass_properties(body.parts);
}

} // namespace rigor
