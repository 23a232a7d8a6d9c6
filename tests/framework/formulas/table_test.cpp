// SPDX-License-Identifier: MIT
#include "formulas/table.hpp"
#include "support/catch.hpp"

#include <set>
#include <string>

using namespace rigor;

TEST_CASE("table: every tag and every function is there once", "[formulas]")
{
    std::set<std::string_view> tags, names;
    for (const Formula& formula : formulas) {
        CAPTURE(formula.tag, formula.name);
        CHECK(tags.insert(formula.tag).second);
        CHECK(names.insert(formula.name).second);
        CHECK_FALSE(formula.arguments.empty());
    }
    CHECK(tags.size() == formula_count);
}

TEST_CASE("table: the tags of a topic begin at 1 and ascend", "[formulas]")
{
    std::string_view topic;
    int before = 0; // there are gaps: tasks about scenes have tags but no formula
    for (const Formula& formula : formulas) {
        const int number = std::stoi(std::string(formula.tag.substr(formula.tag.find('.') + 1)));
        CAPTURE(formula.tag, formula.name);
        if (formula.topic == topic)
            CHECK(number > before);
        else
            CHECK(number == 1);
        topic = formula.topic;
        before = number;
    }
}

TEST_CASE("table: an index finds its row", "[formulas]")
{
    CHECK(formulas[static_cast<unsigned>(FormulaIndex::combine)].name == "combine");
    CHECK(formulas[static_cast<unsigned>(FormulaIndex::combine)].arguments == "a, b");
}
