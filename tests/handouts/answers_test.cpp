// SPDX-License-Identifier: MIT
// No hint has the answer: an expression of the reference, or the right side of a formula beside it.
#include "formulas/table.hpp"
#include "handouts/handouts.hpp"
#include "support/catch.hpp"

#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

using namespace rigor::handouts;

namespace {

// Blanks and the signs that differ between code and prose do not count.
std::string pressed(std::string text)
{
    text = std::regex_replace(text, std::regex("−"), "-");
    text = std::regex_replace(text, std::regex("\\.cross"), "×");
    return std::regex_replace(text, std::regex(R"(\s+|`|\$)"), "");
}

// Keeps what is long enough to be an answer and computes something. A name or a number is none.
void keep(std::vector<std::string>& answers, const std::string& expression)
{
    constexpr std::size_t shortest = 9;
    static const std::regex operation(R"([-+*/×·√(])");
    const std::string answer = pressed(expression);
    if (answer.size() >= shortest && std::regex_search(answer, operation))
        answers.push_back(answer);
}

// What stands behind the first of these words, or nothing.
std::string behind(const std::string& text, const std::vector<std::string>& words)
{
    for (const std::string& word : words)
        if (const std::size_t at = text.find(word); at != std::string::npos)
            return text.substr(at + word.size());
    return {};
}

// What a source computes: what its statements return or assign, and the right sides of the formulas
// in its comments.
std::vector<std::string> answers_in(const std::string& source)
{
    std::vector<std::string> answers;
    std::string statement;
    std::istringstream lines(source);
    for (std::string line; std::getline(lines, line);) {
        const std::size_t slashes = line.find("//");
        if (slashes != std::string::npos) keep(answers, behind(line.substr(slashes), {" = "}));
        for (const char c : line.substr(0, slashes)) {
            if (c == ';') keep(answers, behind(statement, {"return ", " = ", " += ", " -= "}));
            if (c == ';' || c == '{' || c == '}')
                statement.clear();
            else
                statement += c;
        }
    }
    return answers;
}

// The hints of an assignment, each in one line: those of its tasks and those of hints.md.
std::vector<std::string> hints_of(const Handout& handout)
{
    const auto folder = assignments() / handout.name;
    std::vector<std::string> hints;
    const auto assignment = nlohmann::json::parse(content(folder / "assignment.json"));
    for (const auto& task : assignment.at("tasks"))
        hints.push_back(task.at("hint").get<std::string>());
    std::istringstream lines(content(folder / "hints.md"));
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with("1. ") || line.starts_with("2. "))
            hints.push_back(line);
        else
            hints.back() += " " + line;
    return hints;
}

} // namespace

TEST_CASE("answers: an expression of a source is found, in code and in a comment", "[hints]")
{
    const auto answers =
        answers_in("// v = ω × (x - X) + V\nreturn w.cross(x - X) + V;\nint n = 3;");
    CHECK(answers == std::vector<std::string>{"ω×(x-X)+V", "w×(x-X)+V"});
    CHECK(pressed("Write `ω × (x − X) + V`.").find(answers[0]) != std::string::npos);
}

TEST_CASE("answers: no hint has one", "[hints]")
{
    const auto reference = assignments().parent_path() / "reference";
    std::size_t all = 0;
    for (const Handout& handout : all_handouts()) {
        const std::string topic = handout.name.substr(handout.name.find('-') + 1);
        const std::vector<std::string> answers = answers_in(content(reference / (topic + ".cpp")));
        all += answers.size();
        for (const std::string& hint : hints_of(handout)) {
            const std::string text = pressed(hint);
            for (const std::string& answer : answers) {
                INFO(handout.label << ": " << hint << "\nhas the answer " << answer);
                CHECK(text.find(answer) == std::string::npos);
            }
        }
    }
    CHECK(all > 150);
}
