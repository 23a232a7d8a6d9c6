// SPDX-License-Identifier: MIT
#include "report/exports/junit.hpp"

#include "errors/quotes.hpp"
#include "errors/utf8.hpp"

#include <fmt/format.h>

namespace rigor {

namespace {

// XML 1.0 has no way to write most control characters: they become question marks, as does what is
// not UTF-8.
std::string xml(std::string_view text)
{
    std::string result;
    while (!text.empty()) {
        const std::size_t size = character_size(text);
        const char c = text[0];
        if (c == '&')
            result += "&amp;";
        else if (c == '<')
            result += "&lt;";
        else if (c == '>')
            result += "&gt;";
        else if (c == '"')
            result += "&quot;";
        else if (c == '\n' || c == '\t')
            result += fmt::format("&#{};", static_cast<int>(c));
        else if (size == 0)
            result += '?';
        else
            result += text.substr(0, size);
        text.remove_prefix(size == 0 ? 1 : size);
    }
    return result;
}

struct Counts {
    int tests = 0, failures = 0, errors = 0, skipped = 0;
    double seconds = 0;
};

std::string test_case(const Result& result, const TaskResult& task, const std::string& law,
                      double seconds, const std::string& content)
{
    const std::string name =
        task.task.tag + " " + task.task.name() + (law.empty() ? "" : ": " + law);
    const std::string begin =
        fmt::format("    <testcase classname=\"{}\" name=\"{}\" time=\"{:.3f}\"",
                    xml(result.assignment.name), xml(name), seconds);
    return content.empty() ? begin + "/>\n" : begin + ">\n      " + content + "\n    </testcase>\n";
}

std::string failure(const TestCase& test)
{
    std::string text = test.message.empty() ? "" : behind_bars(test.message);
    if (!test.expected.empty())
        text += (text.empty() ? "" : "\n") + ("expected: " + test.expected) +
                "\nactual:   " + test.actual;
    const std::string_view status = to_string(test.status);
    return fmt::format("<failure type=\"{}\" message=\"{}\">{}</failure>", status,
                       xml(test.name.empty() ? status : test.name), xml(text));
}

std::string cases_of(const Result& result, const TaskResult& task, Counts& counts)
{
    if (result.status != SubmissionStatus::graded) {
        ++counts.tests;
        ++counts.errors;
        const std::string_view status = to_string(result.status);
        return test_case(result, task, "", 0,
                         fmt::format("<error type=\"{}\" message=\"{}\">{}</error>", status, status,
                                     xml(result.message)));
    }
    if (task.tests.empty()) {
        ++counts.tests;
        ++counts.skipped;
        return test_case(result, task, "", 0, "<skipped>did not run</skipped>");
    }
    std::string text;
    for (const TestCase& test : task.tests) {
        ++counts.tests;
        counts.seconds += test.seconds;
        std::string content;
        if (test.status == Status::skipped) {
            ++counts.skipped;
            content = "<skipped>skipped</skipped>";
        } else if (test.status != Status::passed) {
            ++counts.failures;
            content = failure(test);
        }
        text += test_case(result, task, test.name, test.seconds, content);
    }
    return text;
}

} // namespace

std::string junit_xml(const Result& result)
{
    Counts counts;
    std::string cases;
    for (const TaskResult& task : result.tasks)
        cases += cases_of(result, task, counts);
    const std::string numbers =
        fmt::format("tests=\"{}\" failures=\"{}\" errors=\"{}\" time=\"{:.3f}\"", counts.tests,
                    counts.failures, counts.errors, counts.seconds);
    return fmt::format("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                       "<testsuites name=\"{0}\" {2}>\n"
                       "  <testsuite name=\"{1}\" {2} skipped=\"{3}\">\n{4}"
                       "  </testsuite>\n</testsuites>\n",
                       xml(result.assignment.name), xml(result.submission), numbers, counts.skipped,
                       cases);
}

} // namespace rigor
