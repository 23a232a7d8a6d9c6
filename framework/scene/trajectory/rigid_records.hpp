// SPDX-License-Identifier: MIT
// The rigid bodies and the contacts of a trajectory, read from its bytes.
#pragma once

#include "scene/trajectory/cursor.hpp"
#include "scene/trajectory/trajectory.hpp"

#include <cstdint>
#include <string>

namespace rigor {

// Sizes of the records of a body in the header, of its state in a frame, and of a contact [bytes].
constexpr std::size_t body_bytes = 1 + 13 * sizeof(double), state_bytes = 13 * sizeof(double),
                      contact_bytes = 2 * sizeof(std::int32_t) + 10 * sizeof(double);

/// Reads a body in the header of a trajectory. @throws InputError if the body is static in the
/// trajectory but not in the scene, or the reverse, or if a number is not finite
RecordedBody read_recorded_body(ByteCursor& bytes, const BodyDescription& described);

/// Reads the state of a body. @throws InputError if a number is not finite
RigidState read_state(ByteCursor& bytes, std::int64_t step, const BodyDescription& body);

/// Reads a contact. @param bodies  the number of bodies of the scene
/// @throws InputError if the index of a body is out of range or a number is not finite
ContactRecord read_contact(ByteCursor& bytes, std::int64_t step, std::int64_t bodies);

} // namespace rigor
