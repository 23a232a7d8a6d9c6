// SPDX-License-Identifier: MIT
// Checks what it costs when a formula does not return, is slow, ends the program or crashes each
// time: only seconds, and only the tasks that call it. Time is processor time, summed over all
// processes, so that other load on the machine does not matter.
//
//     check_costs [KIND [TAG]]               all formulas, in all ways
//     check_costs --sample COUNT [SEED]      some of them, the same ones in every run
#include "formulas/table.hpp"
#include "grading/places.hpp"
#include "grading/run_tests.hpp"
#include "misbehaviour.hpp"
#include "support/temporary_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <random>
#include <set>
#include <stdexcept>
#include <sys/resource.h>
#include <unistd.h>

namespace {

using namespace rigor;
using namespace rigor::costs;
namespace fs = std::filesystem;

constexpr double most = 15; // more than the reference costs [s]

struct Way {
    std::string_view name;
    Kind kind;
};
constexpr Way ways[] = {{"ends", Kind::ends},
                        {"crashes", Kind::crashes},
                        {"loops", Kind::loops},
                        {"lingers", Kind::lingers}};

struct Case {
    Way way;
    unsigned formula;
};

// The program in which the formula of a case misbehaves.
fs::path program_for(const Case& one, const fs::path& folder)
{
    std::ifstream in(RIGOR_MISBEHAVING, std::ios::binary);
    std::string bytes(std::istreambuf_iterator<char>(in), {});
    const std::size_t at = bytes.find(std::string_view(mark, sizeof mark));
    if (at == std::string::npos ||
        bytes.find(std::string_view(mark, sizeof mark), at + 1) != std::string::npos)
        throw std::runtime_error(RIGOR_MISBEHAVING ": expected one place for the choice");
    const std::uint32_t words[] = {one.formula, static_cast<std::uint32_t>(one.way.kind)};
    bytes.replace(at + sizeof Choice::mark, sizeof words, reinterpret_cast<const char*>(words),
                  sizeof words);
    fs::path file = folder / "worker";
    std::ofstream(file, std::ios::binary | std::ios::trunc) << bytes;
    fs::permissions(file, fs::perms::owner_all | fs::perms::group_exec | fs::perms::others_exec);
    return file;
}

// The processor time of the processes that have ended [s].
double time_of_children()
{
    rusage used{};
    getrusage(RUSAGE_CHILDREN, &used);
    const auto seconds = [](const timeval& time) {
        return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    };
    return seconds(used.ru_utime) + seconds(used.ru_stime);
}

struct Graded {
    Result result;
    std::set<std::string> lost; // the tags of the tasks that did not get all points
    double time = 0;            // [s]
};

Graded graded(const Case& one, const Assignment& assignment, const GradingRun& run)
{
    const testing::TemporaryFolder folder;
    fs::permissions(folder.path(),
                    fs::perms::owner_all | fs::perms::group_exec | fs::perms::others_exec);
    Implementation implementation;
    implementation.name = one.way.name;
    implementation.worker = program_for(one, folder.path());
    Selection selection{assignment, {}};
    for (const Task& task : assignment.tasks)
        selection.tags.push_back(task.tag);
    Graded graded;
    const double start = time_of_children();
    graded.result = grade(selection, implementation, run);
    graded.time = time_of_children() - start;
    for (const TaskResult& task : graded.result.tasks)
        if (task.score < task.max_score) graded.lost.insert(task.task.tag);
    return graded;
}

// Grades the cases, and remembers the results that they are compared with.
class Judge {
public:
    Judge() : assignments_(load_assignments(RIGOR_ASSIGNMENTS_DIR))
    {
        run_.test_program = RIGOR_GRADED_TESTS;
        run_.oracle = places().program("worker_reference");
    }

    /// @return what was wrong; empty if nothing
    std::string fault_of(const Case& one)
    {
        const Formula& formula = formulas[one.formula];
        const auto assignment =
            std::find_if(assignments_.begin(), assignments_.end(),
                         [&](const Assignment& each) { return each.topic == formula.topic; });
        const Graded& right = kept({{"nothing", Kind::nothing}, 0}, *assignment);
        if (!right.lost.empty()) return "the reference lost points: " + *right.lost.begin();
        // A formula that ends the program costs each task that calls it, within milliseconds.
        const Graded& ended = kept({ways[0], one.formula}, *assignment);
        const Graded bad = one.way.kind == Kind::ends ? ended : graded(one, *assignment, run_);
        extra = bad.time - right.time;
        lost = bad.lost.size();
        if (bad.result.status != SubmissionStatus::graded) return bad.result.message;
        for (const TaskResult& task : bad.result.tasks)
            if (task.tests.empty()) return task.task.tag + " was not judged";
        if (!ended.lost.count(std::string(formula.tag))) return "its own task was passed";
        for (const std::string& tag : bad.lost)
            if (!ended.lost.count(tag)) return fmt::format("{} was lost too", tag);
        if (one.way.kind != Kind::lingers && bad.lost != ended.lost)
            return "some task passed that calls it";
        if (extra > most) return fmt::format("it cost {:.1f} s more than the reference", extra);
        return "";
    }

    double extra = 0;     // the time of the last case, beyond the reference's [s]
    std::size_t lost = 0; // the number of tasks that it cost

private:
    const Graded& kept(const Case& one, const Assignment& assignment)
    {
        auto& place = kept_[fmt::format("{} {} {}", assignment.name, one.way.name, one.formula)];
        if (place.result.tasks.empty()) place = graded(one, assignment, run_);
        return place;
    }

    std::vector<Assignment> assignments_;
    GradingRun run_;
    std::map<std::string, Graded> kept_;
};

std::vector<Case> chosen(const std::vector<std::string>& arguments)
{
    std::vector<Case> cases;
    const bool is_sample = !arguments.empty() && arguments[0] == "--sample";
    for (const Way& way : ways)
        for (unsigned i = 0; i < formula_count; ++i)
            if (is_sample || ((arguments.empty() || arguments[0] == way.name) &&
                              (arguments.size() < 2 || arguments[1] == formulas[i].tag)))
                cases.push_back({way, i});
    if (is_sample) {
        std::mt19937 random(arguments.size() > 2 ? std::stoul(arguments[2]) : 1);
        std::shuffle(cases.begin(), cases.end(), random);
        cases.resize(std::min<std::size_t>(cases.size(), std::stoul(arguments.at(1))));
    }
    if (cases.empty())
        throw std::invalid_argument("expected ends, crashes, loops or lingers, and the tag of a "
                                    "formula: none is so called");
    return cases;
}

int check(const std::vector<std::string>& arguments)
{
    Judge judge;
    int faults = 0;
    double worst = 0;
    std::string worst_name;
    const std::vector<Case> cases = chosen(arguments);
    for (const Case& one : cases) {
        const std::string fault = judge.fault_of(one);
        const std::string name = fmt::format("{} {} {}", formulas[one.formula].tag,
                                             formulas[one.formula].name, one.way.name);
        if (judge.extra > worst) worst_name = name;
        worst = std::max(worst, judge.extra);
        faults += !fault.empty();
        fmt::print("{}: {:.1f} s, {} tasks lost{}{}\n", name, judge.extra, judge.lost,
                   fault.empty() ? "" : ": ", fault.substr(0, 300));
        std::fflush(stdout);
    }
    fmt::print(
        "{} cases, {} of them cost too much or too many tasks; the dearest cost {:.1f} s more "
        "than the reference: {}\n",
        cases.size(), faults, worst, worst_name);
    return faults == 0 ? 0 : 1;
}

} // namespace

int main(int argc, char** argv)
{
    try {
        return check({argv + 1, argv + argc});
    } catch (const std::exception& exception) {
        fmt::print(stderr, "check_costs: {}\n", exception.what());
        return 2;
    }
}
