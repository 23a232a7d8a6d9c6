// SPDX-License-Identifier: MIT
// Compiles the files of a folder in a private folder, and keeps the objects. The private folder has
// a subfolder `files` with the copies that the compiler reads, and a subfolder `out` in which
// compiler and linker write. It also has the object files, each with a key file. The key file lists
// the names that the object defines and uses.
#include "grading/build/compiled_folder.hpp"

#include "errors/input_error.hpp"
#include "errors/printable.hpp"
#include "grading/build/includes.hpp"
#include "grading/build/lines.hpp"
#include "grading/build/scratch_folder.hpp"
#include "grading/build/shown_errors.hpp"
#include "grading/build/write_file.hpp"
#include "grading/machine/allotment.hpp"
#include "grading/machine/tool_turn.hpp"
#include "grading/topics.hpp"
#include "sandbox/blocked_calls.hpp"

#include <algorithm>
#include <atomic>
#include <fmt/format.h>
#include <fstream>
#include <future>
#include <mutex>

namespace rigor {

namespace fs = std::filesystem;

namespace {

std::string content_of(const fs::path& file)
{
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

fs::path contract()
{
    return places().source / "framework/formulas";
}

// A hash of the headers in framework/formulas and of no_file_queries.hpp, and of the time when the
// precompiled header was made.
std::uint64_t hash_of_contract(const Toolchain& tools)
{
    std::vector<fs::path> headers;
    for (const auto& entry : fs::directory_iterator(contract()))
        headers.push_back(entry.path());
    std::sort(headers.begin(), headers.end());
    std::uint64_t hash = hash_of("");
    headers.push_back(no_file_queries());
    for (const fs::path& header : headers)
        hash = hash_of(header.filename().string() + content_of(header), hash);
    for (const auto& entry : fs::directory_iterator(tools.precompiled))
        if (entry.path().filename().string().starts_with("cmake_pch.hxx."))
            hash = hash_of(fmt::format("{}", entry.last_write_time().time_since_epoch().count()),
                           hash);
    return hash;
}

// A hash of the names and contents of all files in a folder and below, continued from `hash`.
std::uint64_t hash_of_files(const fs::path& folder, std::uint64_t hash)
{
    std::vector<fs::path> files;
    std::error_code error; // a folder that is gone counts as empty
    for (fs::recursive_directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error))
        if (is_plain_file(entry->path())) files.push_back(entry->path());
    std::sort(files.begin(), files.end());
    for (const fs::path& file : files)
        hash = hash_of(file.string() + '\0' + content_of(file) + '\0', hash);
    return hash;
}

fs::path made(const fs::path& folder)
{
    fs::create_directories(folder);
    return folder;
}

std::string why_it_ended(const ConfinedRun& run, const std::string& file)
{
    const ToolLimit met = limit_met(run, compile_limit);
    if (met == ToolLimit::time)
        return fmt::format("{}: took longer than {} s to compile\n", file, compile_limit);
    if (run.blocked_call)
        return fmt::format("{}: the compiler tried to {}\n", file,
                           words_for_blocked_call(*run.blocked_call));
    if (met == ToolLimit::memory)
        return fmt::format(
            "{}: the compiler needs more than {} MB of memory: look for a huge table "
            "or a template or macro that grows\n",
            file, own_tool_share().memory >> 20);
    if (met == ToolLimit::file_size)
        return fmt::format("{}: expected an object of at most {} MB\n", file, largest_output >> 20);
    std::string errors = shown_errors(run.output);
    if (run.flooded) errors += "(there are more messages than anyone reads)\n";
    if (run.signal != 0)
        errors += fmt::format("{}: the compiler was ended by signal {}\n", file, run.signal);
    return errors.empty() ? file + ": does not compile\n" : errors;
}

// Makes inline functions and templates private to an object: two topics may define a helper of the
// same name in two ways, and the linker would take one of them for both. @return the new object,
// beside the old one; empty if this fails
fs::path own_copies(const fs::path& object, const std::vector<std::string>& shared)
{
    if (shared.empty()) return object;
    const fs::path out = object.parent_path(), single = out / "single.o", own = out / "own.o";
    // Without groups the linker has no reason to leave out what another object has too.
    const ConfinedRun ungrouped =
        run_tool({{"/usr/bin/ld.bfd", "-r", "--force-group-allocation", "-o", single, object},
                  out,
                  {out},
                  out});
    if (!ungrouped.ok() || !make_local(single, shared, own).ok()) return {};
    return own;
}

} // namespace

bool KeyFile::holds(std::uint64_t key) const
{
    std::ifstream in(file_);
    std::string line;
    return std::getline(in, line) && line == fmt::format("{:016x}", key);
}

std::vector<std::string> KeyFile::lines() const
{
    std::vector<std::string> lines = lines_of(content_of(file_));
    if (!lines.empty()) lines.erase(lines.begin());
    return lines;
}

void KeyFile::write(std::uint64_t key, const std::vector<std::string>& lines) const
{
    std::string text = fmt::format("{:016x}\n", key);
    for (const std::string& line : lines)
        text += line + '\n';
    const fs::path draft = file_.string() + ".new";
    write_file(draft, text);
    fs::rename(draft, file_);
}

fs::path CompiledFolder::place_of(const fs::path& folder)
{
    const bool is_student = folder == places().source / "student";
    return places().build / "submissions" /
           (is_student ? "student" : fmt::format("{:016x}", hash_of(folder.string())));
}

CompiledFolder::CompiledFolder(const fs::path& folder, const Toolchain& tools)
    : tools_(tools), place_(made(place_of(folder))), lock_(place_),
      files_(take_files(folder, place_ / "files")),
      surroundings_(hash_of(fmt::format("{} {:x}", fmt::join(tools.compile, " "), files_.hash),
                            hash_of_contract(tools))),
      inputs_(hash_of_inputs())
{
    if (files_.topics.empty() && files_.refused.empty())
        throw InputError(fmt::format("{}: expected some of {}.cpp, found none", folder.string(),
                                     fmt::join(topics(), ".cpp, ")));
}

std::uint64_t CompiledFolder::hash_of_inputs() const
{
    return hash_of_files(place_ / "files", hash_of_contract(tools_));
}

void CompiledFolder::require_untouched() const
{
    if (hash_of_inputs() == inputs_) return;
    throw std::runtime_error("somebody has removed or changed files while they were compiled: " +
                             (place_ / "files").string());
}

bool CompiledFolder::has(const std::string& topic) const
{
    return files_.refused.count(topic) > 0 ||
           std::find(files_.topics.begin(), files_.topics.end(), topic) != files_.topics.end();
}

fs::path CompiledFolder::object_of(const std::string& topic) const
{
    return place_ / (topic + ".o");
}

KeyFile CompiledFolder::key_of(const std::string& topic) const
{
    return KeyFile(place_ / (topic + ".key"));
}

// The key of an object whose file includes another topic's file, from the key that it would have
// otherwise. It changes with every file.
std::uint64_t CompiledFolder::key_with_others(std::uint64_t key) const
{
    return hash_of(files_.digest, key);
}

// The names of all topics' files but one.
std::vector<std::string> CompiledFolder::files_beside(const std::string& topic) const
{
    std::vector<std::string> names;
    for (const std::string& other : files_.topics)
        if (other != topic) names.push_back(other + ".cpp");
    return names;
}

// The object that an earlier run compiled. Its `errors` are not empty if there is no such object or
// if it is out of date.
CompiledTopic CompiledFolder::up_to_date(const std::string& topic) const
{
    CompiledTopic compiled{object_of(topic), {}, 0, "out of date"};
    compiled.key = hash_of(content_of(place_ / "files" / (topic + ".cpp")), surroundings_);
    const KeyFile key = key_of(topic);
    const bool has_others = key.holds(key_with_others(compiled.key));
    if (!fs::exists(compiled.object) || (!has_others && !key.holds(compiled.key))) return compiled;
    if (has_others) compiled.key = key_with_others(compiled.key);
    compiled.symbols = parse_symbols(fmt::format("{}", fmt::join(key.lines(), "\n")));
    compiled.errors.clear();
    return compiled;
}

void CompiledFolder::compile_topic(const std::string& topic, CompiledTopic& compiled) const
{
    const std::string file = topic + ".cpp";
    const fs::path out = place_ / "out" / topic, object = out / (topic + ".o"),
                   list = out / (topic + ".d");
    fs::remove(key_of(topic).file());
    fs::remove(compiled.object);
    const ScratchFolder scratch(out);
    ToolRun compiler{
        tools_.compile, place_ / "files", {contract(), tools_.precompiled, no_file_queries()}, out};
    compiler.readable.push_back(compiler.folder);
    compiler.arguments.insert(compiler.arguments.end(),
                              {"-MD", "-MF", list.string(), "-o", object.string(), "-c", file});
    const ConfinedRun run = run_tool(compiler);
    if (run.ok() && (!is_plain_file(object) || !is_plain_file(list)))
        compiled.errors = file + ": the compiler made no object\n";
    else if (run.ok())
        compiled.errors = forbidden_include(list, compiler.folder);
    else
        compiled.errors = why_it_ended(run, file);
    if (!compiled.errors.empty()) return;
    const ConfinedRun names = run_tool({{"/usr/bin/nm", "-P", object.string()}, out, {out}, out});
    if (!names.ok()) {
        compiled.errors = file + ": its object cannot be read\n" + shown_errors(names.output);
        return;
    }
    if (names.output.size() >= RunLimits().output_kept) { // the list of names is incomplete
        compiled.errors = file + ": expected fewer or shorter names for the linker\n";
        return;
    }
    if (const std::string line = line_with_unreadable_name(names.output); !line.empty()) {
        compiled.errors = fmt::format("{}: invalid character in a name for the linker: {:.80}\n",
                                      file, printable(line));
        return;
    }
    compiled.symbols = parse_symbols(names.output);
    const fs::path own = own_copies(object, compiled.symbols.shared);
    if (own.empty()) {
        compiled.errors = file + ": its inline functions cannot be kept apart from other files'\n";
        return;
    }
    if (includes_one_of(files_beside(topic), list, compiler.folder))
        compiled.key = key_with_others(compiled.key);
    take_over(own, compiled.object);
    key_of(topic).write(compiled.key, lines_of(names.output));
}

std::map<std::string, CompiledTopic> CompiledFolder::compile(const std::vector<std::string>& wanted,
                                                             const OnBuildStep& on_step,
                                                             std::vector<std::string>& steps)
{
    std::map<std::string, CompiledTopic> all;
    std::vector<std::pair<const std::string, CompiledTopic>*> stale;
    for (const std::string& topic : wanted) {
        if (files_.refused.count(topic)) {
            all[topic].errors = files_.refused.at(topic);
        } else if (has(topic)) {
            const auto entry = all.emplace(topic, up_to_date(topic)).first;
            if (!entry->second.errors.empty()) stale.push_back(&*entry);
        }
    }
    std::atomic<std::size_t> next = 0;
    std::mutex guard; // protects `steps` and lets only one thread at a time call `on_step`
    const int count = static_cast<int>(steps.size() + stale.size());
    const auto work = [&] {
        for (std::size_t i; (i = next++) < stale.size();) {
            compile_topic(stale[i]->first, stale[i]->second);
            const std::lock_guard hold(guard);
            steps.push_back("Building " + stale[i]->first + ".cpp");
            if (on_step) on_step(static_cast<int>(steps.size()), count, steps.back());
        }
    };
    const std::size_t hands = std::min(usable_processors(), 8u);
    std::vector<std::future<void>> others;
    for (std::size_t i = 1; i < std::min(hands, stale.size()); ++i)
        others.push_back(std::async(std::launch::async, work));
    work();
    for (std::future<void>& other : others)
        other.get();
    if (std::any_of(stale.begin(), stale.end(),
                    [](const auto* entry) { return !entry->second.errors.empty(); }))
        require_untouched();
    return all;
}

} // namespace rigor
