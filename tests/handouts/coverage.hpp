// SPDX-License-Identifier: MIT
// The table in assignments/coverage.md: where each statement of the lectures is.
#pragma once

#include <string>
#include <vector>

namespace rigor::handouts {

/// What a slide says, the handout and its section that explain it, the task that asks for it, and
/// the scene in which it can be seen.
struct CoverageRow {
    std::string slide, statement;
    std::string label, section;    ///< "A4" and "How deep"
    std::string tag;               ///< "A4.1"
    std::string assignment, scene; ///< "a5-contact" and "toy_box"
};

/// All rows. Throws where a cell is missing or empty, or a scene is not written `folder/name`.
std::vector<CoverageRow> coverage();

} // namespace rigor::handouts
