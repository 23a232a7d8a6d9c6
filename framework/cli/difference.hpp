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
    std::string quantity; // "X [m]"
    std::string expected, actual;
    double size = 0;    // |difference|; for orientations the angle between them [rad]
    double allowed = 0; // the threshold it exceeds
};

/// Relative tolerance: rounding errors that have grown over many steps stay below this times the
/// largest value of a quantity; the error of a wrong formula does not.
inline constexpr double same_within = 1e-9;

/// Compares a run with an expected one, frame by frame.
class Comparison {
public:
    /// @param expected  the expected run, with every step recorded
    explicit Comparison(Trajectory expected);

    /// The differences in mass, center of mass and inertia of the bodies.
    std::vector<Difference> bodies(const std::vector<RecordedBody>& actual) const;

    /// The differences in a frame: at most one entry for each body and quantity, in the order X, q,
    /// V, L. For a deformable solid, the entries are its mesh if it differs, or else the node whose
    /// x or v is farthest off and the element whose stress or plastic strain is farthest off.
    std::vector<Difference> frame(const Frame& actual) const;

    const Trajectory& expected() const { return expected_; }

private:
    void compare_solid(std::vector<Difference>& differences, const std::string& name,
                       const SolidFrame& expected, const SolidFrame& actual) const;

    Trajectory expected_;
    // The scales of the allowed differences: the largest values in the expected run.
    double length_ = 0, speed_ = 0, spin_ = 0; // |X| [m], |V| [m/s], |L| [kg m²/s]
    double stress_ = 0;                        // [Pa]
    double plastic_strain_ = 0;                // no unit
};

} // namespace rigor
