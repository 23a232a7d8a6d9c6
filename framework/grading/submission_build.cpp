// SPDX-License-Identifier: MIT
// Writes ninja rules that build a worker from a folder of topic files. The commands are those that
// the main build uses for student/ and its worker, with the names of sources and objects replaced.
// Topics that the folder lacks keep the objects of student/.
#include "grading/submission_build.hpp"

#include "errors/input_error.hpp"
#include "grading/ninja.hpp"
#include "grading/places.hpp"
#include "grading/replace_all.hpp"
#include "grading/topics.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fstream>
#include <sstream>

namespace rigor {

namespace fs = std::filesystem;

namespace {

// FNV-1a, so that a folder's build has the same name on every machine and in every run.
std::uint64_t hash(const std::string& text)
{
    std::uint64_t h = 0xcbf29ce484222325;
    for (const unsigned char c : text)
        h = (h ^ c) * 0x100000001b3;
    return h;
}

std::string shell_quoted(const std::string& text)
{
    std::string result = "'";
    for (const char c : text)
        result += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return result + "'";
}

std::string ninja_path(const std::string& text)
{
    std::string result;
    for (const char c : text)
        result += (c == ' ' || c == ':' || c == '$') ? std::string("$") + c : std::string(1, c);
    return result;
}

std::string ninja_value(const std::string& text)
{
    std::string result;
    for (const char c : text)
        result += c == '$' ? std::string("$$") : std::string(1, c);
    return result;
}

// A command that compiles a file of student/.
struct Compilation {
    std::string command, object;
};

// The object that a command makes of a file of student/; empty if it does something else.
std::string student_object(const std::string& command)
{
    const std::size_t output = command.find(" -o "), source = command.find(" -c ");
    if (output == std::string::npos || source == std::string::npos || source < output) return {};
    const std::string object = command.substr(output + 4, source - output - 4);
    return object.find("formulas_student.dir/") == std::string::npos ? std::string() : object;
}

// Whether the command compiles the student's `topic`. If so, `found` is set.
bool compiles(const std::string& command, const std::string& topic, Compilation& found)
{
    const std::string object = student_object(command);
    const std::string ending = "/" + topic + ".cpp.o";
    if (!object.ends_with(ending)) return false;
    found = {command, object};
    return true;
}

std::string with_other_files(const Compilation& original, const std::string& source,
                             const std::string& object)
{
    std::string command = original.command.substr(0, original.command.find(" -c "));
    replace_all(command, original.object, object);
    return command + " -c " + shell_quoted(source);
}

// The objects and libraries of this build in a link command, without those of the system.
std::vector<std::string> link_inputs(const std::string& command)
{
    std::vector<std::string> result;
    std::istringstream words(command);
    for (std::string word; words >> word;) {
        const std::string ending = fs::path(word).extension().string();
        if (word[0] != '/' && word[0] != '-' && (ending == ".o" || ending == ".a"))
            result.push_back(word);
    }
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
}

void write_if_changed(const fs::path& file, const std::string& text)
{
    std::ifstream old(file);
    std::stringstream content;
    content << old.rdbuf();
    if (old && content.str() == text) return;
    fs::create_directories(file.parent_path());
    std::ofstream(file) << text;
}

// The rules of one private build, which grow topic by topic.
class Rules {
public:
    Rules(SubmissionBuild& build, std::vector<std::string> commands)
        : build_(build), commands_(std::move(commands)), link_(commands_.back())
    {
        text_ =
            fmt::format("builddir = {}\nrule run\n  command = $command\n  description = $what\n\n",
                        build.folder);
    }

    void compile(const std::string& topic, const fs::path& source)
    {
        Compilation original;
        const bool known =
            std::any_of(commands_.begin(), commands_.end(), [&](const std::string& command) {
                return compiles(command, topic, original);
            });
        if (!known)
            throw InputError("student/" + topic + ".cpp is missing: without it no " + topic +
                             ".cpp compiles");
        const std::string object = build_.folder + topic + ".o";
        const std::string command = with_other_files(original, source.string(), object);
        text_ += fmt::format(
            "build {0}: run {1}\n  command = {2}\n  what = Building {1}\n  depfile = {0}.d\n"
            "  deps = gcc\n\n",
            object, ninja_path(source.string()), ninja_value(command));
        replace_all(link_, original.object, object);
        build_.objects.push_back(object);
    }

    std::string linked(const std::string& original_output)
    {
        replace_all(link_, " -o " + original_output + " ", " -o " + build_.worker + " ");
        const std::vector<std::string> inputs = link_inputs(link_);
        for (const std::string& input : inputs)
            if (std::find(build_.objects.begin(), build_.objects.end(), input) ==
                build_.objects.end())
                build_.needed_targets.push_back(input);
        text_ += fmt::format("build {0}: run {1}\n  command = {2}\n  what = Linking {0}\n",
                             build_.worker, fmt::join(inputs, " "), ninja_value(link_));
        return text_;
    }

private:
    SubmissionBuild& build_;
    std::vector<std::string> commands_;
    std::string link_, text_;
};

} // namespace

SubmissionBuild prepare_submission_build(const fs::path& folder,
                                         const std::vector<std::string>& without)
{
    SubmissionBuild build;
    build.folder = fmt::format("submissions/{:016x}/", hash(folder.string()));
    build.ninja_file = build.folder + "build.ninja";
    build.worker = build.folder + "worker";
    Rules rules(build, ninja_commands("worker_student"));
    for (const std::string& topic : topics()) {
        const bool is_left_out = std::find(without.begin(), without.end(), topic) != without.end();
        if (!is_left_out && fs::exists(folder / (topic + ".cpp")))
            rules.compile(topic, folder / (topic + ".cpp"));
        else
            build.borrowed.push_back(topic);
    }
    if (build.borrowed.size() == topics().size())
        throw InputError(fmt::format("{}: expected some of {}.cpp, found none", folder.string(),
                                     fmt::join(topics(), ".cpp, ")));
    write_if_changed(places().build / build.ninja_file, rules.linked("bin/worker_student"));
    return build;
}

std::vector<std::string> student_objects()
{
    std::vector<std::string> result;
    for (const std::string& command : ninja_commands("worker_student"))
        if (const std::string object = student_object(command); !object.empty())
            result.push_back(object);
    return result;
}

} // namespace rigor
