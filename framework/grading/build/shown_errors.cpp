// SPDX-License-Identifier: MIT
// Cuts the messages of a tool to the first errors. Then removes from each line what does not help a
// student: paths of this machine, names of options, and requests for a bug report.
#include "grading/build/shown_errors.hpp"

#include "errors/printable.hpp"
#include "grading/build/lines.hpp"
#include "grading/build/ninja.hpp"
#include "grading/build/replace_all.hpp"
#include "grading/places.hpp"

#include <algorithm>
#include <array>
#include <csignal>
#include <string_view>
#include <vector>

namespace rigor {

namespace {

bool mentions(const std::string& text, std::string_view part)
{
    return text.find(part) != std::string::npos;
}

// Removes the text from the first `begin` to the next `end`, both included, such as advice in
// brackets.
void remove_between(std::string& line, std::string_view begin, std::string_view end)
{
    const std::size_t first = line.find(begin);
    if (first == std::string::npos) return;
    const std::size_t last = line.find(end, first);
    if (last != std::string::npos) line.erase(first, last + end.size() - first);
}

// Replaces the path of the precompiled header, or of a header or source that it was made from, by
// plain words.
void name_precompiled_header(std::string& line)
{
    constexpr std::string_view name = "cmake_pch.hxx", ends = " '\"()<>,";
    for (std::size_t at = 0; (at = line.find(name, at)) != std::string::npos;) {
        const std::size_t before = line.find_last_of(ends, at);
        const std::size_t first = before == std::string::npos ? 0 : before + 1;
        const std::size_t after = std::min(line.find_first_of(" '\"()<>,:", at), line.size());
        constexpr std::string_view words = "the precompiled headers";
        line.replace(first, after - first, words);
        at = first + words.size();
    }
}

// The compiler may see the names of files outside of the submission. Its message must not tell
// which of them exist: it always says that there is no such file.
void hide_what_there_is(std::string& line)
{
    for (const char* reason : {"Permission denied", "Not a directory"})
        replace_all(line, reason, "No such file or directory");
    constexpr std::string_view cannot = "cannot open file '", none = "': No such file or directory";
    // Clang has other words for a file that does not exist: "file not found".
    if (mentions(line, cannot) && line.ends_with(none)) {
        line.replace(line.size() - none.size(), none.size(), "' file not found");
        line.erase(line.find(cannot), cannot.size() - 1);
    }
}

// Whether a line does not help a student, because it only says how to raise a limit of the
// compiler, how many errors there were, or where to report a bug.
bool is_empty_talk(const std::string& line)
{
    constexpr std::array<std::string_view, 7> talk = {
        "note: use -f",      "compilation terminated.", "Please submit a", "PLEASE submit a",
        "See <file:///usr/", "errors generated.",       "error generated."};
    return std::any_of(talk.begin(), talk.end(),
                       [&](std::string_view words) { return mentions(line, words); });
}

// Removes the answers to `#pragma GCC dependency "file"`, which asks whether a file exists and is
// newer. Each is a warning that may be followed by the line of the source.
std::vector<std::string> without_answers_about_files(const std::vector<std::string>& lines)
{
    std::vector<std::string> kept;
    bool is_answer = false;
    for (const std::string& line : lines) {
        if (mentions(line, "cannot find source file") ||
            mentions(line, "current file is older than"))
            is_answer = true;
        else if (mentions(line, "error: ") || mentions(line, "warning: "))
            is_answer = false;
        if (!is_answer) kept.push_back(line);
    }
    return kept;
}

std::string in_plain_words(std::string line)
{
    if (mentions(line, "compilation terminated due to -fmax-errors") ||
        mentions(line, "too many errors emitted, stopping now"))
        return "(there are more errors: the compiler stopped here)";
    replace_all(line, places().source.string() + "/", "");
    replace_all(line, places().build.string() + "/", "");
    replace_all(line, "{standard input}", "the assembler, line of its input");
    name_precompiled_header(line);
    hide_what_there_is(line);
    remove_between(line, " (use '-f", ")"); // "(use '-ftemplate-depth=' to increase the maximum)"
    remove_between(line, " (use -f", ")");
    remove_between(line, "; use -f", " to see all");
    return line;
}

} // namespace

std::string shown_errors(const std::string& output)
{
    std::string text = printable(output);
    replace_all(text, "{standard input}: Assembler messages:\n", "");
    // A message may contain text of the student, even with line breaks. The bar before each line
    // shows that the line is a message of the tool and not a verdict of the grader.
    std::string barred;
    const std::vector<std::string> lines = without_answers_about_files(lines_of(text));
    for (const std::string& line : lines_of(first_errors(lines)))
        if (!is_empty_talk(line)) barred += "| " + in_plain_words(line) + "\n";
    return barred;
}

namespace {

// Whether a line is a message of a tool about itself, "cc1plus: out of memory". Other lines name a
// place in a file or show a line of it, with words of the student.
bool is_about_itself(const std::string& line)
{
    for (const char* begin : {"LLVM ERROR: ", "virtual memory exhausted", "terminate called "})
        if (line.starts_with(begin)) return true;
    const std::size_t end_of_name = line.find_first_of(": ");
    return end_of_name != std::string::npos && line.compare(end_of_name, 2, ": ") == 0;
}

std::string about_themselves(const std::string& output)
{
    std::string kept;
    for (const std::string& line : lines_of(output))
        if (is_about_itself(line)) kept += line + "\n";
    return kept;
}

} // namespace

ToolLimit limit_met(const ConfinedRun& run, double time)
{
    const std::string output = about_themselves(run.output);
    if (run.signal == SIGXFSZ) return ToolLimit::file_size;
    if (run.timed_out || run.signal == SIGXCPU) return ToolLimit::time;
    // The texts below are the system's names of signals, and messages of gcc, Clang and the
    // assembler about a lack of memory.
    if (mentions(output, "File size limit exceeded")) return ToolLimit::file_size;
    if (mentions(output, "CPU time limit exceeded")) return ToolLimit::time;
    // The kernel also kills a program whose time is over. It measures time less exactly than here.
    bool was_killed = run.signal == SIGKILL;
    for (const char* words : {"Killed signal terminated program", "ld terminated with signal 9",
                              "unable to execute command: Killed"})
        was_killed = was_killed || mentions(output, words);
    if (was_killed && run.processor_seconds > 0.8 * time) return ToolLimit::time;
    for (const char* words : {": out of memory", "virtual memory exhausted", "memory exhausted",
                              "Cannot allocate memory", "std::bad_alloc"})
        if (mentions(output, words)) return ToolLimit::memory;
    return ToolLimit::none;
}

} // namespace rigor
