// SPDX-License-Identifier: MIT
// The report for a student as text of 80 columns. First comes a row for each task with its points,
// then each failure with the broken law, the expected and the actual value, and a hint, and last
// the next step.
#include "report/table.hpp"

#include "formulas/table.hpp"
#include "grading/intake/contents.hpp"
#include "grading/intake/plain_file.hpp"
#include "grading/intake/refused.hpp"
#include "grading/places.hpp"
#include "report/terminal.hpp"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>
#include <fstream>
#include <sstream>

namespace rigor {

namespace {

constexpr std::size_t width = 80, label_width = 14;

struct Look {
    Color color;
    std::string_view words;
};

Look look_of(Status status)
{
    switch (status) {
    case Status::passed:
        return {Color::green, "passed"};
    case Status::skipped:
        return {Color::dim, "skipped"};
    case Status::not_implemented:
        return {Color::yellow, "not implemented yet"};
    case Status::compile_error:
        return {Color::red, "not defined"};
    case Status::failed:
        return {Color::red, "failed"};
    case Status::not_finite:
        return {Color::red, "not finite"};
    case Status::timed_out:
        return {Color::red, "timed out"};
    case Status::crashed:
        return {Color::red, "crashed"};
    }
    return {Color::red, "?"};
}

bool is_wrong(const TaskResult& task)
{
    return task.status >= Status::compile_error;
}

// The law that a test case states, without the topic before it.
std::string law_of(const std::string& name)
{
    const std::size_t colon = name.find(": ");
    return colon == std::string::npos ? name : name.substr(colon + 2);
}

std::string row(const std::string& label, const std::string& text)
{
    if (text.empty()) return "";
    const std::size_t indent = 2 + label_width;
    return "  " + padded(label, label_width) + wrapped(text, width - indent, indent) + "\n";
}

std::string handout(const Result& result, const TaskResult& task)
{
    return fmt::format("assignments/{}/README.md, {}", result.assignment.name, task.task.tag);
}

// The declaration of a formula in the contract, with its namespace; empty if there is none.
std::string declaration_of(const std::string& topic, const std::string& formula)
{
    if (formula.empty()) return "";
    std::ifstream file(places().source / "framework/formulas" / (topic + ".hpp"));
    const std::string text(std::istreambuf_iterator<char>(file), {});
    const std::size_t name = text.find(" " + formula + "(");
    const std::size_t begin = text.rfind('\n', name) + 1, end = text.find(';', name);
    if (name == std::string::npos || end == std::string::npos) return "";
    std::string declaration = "in namespace rigor: ";
    for (const char c : text.substr(begin, end - begin)) {
        const bool is_space = c == ' ' || c == '\n';
        if (!is_space || !declaration.ends_with(' ')) declaration += is_space ? ' ' : c;
    }
    return declaration;
}

// The longest value that a row shows in full [bytes]. Of a longer value, the beginning is enough.
constexpr std::size_t longest = 400;
// The longest case that a row shows in full [bytes]. It has the call of the formula, which students
// copy into their own programs, so it is not cut as early as a value.
constexpr std::size_t longest_case = 4000;

std::string shortened(const std::string& text, std::size_t limit = longest)
{
    if (text.size() <= limit) return text;
    std::size_t end = limit;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80)
        --end; // do not cut a UTF-8 character
    return text.substr(0, end) + " …";
}

// The kind of a tolerance in words.
std::string class_words(const std::string& tolerance_class)
{
    constexpr std::pair<const char*, const char*> known[] = {{"R", " (rounding)"},
                                                             {"O", " (order of convergence)"},
                                                             {"I", " (invariant)"},
                                                             {"S", " (statistical, 5 sigma)"},
                                                             {"B", " (bracket)"}};
    for (const auto& [letter, words] : known)
        if (tolerance_class == letter) return words;
    return "";
}

std::string difference(const TestCase& test)
{
    if (test.error.empty()) return "";
    return test.error + ", allowed " + test.tolerance + class_words(test.tolerance_class);
}

// The place of a wrong number in words. "(2)" alone says little about a vector or matrix, so this
// becomes "entry (2), counted from 0".
std::string place_in_words(const std::string& place)
{
    return place.starts_with('(') ? "entry " + place + ", counted from 0" : place;
}

// The test's notes on the case that it tried: the lines of its message after the first.
std::string noted(const TestCase& test)
{
    std::string text;
    std::istringstream lines(test.message);
    std::string line;
    std::getline(lines, line);
    while (std::getline(lines, line))
        text += (text.empty() ? "" : ", ") + line;
    return shortened(text, longest_case);
}

// The laws that failed besides the one that is shown in full: the names of as many as fit, and the
// number of the remaining ones.
std::string also_broken(const TaskResult& task)
{
    std::string text;
    std::size_t counted = 0;
    for (const TestCase& test : task.tests) {
        if (test.status == Status::passed || &test == task.first_failure()) continue;
        const std::string next = (text.empty() ? "" : "; ") + law_of(test.name);
        if (counted > 0 || (!text.empty() && text.size() + next.size() > longest))
            ++counted;
        else
            text += next;
    }
    return counted > 0 ? fmt::format("{}; and {} more", text, counted) : text;
}

std::string failure_text(const Result& result, const TaskResult& task,
                         const Implementation& implementation, bool color)
{
    const TestCase& test = *task.first_failure();
    const Look look = look_of(task.status);
    const bool compared = !test.expected.empty();
    std::string text = "\n" + colored(task.task.tag + " " + task.task.name(), Color::bold, color) +
                       "  " + colored(look.words, look.color, color) + "\n";
    if (task.task.discloses == Disclosure::nothing)
        return text + row("hint", task.task.hint) + row("to read", handout(result, task));
    if (task.status == Status::compile_error) // the formula is missing: no law was checked
        return text + row("what happened", shortened(test.message)) +
               row("declared", declaration_of(result.assignment.topic, task.task.formula)) +
               row("your code", implementation.shown_file(result.assignment.topic));
    text += row("the law", law_of(test.name));
    if (!compared) text += row("what happened", shortened(test.message));
    text += row("the mistake", task.mistake());
    text += row("the case", compared ? noted(test) : "");
    text += row("where in it", compared ? place_in_words(test.place) : "");
    text += row("expected", shortened(test.expected));
    text += row("actual", compared ? shortened(test.actual) : "");
    text += row("error", difference(test));
    text += row("also broken", also_broken(task));
    if (test.seed)
        text +=
            row("try again", fmt::format("./rigor check {} --seed {}", task.task.tag, *test.seed));
    text += row("hint", test.hint.empty() ? task.task.hint : test.hint);
    text += row("your code",
                task.task.formula.empty()
                    ? implementation.shown_file(result.assignment.topic)
                    : place_of(implementation, result.assignment.topic, task.task.formula));
    return text + row("to read", handout(result, task));
}

constexpr std::size_t longest_tag = 6; // [bytes], the length of "A10.12"

// Tag of the stub that a task's test called, from a message such as "A1.9 equations_of_motion is
// not implemented yet (…)"; empty if the test called no stub.
std::string stub_of(const TaskResult& task)
{
    if (task.status != Status::not_implemented) return "";
    // A student's code may throw NotImplemented with any text, so the first word may be no tag.
    const std::string& message = task.first_failure()->message;
    const std::string tag = message.substr(0, message.find(' '));
    const bool is_tag = tag.size() <= longest_tag && tag.starts_with("A") &&
                        tag.find_first_not_of("A0123456789.") == std::string::npos;
    return is_tag ? tag : "";
}

// The points of a task. A task that this run cannot judge has a dash in place of its score.
std::string points_of(const TaskResult& task)
{
    if (task.max_score == 0) return fmt::format("-/{:g}", task.task.points);
    return fmt::format("{:g}/{:g}", task.score, task.max_score);
}

std::string task_row(const TaskResult& task, bool color)
{
    const Look look = look_of(task.status);
    std::string words(look.words);
    if (task.status == Status::passed && task.follow_through)
        words = "passed, with others put right";
    if (task.status == Status::skipped && task.task.is_hidden) words = "hidden, run by the course";
    const auto wrong =
        std::count_if(task.tests.begin(), task.tests.end(),
                      [](const TestCase& test) { return test.status != Status::passed; });
    const std::string stub = stub_of(task);
    if (!stub.empty() && stub != task.task.tag) words = "calls " + stub + ", a stub";
    if (is_wrong(task) && task.status != Status::compile_error && task.tests.size() > 1)
        words += fmt::format(", {} of {} laws broken", wrong, task.tests.size());
    return fmt::format("  {:<6} {} {:>5} {}\n", task.task.tag, padded(task.task.name(), 32),
                       points_of(task), "  " + colored(words, look.color, color));
}

// The row of the table of formulas with this tag; null for a task without a formula.
const Formula* formula_with(const std::string& tag)
{
    const auto found = std::find_if(std::begin(formulas), std::end(formulas),
                                    [&](const Formula& formula) { return formula.tag == tag; });
    return found == std::end(formulas) ? nullptr : &*found;
}

// The handout that explains a formula: "assignments/a4-collision/README.md, A4.8".
std::string handout(const Formula& formula)
{
    const std::string label(formula.tag.substr(1, formula.tag.find('.') - 1));
    return fmt::format("assignments/a{}-{}/README.md, {}", label, formula.topic, formula.tag);
}

// The next step for the student: the first formula that is not implemented yet. If its test calls
// the stub of another formula, that formula is the next step.
std::string next_step(const Result& result, const Implementation& implementation, bool color)
{
    const Formula* next = nullptr;
    int stubs = 0;
    for (const TaskResult& task : result.tasks) {
        if (task.status != Status::not_implemented) continue;
        ++stubs;
        if (next) continue;
        const std::string stub = stub_of(task);
        next = formula_with(stub.empty() ? task.task.tag : stub);
    }
    if (!next) return "";
    return "\n" + colored(fmt::format("Next: {} {}", next->tag, next->name), Color::bold, color) +
           (stubs > 1 ? fmt::format(" ({} tasks are not implemented yet)", stubs) : "") + "\n" +
           row("your code",
               place_of(implementation, std::string(next->topic), std::string(next->name))) +
           row("to read", handout(*next));
}

// The text of a student's file; empty if the file is none that can be taken.
std::string source_of(const std::filesystem::path& file)
{
    try {
        return read_plain_file(file.parent_path(), file.filename(), IntakeLimits().source_bytes)
            .text;
    } catch (const Refused&) {
        return "";
    }
}

std::string total(const Result& result, bool color)
{
    const Color of = result.all_points() ? Color::green : Color::none;
    std::string text =
        colored(fmt::format("{:g} of {:g} points", result.score(), result.max_score()), of, color);
    double elsewhere = 0;
    for (const TaskResult& task : result.tasks)
        if (task.max_score == 0) elsewhere += task.task.points;
    if (elsewhere > 0) text += fmt::format("; {:g} more are judged by the course", elsewhere);
    return text;
}

std::string ungraded(const Result& result, bool color)
{
    const char* words = result.status == SubmissionStatus::compile_error
                            ? "no function can be called"
                        : result.status == SubmissionStatus::rejected
                            ? "cannot be graded"
                            : "a fault of the framework, not of the solution";
    return colored(fmt::format("{}: {}", to_string(result.status), words), Color::red, color) +
           "\n" + result.message + (result.message.ends_with('\n') ? "" : "\n");
}

} // namespace

std::string place_of(const Implementation& implementation, const std::string& topic,
                     const std::string& formula)
{
    const std::string shown = implementation.shown_file(topic);
    std::istringstream source(source_of(implementation.file(topic)));
    int number = 0;
    for (std::string line; std::getline(source, line);) {
        ++number;
        const std::size_t at = line.find(formula + "(");
        const bool begins = at != std::string::npos && at > 0 && line[at - 1] == ' ';
        // A line with a semicolon is a declaration, and an indented line is a call.
        const bool is_definition = begins && std::isalpha(static_cast<unsigned char>(line[0])) &&
                                   line.find(';') == std::string::npos;
        if (is_definition) return fmt::format("{}:{}", shown, number);
    }
    return shown;
}

std::string points_table(const Result& result, const Implementation& implementation, bool color)
{
    const Assignment& assignment = result.assignment;
    std::string label = assignment.label();
    std::transform(label.begin(), label.end(), label.begin(),
                   [](unsigned char c) { return std::toupper(c); });
    std::string text = colored(fmt::format("{} {}: {}", label, assignment.topic, assignment.title),
                               Color::bold, color);
    text += "\n";
    if (result.status != SubmissionStatus::graded) return text + ungraded(result, color);
    for (const TaskResult& task : result.tasks)
        text += task_row(task, color);
    text += "  " + total(result, color) + "\n";
    for (const TaskResult& task : result.tasks)
        if (is_wrong(task)) text += failure_text(result, task, implementation, color);
    return text + next_step(result, implementation, color);
}

std::string summary(const std::vector<Result>& results, bool color)
{
    std::string text;
    double score = 0, max_score = 0;
    for (const Result& result : results) {
        const bool graded = result.status == SubmissionStatus::graded;
        text += fmt::format("  {} {}\n", padded(result.assignment.name, 40),
                            graded ? fmt::format("{:>7}", fmt::format("{:g}/{:g}", result.score(),
                                                                      result.max_score()))
                                   : colored(to_string(result.status), Color::red, color));
        score += result.score();
        max_score += result.max_score();
    }
    return text + fmt::format("  {} {:>7}\n", padded("all", 40),
                              fmt::format("{:g}/{:g}", score, max_score));
}

} // namespace rigor
