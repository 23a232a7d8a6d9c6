// SPDX-License-Identifier: MIT
// coverage.md names sections, tasks and scenes that exist, and all tasks that ask for a formula.
#include "formulas/table.hpp"
#include "handouts/coverage.hpp"
#include "handouts/handouts.hpp"
#include "support/catch.hpp"

#include <set>
#include <sstream>

using namespace rigor::handouts;

namespace {

const Handout& handout_of(const std::vector<Handout>& handouts, const std::string& label)
{
    for (const Handout& handout : handouts)
        if (handout.label == label) return handout;
    throw std::runtime_error("no handout " + label);
}

// Whether a handout has this section: a heading, or a paragraph that begins with it.
bool has_section(const Handout& handout, const std::string& section)
{
    for (const std::string& start :
         {"\n### " + section + "\n", "\n**" + section + ".**", "\n**" + section + "**"})
        if (handout.text.find(start) != std::string::npos) return true;
    return false;
}

} // namespace

TEST_CASE("coverage: each line of a table begins and ends with a bar", "[coverage]")
{
    std::istringstream lines(content(assignments() / "coverage.md"));
    for (std::string line; std::getline(lines, line);) {
        CAPTURE(line);
        if (line.find('|') != std::string::npos)
            CHECK((line.size() > 1 && line.front() == '|' && line.back() == '|'));
    }
}

TEST_CASE("coverage: each section, task and scene exists", "[coverage]")
{
    const std::vector<Handout> handouts = all_handouts();
    const std::vector<CoverageRow> rows = coverage();
    REQUIRE(rows.size() > 100);
    for (const CoverageRow& row : rows) {
        CAPTURE(row.slide, row.statement, row.label, row.section, row.tag, row.assignment,
                row.scene);
        CHECK(has_section(handout_of(handouts, row.label), row.section));
        const std::string of_task = row.tag.substr(0, row.tag.find('.'));
        const std::string heading = "\n### " + row.tag + " ";
        CHECK(handout_of(handouts, of_task).text.find(heading) != std::string::npos);
        const auto scene = assignments() / row.assignment / "scenes" / (row.scene + ".json");
        CHECK(std::filesystem::exists(scene));
    }
}

TEST_CASE("coverage: each formula of the lectures has a row", "[coverage]")
{
    std::set<std::string> tags;
    for (const CoverageRow& row : coverage())
        tags.insert(row.tag);
    for (const rigor::Formula& formula : rigor::formulas) {
        // The warm-up and the tests are not in the lectures.
        if (formula.topic == "pipeline" || formula.topic == "validation") continue;
        CAPTURE(formula.tag, formula.name);
        CHECK(tags.count(std::string(formula.tag)) == 1);
    }
}
