// SPDX-License-Identifier: MIT
#include "handouts/coverage.hpp"

#include "handouts/handouts.hpp"

#include <algorithm>
#include <stdexcept>

namespace rigor::handouts {

std::vector<CoverageRow> coverage()
{
    std::vector<CoverageRow> rows;
    for (const auto& cells : table_rows(content(assignments() / "coverage.md"))) {
        if (cells.front() == "slide") continue; // the header
        if (cells.size() != 5 || std::count(cells.begin(), cells.end(), "") > 0)
            throw std::runtime_error("coverage.md: expected five cells in the row of " +
                                     cells.front());
        const std::string &section = cells[2], &scene = cells[4]; // "A1 The mass", "`a1-…/bar`"
        const std::size_t blank = section.find(' '), slash = scene.find('/');
        if (blank == std::string::npos || slash == std::string::npos || scene.front() != '`' ||
            scene.back() != '`')
            throw std::runtime_error("coverage.md: expected a section and a scene in the row of " +
                                     cells.front());
        rows.push_back({cells[0], cells[1], section.substr(0, blank), section.substr(blank + 1),
                        cells[3], scene.substr(1, slash - 1),
                        scene.substr(slash + 1, scene.size() - slash - 2)});
    }
    return rows;
}

} // namespace rigor::handouts
