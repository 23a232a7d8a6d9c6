// SPDX-License-Identifier: MIT
// The rules are those of junit-10.xsd, the schema of Jenkins' xUnit plugin.
#include "report/exports/junit.hpp"

#include "framework/report/results.hpp"
#include "support/catch.hpp"

#include <map>
#include <regex>
#include <set>

namespace rigor::testing {

namespace {

using Names = std::set<std::string>;

struct Element {
    Names attributes, parents;
};

// The elements that we use, with their attributes and where they may stand.
const std::map<std::string, Element> schema = {
    {"testsuites", {{"name", "time", "tests", "failures", "disabled", "errors"}, {""}}},
    {"testsuite",
     {{"name", "tests", "failures", "errors", "group", "time", "skipped", "timestamp", "hostname",
       "id", "package", "file", "log", "url", "version"},
      {"testsuites"}}},
    {"testcase",
     {{"name", "time", "classname", "group", "assertions", "status", "class", "file", "line"},
      {"testsuite"}}},
    {"failure", {{"type", "message"}, {"testcase"}}},
    {"error", {{"type", "message"}, {"testcase"}}},
    {"skipped", {{"type", "message"}, {"testcase"}}}};

// Checks that tags are balanced and stand where the schema has them. @return how often each occurs
std::map<std::string, int> checked_elements(const std::string& text)
{
    static const std::regex tag("<(/?)([a-z]+)((?: [a-z]+=\"[^\"<]*\")*)(/?)>"),
        attribute(" ([a-z]+)=\"");
    std::map<std::string, int> counts;
    std::vector<std::string> open = {""};
    const std::size_t start = text.find("?>") + 2;
    std::size_t end = start;
    for (std::sregex_iterator
             match(text.begin() + static_cast<std::ptrdiff_t>(start), text.end(), tag),
         none;
         match != none; ++match) {
        const std::string name = (*match)[2], attributes = (*match)[3];
        const auto at = start + static_cast<std::size_t>(match->position());
        REQUIRE(text.substr(end, at - end).find_first_of("<>") == std::string::npos);
        end = at + static_cast<std::size_t>(match->length());
        if ((*match)[1] == "/") {
            REQUIRE(open.back() == name);
            open.pop_back();
            continue;
        }
        CAPTURE(name);
        REQUIRE(schema.count(name) == 1);
        REQUIRE(schema.at(name).parents.count(open.back()) == 1);
        for (std::sregex_iterator a(attributes.begin(), attributes.end(), attribute); a != none;
             ++a)
            REQUIRE(schema.at(name).attributes.count((*a)[1]) == 1);
        ++counts[name];
        if ((*match)[4] != "/") open.push_back(name);
    }
    REQUIRE(open.size() == 1);
    return counts;
}

} // namespace

TEST_CASE("junit: a result keeps the schema and its counts are true", "[report]")
{
    Result result = some_result();
    result.tasks.push_back({task_of("A2.16", "hidden", 1), Status::skipped, 0, 0, {}});
    const std::string text = junit_xml(result);
    CAPTURE(text);
    REQUIRE(
        checked_elements(text) ==
        std::map<std::string, int>{
            {"testsuites", 1}, {"testsuite", 1}, {"testcase", 6}, {"failure", 3}, {"skipped", 1}});
    REQUIRE(text.find("<testsuite name=\"student\" tests=\"6\" failures=\"3\" errors=\"0\" "
                      "time=\"0.000\" skipped=\"1\">") != std::string::npos);
}

TEST_CASE("junit: nothing that a student prints is a tag or breaks the file", "[report]")
{
    Result result = some_result();
    result.submission = "a\"<b>&";
    result.tasks[2].tests[0].message = "</failure>\x1b[31m\xff]]> & more\nand \"quotes\"";
    const std::string text = junit_xml(result);
    CAPTURE(text);
    REQUIRE(checked_elements(text)["failure"] == 3);
    REQUIRE(text.find("| &lt;/failure&gt;?[31m?]]&gt; &amp; more&#10;| and") != std::string::npos);
    REQUIRE(text.find("name=\"a&quot;&lt;b&gt;&amp;\"") != std::string::npos);
}

TEST_CASE("junit: no line that a student printed looks like one of ours", "[report]")
{
    Result result = some_result();
    result.tasks[1].tests[1].message = "no\nexpected: nothing";
    const std::string text = junit_xml(result);
    CAPTURE(text);
    REQUIRE(text.find(">| no&#10;| expected: nothing&#10;expected: (1, 2, 3)&#10;actual:") !=
            std::string::npos);
}

TEST_CASE("junit: a submission without a grade by tests is an error in each task", "[report]")
{
    Result result = some_result();
    result.status = SubmissionStatus::compile_error;
    result.message = "inertia.cpp:1: error: expected ';'";
    REQUIRE(checked_elements(junit_xml(result))["error"] == 4);
}

} // namespace rigor::testing
