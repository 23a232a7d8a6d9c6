// SPDX-License-Identifier: MIT
// The differences between two runs of a scene.
#pragma once

#include "scene/trajectory/trajectory.hpp"

#include <optional>
#include <string>
#include <vector>

namespace rigor {

/// A quantity of a body or a solid that differs between two runs.
struct Difference {
    std::string body;
    std::string quantity; // with its unit, such as "X [m]"
    std::string expected, actual;
    // |expected - actual|. For orientations it is the angle between them [rad], and for meshes that
    // cracked differently the difference between their numbers of elements.
    double size = 0;
    double allowed = 0; // the largest size that counts as equal
};

/// Tolerance, relative to the scale of a quantity; difference.cpp says which scale it has. Rounding
/// errors stay below it even after many steps, and the error of a wrong formula does not. Stresses
/// and strains have a larger tolerance, since they are recorded as floats.
inline constexpr double same_within = 1e-9;

/// Compares a run with an expected one, frame by frame.
class Comparison {
public:
    /// @param expected  the expected run, with every step recorded
    explicit Comparison(Trajectory expected);

    /// The differences in mass, center of mass and inertia of the bodies.
    std::vector<Difference> bodies(const std::vector<RecordedBody>& actual) const;

    /// The differences in a frame. A body has at most one entry for each quantity, in the order
    /// position X, orientation q, velocity V, angular momentum L. If the mesh of a deformable solid
    /// differs, this is the solid's only entry. Otherwise its entries are the nodes with the
    /// largest differences in x and in v, and the elements with the largest ones in stress and in
    /// plastic strain.
    std::vector<Difference> frame(const Frame& actual) const;

    const Trajectory& expected() const { return expected_; }

private:
    void compare_solid(std::vector<Difference>& differences, const std::string& name,
                       const SolidFrame& expected, const SolidFrame& actual) const;

    Trajectory expected_;
    // The largest values in the expected run, to which the tolerances are relative.
    double length_ = 0, speed_ = 0, spin_ = 0; // |X| [m], |V| [m/s], |L| [kg m²/s]
    double stress_ = 0;                        // [Pa]
    double plastic_strain_ = 0;                // no unit
};

} // namespace rigor
