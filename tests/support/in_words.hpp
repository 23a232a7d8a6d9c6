// SPDX-License-Identifier: MIT
// Checks whose failure says in words what was expected. A bare REQUIRE would show a student the
// code of the test.
#pragma once

#include <cstddef>
#include <string_view>

namespace rigor::testing {

/// Checks that `law` holds.
/// @param law  what is expected, in words: "an impulse that pulls is outside of the cone"
void check_that(bool holds, std::string_view law);

/// Checks a number of things.
/// @param things  what is counted: "vertices"; more words follow after a comma or a colon
void check_count(std::ptrdiff_t found, std::ptrdiff_t expected, std::string_view things);

} // namespace rigor::testing
