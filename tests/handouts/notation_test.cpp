// SPDX-License-Identifier: MIT
// notation.md and the handouts agree: in each handout, each letter has one row.
#include "handouts/handouts.hpp"
#include "support/catch.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <sstream>

namespace notation_test {

using namespace rigor::handouts;

namespace {

struct Row {
    std::string symbols; // the cell, for messages
    std::set<std::string> keys, handouts;
    std::string unit;
};

std::vector<Row> notation()
{
    std::vector<Row> rows;
    for (const auto& cells : table_rows(content(assignments() / "notation.md"))) {
        if (cells.size() < 4 || cells[0] == "symbol") continue;
        Row row{cells[0], {}, {}, cells[3]};
        for (const std::string& formula : formulas_of(cells[0]))
            for (const std::string& symbol : symbols_of(formula))
                row.keys.insert(symbol);
        std::istringstream labels(cells[1]);
        for (std::string label; std::getline(labels >> std::ws, label, ',');)
            row.handouts.insert(label);
        rows.push_back(row);
    }
    return rows;
}

std::set<std::string> used_in(const std::string& text)
{
    std::set<std::string> symbols;
    for (const std::string& formula : formulas_of(text))
        for (const std::string& symbol : symbols_of(formula))
            symbols.insert(symbol);
    return symbols;
}

// The rows that say what a symbol means in a handout. A row for the symbol with this very index
// counts alone.
std::vector<std::size_t> meanings(const std::vector<Row>& rows, const std::string& symbol,
                                  const std::string& label)
{
    for (const std::string& key : {symbol, without_index(symbol)}) {
        std::vector<std::size_t> found;
        for (std::size_t i = 0; i < rows.size(); ++i)
            if (rows[i].keys.count(key) && rows[i].handouts.count(label)) found.push_back(i);
        if (!found.empty()) return found;
    }
    return {};
}

} // namespace

TEST_CASE("notation: symbols of a formula", "[notation]")
{
    const auto symbols = [](const std::string& formula) { return symbols_of(formula); };
    using Words = std::vector<std::string>;
    CHECK(symbols(R"(x = R\,p + X)") == Words{"x", "R", "p", "X"});
    CHECK(symbols(R"(\tfrac12 M\, V \cdot V)") == Words{"M", "V", "V"});
    CHECK(symbols(R"((x - X)^{\ast T} I_{body}^{-1} \dot q)") == Words{"x", "X", "I_body", "q"});
    CHECK(symbols(R"(\bar\sigma_e \Delta t^2 \mathrm{Tr}(\sigma))") ==
          Words{"\\bar \\sigma_e", "\\Delta t", "\\sigma"});
    CHECK(symbols(R"(\sum_{i=1,2} m_i \exp(2^{n}))") == Words{"m_i", "n"});
}

TEST_CASE("notation: a letter has one meaning in a handout", "[notation]")
{
    const std::vector<Row> rows = notation();
    REQUIRE(rows.size() > 50);
    for (const Handout& handout : all_handouts())
        for (const std::string& symbol : used_in(handout.text)) {
            const std::vector<std::size_t> found = meanings(rows, symbol, handout.label);
            INFO(handout.label << " uses " << symbol << ", which has " << found.size()
                               << " rows in notation.md");
            CHECK(found.size() == 1);
        }
}

TEST_CASE("notation: the letter of an index is a number or a direction", "[notation]")
{
    const std::vector<Row> rows = notation();
    const auto has_row = [&](const std::string& symbol, const std::string& label) {
        return std::any_of(rows.begin(), rows.end(), [&](const Row& row) {
            return row.keys.count(symbol) && row.handouts.count(label);
        });
    };
    for (const Handout& handout : all_handouts())
        for (const std::string& symbol : used_in(handout.text)) {
            const std::size_t bar = symbol.find('_');
            if (bar == std::string::npos || has_row(symbol, handout.label)) continue;
            const std::string index = symbol.substr(bar + 1);
            static const std::set<std::string> words = {"body", "cm", "ext", "int"};
            if (words.count(index)) continue;
            for (const char letter : index) {
                if (std::string("xyz").find(letter) != std::string::npos) continue; // an axis
                for (const std::size_t i : meanings(rows, {letter}, handout.label)) {
                    INFO(handout.label << " has the index " << letter << " in " << symbol
                                       << ", which is also " << rows[i].symbols);
                    CHECK(rows[i].unit == "1");
                }
            }
        }
}

TEST_CASE("notation: each row is used in the handouts that it names", "[notation]")
{
    const std::vector<Row> rows = notation();
    std::map<std::string, std::set<std::size_t>> used;
    for (const Handout& handout : all_handouts())
        for (const std::string& symbol : used_in(handout.text))
            for (const std::size_t i : meanings(rows, symbol, handout.label))
                used[handout.label].insert(i);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        CAPTURE(rows[i].symbols);
        CHECK(!rows[i].handouts.empty());
        for (const std::string& label : rows[i].handouts) {
            CAPTURE(label);
            CHECK(used[label].count(i) == 1);
        }
    }
}

TEST_CASE("handouts: formulas are written so that the common viewers show them", "[notation]")
{
    for (const Handout& handout : all_handouts()) {
        CAPTURE(handout.name);
        CHECK(handout.text.find("$$") == std::string::npos); // a block is ```math
        for (const std::string& formula : formulas_of(handout.text)) {
            CAPTURE(formula);
            CHECK(formula.find('*') == std::string::npos); // \ast
            std::ptrdiff_t depth = 0;
            for (const char c : formula)
                depth += c == '{' ? 1 : c == '}' ? -1 : 0;
            CHECK(depth == 0);
        }
    }
}

} // namespace notation_test
