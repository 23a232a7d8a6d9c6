// SPDX-License-Identifier: MIT
// Each formula has hints beside its handout.
#include "formulas/table.hpp"
#include "handouts/handouts.hpp"
#include "support/catch.hpp"

#include <map>
#include <sstream>

using namespace rigor::handouts;

namespace {

// For each tag, the numbers of its hints in one string, such as "12".
std::map<std::string, std::string> hints_in(const std::string& text)
{
    std::map<std::string, std::string> hints;
    std::istringstream lines(text);
    std::string tag;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("## ")) tag = line.substr(3);
        if (line.size() > 3 && line.compare(1, 2, ". ") == 0) hints[tag] += line.front();
    }
    return hints;
}

} // namespace

TEST_CASE("hints: each formula has two besides that of its task", "[hints]")
{
    std::map<std::string, std::string> hints;
    for (const Handout& handout : all_handouts())
        hints.merge(hints_in(content(assignments() / handout.name / "hints.md")));
    for (const rigor::Formula& formula : rigor::formulas) {
        CAPTURE(formula.tag, formula.name);
        CHECK(hints[std::string(formula.tag)] == "12");
    }
    CHECK(hints.size() == rigor::formula_count);
}
