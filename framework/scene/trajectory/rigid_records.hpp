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

/// A body of the header. @throws InputError if it does not agree with the scene
RecordedBody read_recorded_body(ByteCursor& bytes, const BodyDescription& described);

/// The state of a body. @throws InputError if a number is not finite
RigidState read_state(ByteCursor& bytes, std::int64_t step, const BodyDescription& body);

/// @param bodies  the number of bodies of the scene
/// @throws InputError if a body does not exist or a number is not finite
ContactRecord read_contact(ByteCursor& bytes, std::int64_t step, std::int64_t bodies);

} // namespace rigor
