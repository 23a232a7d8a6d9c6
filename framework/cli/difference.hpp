// SPDX-License-Identifier: MIT
// Where two runs of a scene part.
#pragma once

#include "scene/trajectory/trajectory.hpp"

#include <optional>
#include <string>
#include <vector>

namespace rigor {

/// A quantity of a body that two runs do not agree on.
struct Difference {
    std::string body;
    std::string quantity; // "X [m]"
    std::string expected, actual;
    double size = 0;    // |difference|; of an orientation the angle between [rad]
    double allowed = 0; // the threshold it exceeds
};

/// Rounding, grown over many steps, stays below this times the size that a quantity reached; a
/// wrong formula does not.
inline constexpr double same_within = 1e-9;

/// Compares a run with an expected one, frame by frame.
class Comparison {
public:
    /// @param expected  every step of it
    explicit Comparison(Trajectory expected);

    /// What mass and inertia the bodies were given.
    std::vector<Difference> bodies(const std::vector<RecordedBody>& actual) const;

    /// What differs in a frame: at most one entry a body and quantity, in the order X, q, V, L; of
    /// a deformable solid its mesh, or the node whose x or v is farthest off, and the element whose
    /// stress or plastic strain is.
    std::vector<Difference> frame(const Frame& actual) const;

    const Trajectory& expected() const { return expected_; }

private:
    void compare_solid(std::vector<Difference>& differences, const std::string& name,
                       const SolidFrame& expected, const SolidFrame& actual) const;

    Trajectory expected_;
    double length_ = 0, speed_ = 0, spin_ = 0; // largest of |X|, |V|, |L| in the run
    double stress_ = 0, plastic_strain_ = 0;   // largest in the run
};

} // namespace rigor
