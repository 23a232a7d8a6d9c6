// SPDX-License-Identifier: MIT
// What a handout asks of a reader: hours that fit the points, questions with folded answers, and a
// text that every viewer shows.
#include "handouts/coverage.hpp"
#include "handouts/handouts.hpp"
#include "support/catch.hpp"

#include <cctype>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>

using namespace rigor::handouts;

namespace {

// The points of all tasks of an assignment.
double points_of(const Handout& handout)
{
    const auto assignment =
        nlohmann::json::parse(content(assignments() / handout.name / "assignment.json"));
    double sum = 0;
    for (const auto& task : assignment.at("tasks"))
        sum += task.at("points").get<double>();
    return sum;
}

std::vector<std::string> matches(const std::string& text, const std::string& pattern)
{
    std::vector<std::string> found;
    const std::regex regex(pattern);
    for (std::sregex_iterator i(text.begin(), text.end(), regex), end; i != end; ++i)
        found.push_back((*i)[1]);
    return found;
}

// All handouts but the warm-up.
std::vector<Handout> long_handouts()
{
    std::vector<Handout> handouts = all_handouts();
    std::erase_if(handouts, [](const Handout& h) { return h.label == "A0"; });
    return handouts;
}

} // namespace

TEST_CASE("exercises: the points of an assignment fit its hours", "[exercises]")
{
    for (const Handout& handout : long_handouts()) {
        CAPTURE(handout.label);
        const std::regex hours(R"(Count\s+on\s+(\d+)\s+to\s+(\d+)\s+hours)");
        std::smatch found;
        REQUIRE(std::regex_search(handout.text, found, hours));
        const double mean = (std::stod(found[1]) + std::stod(found[2])) / 2;
        CAPTURE(mean, points_of(handout));
        CHECK(points_of(handout) >= 2.5 * mean);
        CHECK(points_of(handout) <= 5 * mean);
    }
}

TEST_CASE("exercises: the heading of a task has its points", "[exercises]")
{
    for (const Handout& handout : all_handouts()) {
        double sum = 0;
        for (const std::string& points :
             matches(handout.text, "\n### A\\d\\.\\d+ [^\n]*\\((\\d+) points?"))
            sum += std::stod(points);
        CAPTURE(handout.label);
        CHECK(sum == points_of(handout));
    }
}

TEST_CASE("exercises: each handout says that a task of more than 2 points has parts", "[exercises]")
{
    for (const Handout& handout : all_handouts()) {
        CAPTURE(handout.label);
        static const std::regex sentence(
            R"(A\s+task\s+of\s+more\s+than\s+2\s+points\s+has\s+parts)");
        CHECK(std::regex_search(handout.text, sentence));
    }
}

TEST_CASE("exercises: each question has an answer behind a fold", "[exercises]")
{
    for (const Handout& handout : long_handouts()) {
        CAPTURE(handout.label);
        const auto questions =
            matches(handout.text, "\n<details>\n<summary>([^<]+)</summary>\n\n[^<]+\n</details>\n");
        CHECK(questions.size() >= 5);
        CHECK(questions.size() == matches(handout.text, "(<details>)").size());
        CHECK(questions.size() == matches(handout.text, "(</details>)").size());
        for (const std::string& question : questions) {
            CAPTURE(question);
            CHECK(question.find_first_of("$`*") == std::string::npos); // shown as it is
        }
    }
}

TEST_CASE("exercises: each handout has the same sections", "[exercises]")
{
    for (const Handout& handout : long_handouts()) {
        std::size_t at = 0;
        for (const char* section :
             {"The mathematics", "Conventions", "Tasks", "Predict, then run", "Watch",
              "If you see this", "A table of your own", "Find the bug", "A scene of your own",
              "Read on", "What the tests check"}) {
            const bool is_of_scenes =
                std::string(section) == "Watch" || std::string(section) == "A scene of your own";
            if (is_of_scenes && !has_scenes(handout)) continue;
            CAPTURE(handout.label, section);
            at = handout.text.find(std::string("\n## ") + section + "\n", at);
            REQUIRE(at != std::string::npos);
        }
    }
}

TEST_CASE("exercises: a handout begins with what it needs and what it teaches", "[exercises]")
{
    for (const Handout& handout : long_handouts()) {
        CAPTURE(handout.label);
        const std::string start = handout.text.substr(0, handout.text.find("\n## The mathematics"));
        static const std::regex needs(R"(\nYou\s+need\s+([^!#]*?)Count\s+on)");
        std::smatch found;
        REQUIRE(std::regex_search(start, found, needs));
        const std::string needed = found[1];
        static const std::regex alone(R"(no\s+other\s+assignment|only\s+the\s+loop)");
        const auto tags = matches(needed, R"((A\d)\.\d+)");
        CHECK((!tags.empty() || std::regex_search(needed, alone)));
        for (const std::string& label : tags)
            CHECK(label <= handout.label);
        CHECK(std::regex_search(start, std::regex(R"(Afterwards\s+you\s+(can|know))")));
        CHECK((start.find("![") != std::string::npos || !has_scenes(handout)));
    }
}

TEST_CASE("exercises: each section has content", "[exercises]")
{
    for (const Handout& handout : long_handouts())
        for (const std::string& title : matches(handout.text, "\n## ([^\n]+)")) {
            CAPTURE(handout.label, title);
            const std::size_t start = handout.text.find("\n## " + title + "\n");
            const std::string section =
                handout.text.substr(start, handout.text.find("\n## ", start + 1) - start);
            CHECK(section.size() > 150);
            if (title == "Read on") CHECK(matches(section, "\n(- )").size() >= 2);
            if (title == "If you see this") CHECK(table_rows(section).size() >= 5);
            if (title == "Predict, then run") CHECK(matches(section, "(<details>)").size() >= 4);
            if (title == "A table of your own") {
                CHECK(table_rows(section).size() >= 3);
                CHECK(matches(section, "(<details>)").size() == 1);
            }
        }
}

TEST_CASE("exercises: the plan of the course has the hours and the points", "[exercises]")
{
    double points = 0;
    int least = 1, most = 1; // the hours of A0
    const std::string plan = content(assignments() / "course.md");
    for (const Handout& handout : all_handouts()) {
        CAPTURE(handout.label);
        points += points_of(handout);
        const std::regex row(R"(\| )" + handout.label + R"( \| (\d+)( to (\d+))? \| (\d+) \|)");
        std::smatch planned, said;
        REQUIRE(std::regex_search(plan, planned, row));
        CHECK(std::stod(planned[4]) == points_of(handout));
        static const std::regex hours(R"(Count\s+on\s+(\d+)\s+to\s+(\d+)\s+hours)");
        if (!std::regex_search(handout.text, said, hours)) continue; // A0
        CHECK(planned[1] == said[1]);
        CHECK(planned[3] == said[2]);
        least += std::stoi(said[1]);
        most += std::stoi(said[2]);
    }
    std::set<std::string> slides = {"Rigid bodies", "Inertia, rotation, impulses"}; // the lectures
    for (const CoverageRow& row : coverage())
        slides.insert(row.slide);
    for (const auto& cells : table_rows(plan))
        for (const std::string& slide : matches(cells.at(1), "\"([^\"]+)\"")) {
            CAPTURE(slide);
            CHECK(slides.count(slide) == 1);
        }
    std::ostringstream sum;
    sum << "That is " << least << " to " << most << " hours and " << points << " points";
    CAPTURE(sum.str());
    CHECK(plan.find(sum.str()) != std::string::npos);
}

TEST_CASE("exercises: no text has a character that cannot be seen", "[exercises]")
{
    for (const auto& entry : std::filesystem::recursive_directory_iterator(assignments())) {
        if (entry.path().extension() != ".md" && entry.path().extension() != ".json") continue;
        CAPTURE(entry.path());
        int unseen = 0;
        for (const char c : content(entry.path()))
            unseen += c != '\n' && std::iscntrl(static_cast<unsigned char>(c)) != 0 ? 1 : 0;
        CHECK(unseen == 0);
    }
}
