// SPDX-License-Identifier: MIT
// A worker is the program that runs the formulas of one submission. Ninja first builds what a
// worker needs besides the submission's files. Then each file of the submission is compiled, and
// the objects are linked. If the link fails, objects are added one after the other, and those that
// make it fail are left out.
#include "grading/build/submission_build.hpp"

#include "errors/printable.hpp"
#include "grading/build/compiled_folder.hpp"
#include "grading/build/scratch_folder.hpp"
#include "grading/build/shown_errors.hpp"
#include "grading/build/write_file.hpp"
#include "grading/machine/tool_turn.hpp"
#include "grading/places.hpp"
#include "grading/process.hpp"
#include "grading/topics.hpp"

#include <algorithm>
#include <chrono>
#include <fmt/format.h>
#include <fstream>
#include <mutex>
#include <optional>
#include <set>
#include <stdexcept>

namespace rigor {

namespace fs = std::filesystem;

namespace {

using Clock = std::chrono::steady_clock;

// The linker names in the framework's objects and libraries, which are linked into each worker.
std::set<std::string> names_of_worker(const Toolchain& tools)
{
    Command command;
    command.arguments = {"/usr/bin/nm", "-P"};
    command.folder = places().build;
    command.arguments.insert(command.arguments.end(), tools.linked_inputs.begin(),
                             tools.linked_inputs.end());
    std::string listing;
    const Ended ended =
        rigor::run(command, [&](std::string_view line) { listing += std::string(line) + "\n"; });
    const ObjectSymbols symbols = parse_symbols(listing);
    if (!ended.ok() || symbols.undefined.empty())
        throw std::runtime_error("the names in the framework's part of a worker cannot be read");
    std::set<std::string> names = symbols.defined;
    names.insert(symbols.undefined.begin(), symbols.undefined.end());
    return names;
}

// The tools that build a worker. The first call in a process also builds what every worker needs:
// Eigen's precompiled header, the engine, and the program `confine`, which starts programs in a
// sandbox. It appends what it built to `steps`.
const Toolchain& tools_after_framework(const OnBuildStep& on_step, std::vector<std::string>& steps)
{
    static std::mutex guard;
    static std::optional<Toolchain> built;
    const std::lock_guard hold(guard);
    if (built) return *built;
    Toolchain tools = student_toolchain();
    const BuildLock lock;
    std::vector<std::string> targets = tools.linked_inputs;
    targets.insert(targets.end(), {"eigen_precompiled", "confine"});
    const NinjaRun run = run_ninja(targets, on_step);
    if (!run.ok) throw std::runtime_error("code of the framework does not compile:\n" + run.errors);
    steps = run.steps;
    tools.reserved = names_of_worker(tools);
    built = std::move(tools);
    return *built;
}

// The names in the linker's warnings, "mold: warning: undefined symbol: helper(double)".
std::vector<std::string> undefined_names(const std::string& output)
{
    std::vector<std::string> names;
    constexpr std::string_view words = "undefined symbol: ";
    for (std::size_t at = 0; (at = output.find(words, at)) != std::string::npos;) {
        at += words.size();
        names.push_back(output.substr(at, output.find('\n', at) - at));
    }
    std::sort(names.begin(), names.end());
    names.erase(std::unique(names.begin(), names.end()), names.end());
    return names;
}

// How a link ended.
struct Linked {
    std::string errors;                 // empty if there is a worker and it starts
    std::vector<std::string> undefined; // names that are used but defined nowhere
};

// The objects of a worker, by topic, and the folder that they are linked in.
class Link {
public:
    Link(const Toolchain& tools, fs::path folder) : tools_(tools), folder_(std::move(folder)) {}

    void add(const std::string& topic, const CompiledTopic& compiled)
    {
        objects_.insert_or_assign(topic, &compiled);
    }
    void remove(const std::string& topic) { objects_.erase(topic); }

    fs::path worker() const { return folder_ / "worker"; }

    // A hash of everything that is linked. If it has not changed, the worker is up to date.
    std::uint64_t key() const
    {
        std::uint64_t key = hash_of(fmt::format("{}", fmt::join(tools_.link, " ")));
        for (const auto& [topic, compiled] : objects_)
            key = hash_of(fmt::format("{} {:x};", topic, compiled->key), key);
        for (const fs::path& input : inputs())
            key = hash_of(fmt::format("{} {};", fs::file_size(input),
                                      fs::last_write_time(input).time_since_epoch().count()),
                          key);
        return key;
    }

    // Links all objects. Before that, in a copy of each object, the names that other objects must
    // not see are made local.
    Linked run() const
    {
        const fs::path out = folder_ / "out/link";
        const ScratchFolder scratch(out);
        ToolRun tool{tools_.link, out, inputs(), out, largest_worker(), link_limit};
        for (const auto& [topic, hidden] : hidden_names()) {
            fs::path object = objects_.at(topic)->object;
            if (!hidden.empty()) {
                const fs::path copy = out / (topic + ".o");
                const ConfinedRun copied = make_local(object, hidden, copy);
                if (!copied.ok()) return {shown_errors(copied.output), {}};
                object = copy;
            }
            tool.readable.push_back(object);
            tool.arguments.insert(tool.arguments.begin() + 1, object.string());
        }
        tool.arguments.insert(tool.arguments.end(), {"-o", (out / "worker").string()});
        const ConfinedRun linked = run_tool(tool);
        if (linked.ok() && is_plain_file(out / "worker")) {
            take_over(out / "worker", worker());
            return {why_it_does_not_start(worker()), undefined_names(printable(linked.output))};
        }
        const ToolLimit met = limit_met(linked, tool.time);
        if (met == ToolLimit::time)
            return {fmt::format("cannot be linked: took longer than {} s\n", link_limit), {}};
        if (met == ToolLimit::file_size)
            return {fmt::format("cannot be linked: expected a program of at most {} MB\n",
                                largest_worker() >> 20),
                    {}};
        return {"cannot be linked:\n" + shown_errors(linked.output), {}};
    }

private:
    std::vector<fs::path> inputs() const
    {
        std::vector<fs::path> result;
        for (const std::string& input : tools_.linked_inputs)
            result.push_back(places().build / input);
        return result;
    }

    // The limit on the size of a worker: the framework's part and some room for the submission
    // [bytes].
    std::uint64_t largest_worker() const
    {
        std::uint64_t size = 4 * largest_output;
        for (const fs::path& input : inputs())
            size += fs::file_size(input);
        return size;
    }

    std::map<std::string, std::vector<std::string>> hidden_names() const
    {
        std::map<std::string, ObjectSymbols> symbols;
        for (const auto& [topic, compiled] : objects_)
            symbols[topic] = compiled->symbols;
        std::map<std::string, std::vector<std::string>> hidden =
            names_to_hide(symbols, tools_.reserved);
        for (const auto& [topic, compiled] : objects_)
            hidden[topic]; // adds an empty entry if the object has no name to hide
        return hidden;
    }

    const Toolchain& tools_;
    fs::path folder_;
    std::map<std::string, const CompiledTopic*> objects_;
};

// Adds one object after the other. If the worker cannot be linked or started with an object, this
// object is left out.
Linked link_what_can_be(Link& link, const std::map<std::string, CompiledTopic>& compiled,
                        std::map<std::string, std::string>& broken)
{
    for (const auto& [topic, object] : compiled)
        link.remove(topic);
    if (const Linked nothing = link.run(); !nothing.errors.empty())
        throw std::runtime_error("a worker without formulas " + nothing.errors);
    for (const auto& [topic, object] : compiled) {
        link.add(topic, object);
        if (const Linked next = link.run(); !next.errors.empty()) {
            link.remove(topic);
            broken[topic] = topic + ".cpp: " + next.errors;
        }
    }
    return link.run();
}

void link_worker(Link& link, const fs::path& folder,
                 const std::map<std::string, CompiledTopic>& compiled, SubmissionBuild& build)
{
    const KeyFile key(folder / "worker.key");
    build.worker = link.worker();
    if (fs::exists(build.worker) && key.holds(link.key())) {
        build.undefined = key.lines();
        return;
    }
    fs::remove(key.file());
    build.steps.emplace_back("Linking worker");
    Linked linked = link.run();
    if (!linked.errors.empty()) linked = link_what_can_be(link, compiled, build.broken);
    build.undefined = std::move(linked.undefined);
    key.write(link.key(), build.undefined);
}

// Gives the objects of another folder a second name in the folder `into`, from where they are
// linked. This folder's lock must still be held: without it, another rigor may compile these files
// again, which removes the objects from their own place.
void keep_objects(std::map<std::string, CompiledTopic>& compiled, const fs::path& into)
{
    for (auto& [topic, object] : compiled) {
        if (!object.errors.empty()) continue;
        const fs::path kept = into / object.object.filename();
        std::error_code error; // some file systems have no hard links
        fs::create_hard_link(object.object, kept, error);
        if (error) write_copy(object.object, kept);
        object.object = kept;
    }
}

} // namespace

SubmissionBuild build_submission(const fs::path& folder, const OnBuildStep& on_step)
{
    const auto start = Clock::now();
    SubmissionBuild build;
    const Toolchain& tools = tools_after_framework(on_step, build.steps);

    CompiledFolder own(folder, tools);
    build.digest = own.digest();
    build.left_out = own.left_out();
    std::map<std::string, CompiledTopic> compiled = own.compile(topics(), on_step, build.steps);
    const fs::path student = places().source / "student";
    for (const std::string& topic : topics())
        if (!own.has(topic) && fs::exists(student / (topic + ".cpp")))
            build.borrowed.push_back(topic);
    const ScratchFolder lent(own.place() / "lent");
    if (!build.borrowed.empty()) {
        CompiledFolder lender(student, tools);
        std::map<std::string, CompiledTopic> objects =
            lender.compile(build.borrowed, on_step, build.steps);
        keep_objects(objects, lent.path());
        compiled.merge(objects);
    }
    for (const auto& [topic, object] : compiled)
        if (!object.errors.empty()) build.broken[topic] = object.errors;
    std::erase_if(compiled, [](const auto& entry) { return !entry.second.errors.empty(); });
    Link link(tools, own.place());
    for (const auto& [topic, object] : compiled)
        link.add(topic, object);
    link_worker(link, own.place(), compiled, build);
    if (!build.broken.empty()) own.require_untouched();
    build.seconds = std::chrono::duration<double>(Clock::now() - start).count();
    return build;
}

void prepare_submission_builds(const OnBuildStep& on_step)
{
    make_tool_turns();
    std::vector<std::string> steps, lent;
    const Toolchain& tools = tools_after_framework(on_step, steps);
    const fs::path student = places().source / "student";
    for (const std::string& topic : topics())
        if (fs::exists(student / (topic + ".cpp"))) lent.push_back(topic);
    if (!lent.empty()) CompiledFolder(student, tools).compile(lent, on_step, steps);
}

void remove_submission_build(const fs::path& folder)
{
    const fs::path place = CompiledFolder::place_of(folder), gone = place.string() + ".gone";
    std::error_code error;
    fs::remove_all(gone, error);
    // All files vanish at once, so that a build that fails for want of one finds the others gone.
    fs::rename(place, gone, error);
    fs::remove_all(place, error);
    fs::remove_all(gone, error);
}

} // namespace rigor
