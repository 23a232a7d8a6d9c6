// SPDX-License-Identifier: MIT
// Writes the kill matrix. A row of the page is a law and a column is a mistake; below each formula
// stands what the mistakes are. A law that catches no mistake alone is marked: it is kept because
// it teaches, or because it catches mutants, or it is superfluous.
#include "mistakes/kill_matrix.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace rigor {

namespace {

bool contains(const std::vector<std::string>& names, const std::string& name)
{
    return std::find(names.begin(), names.end(), name) != names.end();
}

std::string escaped(const std::string& text)
{
    std::string result;
    for (const char c : text)
        result += c == '&' ? "&amp;" : c == '<' ? "&lt;" : std::string(1, c);
    return result;
}

// The rows of each formula.
std::vector<std::vector<KillRow>> by_formula(const std::vector<KillRow>& rows)
{
    std::vector<std::vector<KillRow>> result;
    for (const KillRow& row : rows) {
        if (result.empty() || result.back().front().formula != row.formula) result.emplace_back();
        result.back().push_back(row);
    }
    return result;
}

std::string remark(const LawKills& law)
{
    if (law.kills == 0) return "catches no mistake";
    if (law.alone == 0) return "others catch the same";
    return fmt::format("alone: {}", law.alone);
}

std::string table_of(const std::vector<KillRow>& rows)
{
    const Formula& formula = *rows.front().formula;
    std::string page =
        fmt::format("<h2>{} {}</h2>\n<table>\n<tr><th>law</th>", formula.tag, formula.name);
    for (std::size_t i = 0; i < rows.size(); ++i)
        page += fmt::format("<th title=\"{}\">{}</th>", rows[i].mistake, i + 1);
    page += "<th>alone</th></tr>\n";
    for (const LawKills& law : kills_by_law(rows)) {
        page += fmt::format("<tr{}><td>{}</td>", law.alone == 0 ? " class=\"none\"" : "",
                            escaped(law.law));
        for (const KillRow& row : rows)
            page += contains(row.caught, law.law) ? "<td class=\"kill\">●</td>" : "<td></td>";
        page += fmt::format("<td>{}</td></tr>\n", remark(law));
    }
    page += "</table>\n<ol>\n";
    for (const KillRow& row : rows)
        page += fmt::format("<li{}><code>{}</code>: {}</li>\n",
                            row.caught.empty() ? " class=\"missed\"" : "", row.mistake,
                            escaped(row.explanation));
    return page + "</ol>\n";
}

void write(const std::filesystem::path& file, const std::string& text)
{
    std::ofstream out(file);
    out << text;
    if (!out) throw std::runtime_error(file.string() + ": cannot be written");
}

constexpr std::string_view head = R"(<!doctype html><html lang="en"><head><meta charset="utf-8">
<title>Kill matrix</title><style>
body { font-family: sans-serif; margin: 2em; }
table { border-collapse: collapse; }
td, th { border: 1px solid #bbb; padding: 2px 6px; text-align: left; font-size: 85%; }
.kill { color: #06c; text-align: center; }
.none td { color: #777; }
.missed { color: #c00; font-weight: bold; }
</style></head><body>
<h1>Which law catches which mistake</h1>
<p>A column is a mistake, a row a law of its task. Grey laws catch no mistake that no other law
catches. Red mistakes are caught by none.</p>
)";

} // namespace

std::vector<LawKills> kills_by_law(const std::vector<KillRow>& rows)
{
    std::vector<LawKills> laws;
    for (const KillRow& row : rows)
        for (const std::string& name : row.laws) {
            auto law = std::find_if(laws.begin(), laws.end(),
                                    [&](const LawKills& each) { return each.law == name; });
            if (law == laws.end()) law = laws.insert(laws.end(), {name});
            if (!contains(row.caught, name)) continue;
            ++law->kills;
            law->alone += row.caught.size() == 1;
        }
    return laws;
}

void write_kill_matrix(const std::filesystem::path& folder, const std::vector<KillRow>& rows)
{
    nlohmann::json json = nlohmann::json::array();
    std::string page(head);
    for (const std::vector<KillRow>& of_formula : by_formula(rows)) {
        const Formula& formula = *of_formula.front().formula;
        nlohmann::json entry = {{"tag", formula.tag}, {"formula", formula.name}};
        for (const LawKills& law : kills_by_law(of_formula))
            entry["laws"].push_back({{"law", law.law}, {"kills", law.kills}, {"alone", law.alone}});
        for (const KillRow& row : of_formula)
            entry["mistakes"].push_back({{"mistake", row.mistake},
                                         {"explanation", row.explanation},
                                         {"caught_by", row.caught}});
        json.push_back(entry);
        page += table_of(of_formula);
    }
    std::filesystem::create_directories(folder);
    write(folder / "kill_matrix.json", json.dump(1) + "\n");
    write(folder / "kill_matrix.html", page + "</body></html>\n");
}

} // namespace rigor
