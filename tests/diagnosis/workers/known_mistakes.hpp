// SPDX-License-Identifier: MIT
// The known mistakes of a formula, tests/mistakes/<topic>/<formula>/<mistake>.cpp, as far as their
// workers were built.
#pragma once

#include "formulas/table.hpp"

#include <filesystem>
#include <vector>

namespace rigor::diagnosis {

struct KnownMistake {
    std::string name;        // "transpose_forgotten"
    std::string explanation; // the second line of its file
    std::filesystem::path worker;
};

/// Where known mistakes are.
struct MistakeFolders {
    std::filesystem::path sources; // tests/mistakes
    std::filesystem::path workers; // the folder `mistakes` of the build
};

/// The folders of the tree that this program was built from.
MistakeFolders own_mistake_folders();

/// The known mistakes of a formula, by name. Empty if there are none or if no worker was built.
std::vector<KnownMistake> known_mistakes(const MistakeFolders& folders, FormulaIndex formula);

} // namespace rigor::diagnosis
