// SPDX-License-Identifier: MIT
// Throws an exception that has no text.
#include "formulas/kinematics.hpp"

#include <exception>

namespace {

struct Mute : std::exception {
    const char* what() const noexcept override { return nullptr; }
};

} // namespace

namespace rigor {

Matrix3d cross_matrix(const Vector3d&)
{
    throw Mute();
}

} // namespace rigor
