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

TEST_CASE("table: the tags of a topic count up from 1", "[formulas]")
{
    std::string_view topic;
    int expected = 0;
    for (const Formula& formula : formulas) {
        expected = formula.topic == topic ? expected + 1 : 1;
        topic = formula.topic;
        const std::size_t dot = formula.tag.find('.');
        CAPTURE(formula.tag, formula.name);
        CHECK(std::string(formula.tag.substr(dot + 1)) == std::to_string(expected));
    }
}

TEST_CASE("table: an index finds its row", "[formulas]")
{
    CHECK(formulas[static_cast<unsigned>(FormulaIndex::combine)].name == "combine");
    CHECK(formulas[static_cast<unsigned>(FormulaIndex::combine)].arguments == "a, b");
}
