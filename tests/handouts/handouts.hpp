// SPDX-License-Identifier: MIT
// The texts below assignments/, for tests of what they say.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace rigor::handouts {

/// The handout of an assignment.
struct Handout {
    std::string label; ///< "A2"
    std::string name;  ///< "a2-inertia"
    std::string text;
};

std::filesystem::path assignments();
std::string content(const std::filesystem::path& file);

/// Whether the assignment has scenes to watch. The first one, which is about the working loop, and
/// the last one, which is about tests, have none.
bool has_scenes(const Handout& handout);

/// All handouts, in the order of their labels. Throws if there are none.
std::vector<Handout> all_handouts();

/// The rows of the tables of a text, each with its cells. The line below a head is left out.
std::vector<std::vector<std::string>> table_rows(const std::string& text);

/// The formulas of a text: what stands between dollars or in a block `math`. Code is left out.
std::vector<std::string> formulas_of(const std::string& text);

/// The symbols of a formula, such as `\omega`, `x`, `v_n`, `I_body` or `\Delta t`. Left out are
/// names like `\mathrm{Tr}`, exponents that are numbers, transposes or stars, and single indices.
std::vector<std::string> symbols_of(const std::string& formula);

/// A symbol without its index.
std::string without_index(const std::string& symbol);

} // namespace rigor::handouts
