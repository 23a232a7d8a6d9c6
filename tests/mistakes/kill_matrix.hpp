// SPDX-License-Identifier: MIT
// The kill matrix: which law of a task catches which mistake, as JSON and as a page.
#pragma once

#include "formulas/table.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace rigor {

/// A mistake with the laws of its task, which are the names of test cases.
struct KillRow {
    const Formula* formula = nullptr;
    std::string mistake, explanation;
    std::vector<std::string> laws;   // those that ran, in order
    std::vector<std::string> caught; // those that failed, as they should
};

/// What one law of a formula catches.
struct LawKills {
    std::string law;
    int kills = 0;
    int alone = 0; // mistakes that no other law catches
};

/// The laws of the rows of one formula, in the order in which they first ran.
std::vector<LawKills> kills_by_law(const std::vector<KillRow>& rows);

/// Writes `kill_matrix.json` and `kill_matrix.html` into a folder, which is made if it is missing.
/// @param rows  those of one formula follow each other
void write_kill_matrix(const std::filesystem::path& folder, const std::vector<KillRow>& rows);

} // namespace rigor
