// SPDX-License-Identifier: MIT
// Grades the corpus of hostile submissions as `rigor grade` grades a class. Each gets the points
// and the message that it may get and leaves nothing behind, and a right and a wrong submission get
// the same points after it as before.
//
//     check_corpus [NAME...]              all of them, or these: kernel/socket@rotation
//     check_corpus --sample COUNT SEED    this number of them, which the seed draws
//     check_corpus --part K N             part K of N, from 0
//     check_corpus --topics SEED          one of each kind in another topic, which the seed draws
//
// RIGOR_TIER and RIGOR_COMPILER choose the tier of the sandbox and the compiler of submissions.
#include "corpus.hpp"
#include "errors/utf8.hpp"
#include "grading/build/submission_build.hpp"
#include "grading/build/toolchain.hpp"
#include "grading/class/graded_submission.hpp"
#include "grading/class/isolated.hpp"
#include "grading/places.hpp"
#include "leftovers.hpp"
#include "report/exports/gradebook.hpp"
#include "report/exports/learning_systems.hpp"
#include "sandbox/tier.hpp"
#include "support/temporary_folder.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <map>
#include <random>
#include <sstream>
#include <stdexcept>
#include <unistd.h>

namespace {

using namespace rigor;
using namespace rigor::corpus;
namespace fs = std::filesystem;
using Json = nlohmann::json;
using Clock = std::chrono::steady_clock;

// A fixed secret, so that each run of this program is the same.
constexpr const char* secret = "the secret of the corpus, which no submission knows";
constexpr std::chrono::seconds longest(400); // for one submission: compilers run into their limits
constexpr std::size_t lanes = 2;

struct Corpus {
    std::vector<Assignment> assignments;
    GradingRun run;
    std::vector<HostileSubmission> all;

    Selection selection_of(const HostileSubmission& hostile) const
    {
        const auto& tasks = hostile.tasks;
        return select_tasks(assignments, tasks.empty() ? std::vector{hostile.topic} : tasks).at(0);
    }
};

std::string text_of(const fs::path& file)
{
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

bool contains(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}

// What is wrong with a text that people read: control characters, or paths of this machine.
std::string fault_of_text(const std::string& name, const std::string& text)
{
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        std::replace(line.begin(), line.end(), '\t', ' ');
        if (line.ends_with('\r')) line.pop_back();
        if (!is_plain_utf8(line)) return name + " has control characters: " + line;
    }
    for (const fs::path& path : {places().source, places().build})
        if (contains(text, path.string())) return name + " names a folder of ours";
    if (contains(text, "/cc") || contains(text, ".s:")) return name + " names a temporary file";
    return "";
}

// What is wrong with the table of points in a report: it has each task once, with its points.
std::string fault_of_report(const std::string& report, const Json& tasks)
{
    std::map<std::string, int> rows;
    std::istringstream lines(report);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string tag, formula, score;
        words >> tag >> formula >> score;
        for (const Json& task : tasks) {
            if (tag != task.at("tag") || formula != task.at("name") || !contains(score, "/"))
                continue;
            if (++rows[tag] > 1) return "the report has a forged row: " + line;
            if (score.substr(0, score.find('/')) !=
                fmt::format("{}", task.at("score").get<double>()))
                return "the report has other points: " + line;
        }
    }
    return "";
}

// What is wrong with the tables of points: a cell that a spreadsheet would run as a formula.
std::string fault_of_tables(const Row& row)
{
    for (const std::string& table : {gradebook_csv({row}), canvas_grades({row}, "A0").csv}) {
        std::istringstream lines(table);
        for (std::string line; std::getline(lines, line);)
            for (const char* start : {"=", "@", "\uFF1D", "\u00A0@", "\"=", ",="})
                if (line.starts_with(start) || contains(line, ",=")) return "a cell runs: " + line;
    }
    return "";
}

// How a submission, or one of its tasks, ended.
struct Ending {
    std::string status, message;
};

std::string text_in(const Json& value)
{
    return value.is_string() ? value.get<std::string>() : "";
}

std::vector<Ending> endings_of(const Json& result)
{
    if (result.at("status") != "graded")
        return {{result.at("status"), text_in(result.at("message"))}};
    std::vector<Ending> endings;
    for (const Json& task : result.at("tests"))
        endings.push_back({task.at("status"), text_in(task.at("detail"))});
    return endings;
}

std::string fault_of(const Expectation& expected, double points, const std::vector<Ending>& endings)
{
    const auto& statuses = expected.statuses;
    std::string found = fmt::format("found {} points", points);
    bool is_passed = true, has_text = false;
    for (const auto& [status, message] : endings) {
        found += fmt::format(", {}: {:.160}", status, message);
        is_passed = is_passed && status == "passed";
        has_text = has_text || contains(message, expected.text);
    }
    for (const auto& [status, message] : endings) {
        if (std::find(statuses.begin(), statuses.end(), status) == statuses.end())
            return fmt::format("expected {}, {}", fmt::join(statuses, " or "), found);
        if (status != "passed" && message.empty()) return "nobody is told why";
    }
    if (!has_text && !(is_passed && expected.may_pass()))
        return fmt::format("expected a message with '{}', {}", expected.text, found);
    if (points != expected.points && !expected.may_pass())
        return fmt::format("expected {} points, {}", expected.points, found);
    return "";
}

std::string fault_of(const Expectation& expected, const ResultFiles& files)
{
    const Json result = Json::parse(files.at("result.json"));
    const std::vector<Ending> endings = endings_of(result);
    if (std::string fault = fault_of(expected, result.at("score"), endings); !fault.empty())
        return fault;
    for (const auto& [name, text] : files)
        if (std::string fault = fault_of_text(name, text); !fault.empty()) return fault;
    if (std::string fault = fault_of_report(files.at("report.txt"), result.at("tests"));
        !fault.empty())
        return fault;
    const std::optional<Row> row = read_row(files.at("result.json"));
    return row ? fault_of_tables(*row) : "result.json is no result";
}

// A right and a wrong submission.
class Controls {
public:
    explicit Controls(const Corpus& corpus) : corpus_(corpus)
    {
        const std::string right = text_of(fs::path(RIGOR_SOURCE_DIR) / "reference/pipeline.cpp");
        std::string wrong = right;
        const std::size_t at = wrong.find("return 0.5");
        if (at == std::string::npos) throw std::logic_error("the reference has another form");
        wrong.replace(at, 10, "return 0.6");
        right_.write("pipeline.cpp", right);
        wrong_.write("pipeline.cpp", wrong);
    }
    ~Controls()
    {
        for (const auto* folder : {&right_, &wrong_})
            remove_submission_build(folder->path());
    }

    std::string fault() const
    {
        for (const auto* folder : {&right_, &wrong_}) {
            const Implementation control = build_implementation(folder->path());
            const Result result =
                grade(select_tasks(corpus_.assignments, {"a0"}).at(0), control, corpus_.run);
            const double expected = folder == &right_ ? 1 : 0;
            if (result.status != SubmissionStatus::graded || result.score() != expected)
                return fmt::format("a control got {} points, expected {}: {}", result.score(),
                                   expected, result.message);
        }
        return "";
    }

private:
    const Corpus& corpus_;
    testing::TemporaryFolder right_, wrong_;
};

// Grades one submission as a class of one, in a process of its own.
std::string fault_of(const Corpus& corpus, const HostileSubmission& hostile)
{
    const testing::TemporaryFolder handed_in, place;
    const FoundSubmissions found =
        find_submissions({hostile.write(handed_in.path()).string()}, hostile.topic + ".cpp", {});
    if (found.submissions.size() != 1) return "expected one submission";
    const Selection selection = corpus.selection_of(hostile);
    std::optional<WorkDone> done;
    run_isolated(
        1, {1, false, longest},
        [&](std::size_t) {
            return packed(graded_submission(selection, found.submissions[0], corpus.run,
                                            place.path(), "fingerprint"));
        },
        [&](const WorkDone& ended) { done = ended; });
    remove_submission_build(place.path());
    if (!done->text) return "the grader failed: " + done->fault;
    if (std::string fault = fault_of(hostile.expected, unpacked(*done->text)); !fault.empty())
        return fault;
    const std::string left = leftovers();
    return left.empty() ? "" : "it left " + left;
}

// Grades every second submission. @return a line for each fault, and how long each submission took
// [s], as JSON
std::string report_of_lane(const Corpus& corpus, std::size_t lane)
{
    adopt_orphans();
    std::string faults;
    Json seconds = Json::object();
    const Controls controls(corpus);
    if (const std::string fault = controls.fault(); !fault.empty())
        return Json{{"faults", fault + "\n"}, {"seconds", seconds}}.dump();
    for (std::size_t i = lane; i < corpus.all.size(); i += lanes) {
        const HostileSubmission& hostile = corpus.all[i];
        const auto start = Clock::now();
        std::string fault = fault_of(corpus, hostile);
        if (fault.empty()) fault = controls.fault();
        seconds[hostile.name] = std::chrono::duration<double>(Clock::now() - start).count();
        if (!fault.empty())
            faults += fmt::format("{} ({:.1f} s): {}\n", hostile.name,
                                  seconds[hostile.name].get<double>(), fault);
    }
    if (const std::string fault = Controls(corpus).fault(); !fault.empty()) faults += fault + "\n";
    return Json{{"faults", faults}, {"seconds", seconds}}.dump(-1, ' ', false,
                                                               Json::error_handler_t::replace);
}

// The submissions that took longest, in one line.
std::string slowest_of(const std::map<std::string, double>& seconds)
{
    std::vector<std::pair<double, std::string>> order;
    for (const auto& [name, time] : seconds)
        order.emplace_back(-time, name);
    std::sort(order.begin(), order.end());
    constexpr std::size_t shown = 12;
    order.resize(std::min(order.size(), shown));
    std::string text = "longest:";
    for (const auto& [time, name] : order)
        text += fmt::format(" {} {:.0f} s,", name, -time);
    text.back() = '\n';
    return text;
}

// All submissions that can be asked for: the corpus, and its attacks on A0 in other topics.
struct Choice {
    std::vector<HostileSubmission> corpus, elsewhere;
};

Choice all_submissions()
{
    const fs::path submissions = fs::path(RIGOR_SOURCE_DIR) / "tests/attacks/submissions";
    Choice all = {hostile_sources(submissions), in_other_topics(submissions)};
    const std::string solution = text_of(fs::path(RIGOR_SOURCE_DIR) / "reference/pipeline.cpp");
    for (const HostileSubmission& hostile : hostile_intakes(solution))
        all.corpus.push_back(hostile);
    return all;
}

std::vector<HostileSubmission> sample(std::vector<HostileSubmission> all, std::size_t count,
                                      unsigned seed)
{
    std::mt19937 random(seed);
    for (std::size_t i = all.size(); i > 1; --i) // Fisher and Yates
        std::swap(all[i - 1], all[random() % i]);
    all.resize(std::min(all.size(), count));
    return all;
}

// Every nth submission, so that each part has some of each kind.
std::vector<HostileSubmission> part(const std::vector<HostileSubmission>& all, unsigned k,
                                    unsigned n)
{
    if (k >= n) throw std::invalid_argument("expected a part below their number");
    std::vector<HostileSubmission> some;
    for (std::size_t i = k; i < all.size(); i += n)
        some.push_back(all[i]);
    return some;
}

std::vector<HostileSubmission> chosen(Choice all, const std::vector<std::string>& arguments)
{
    const auto number = [&](std::size_t i) {
        return static_cast<unsigned>(std::stoul(arguments.at(i)));
    };
    if (!arguments.empty() && arguments[0] == "--sample")
        return sample(std::move(all.corpus), number(1), number(2));
    if (!arguments.empty() && arguments[0] == "--topics")
        return drawn_of_each_kind(all.elsewhere, number(1));
    if (arguments.empty() || arguments[0] == "--part") {
        for (const HostileSubmission& drawn : drawn_of_each_kind(all.elsewhere, 1))
            all.corpus.push_back(drawn);
        return arguments.empty() ? all.corpus : part(all.corpus, number(1), number(2));
    }
    std::vector<HostileSubmission> named;
    for (const auto* some : {&all.corpus, &all.elsewhere})
        for (const HostileSubmission& each : *some)
            if (std::find(arguments.begin(), arguments.end(), each.name) != arguments.end())
                named.push_back(each);
    if (named.empty()) throw std::invalid_argument("expected a submission: none is so called");
    return named;
}

int check(const std::vector<std::string>& arguments)
{
    Corpus corpus;
    corpus.assignments = load_assignments(places().assignments());
    corpus.run.test_program = RIGOR_GRADED_TESTS;
    corpus.run.oracle = places().program("worker_reference");
    corpus.run.secret = secret;
    corpus.all = chosen(all_submissions(), arguments);
    fmt::print("{} hostile submissions, graded by {}, compiled by {}, walls {}\n",
               corpus.all.size(), geteuid() == 0 ? "root" : "an ordinary user",
               student_toolchain().compile.at(0), description(usual_tier()));
    std::fflush(stdout);
    prepare_submission_builds({});
    const auto start = Clock::now();
    std::string faults;
    std::map<std::string, double> seconds;
    run_isolated(
        lanes, {lanes}, [&](std::size_t lane) { return report_of_lane(corpus, lane); },
        [&](const WorkDone& done) {
            if (!done.text) {
                faults += done.fault + "\n";
                return;
            }
            const Json report = Json::parse(*done.text);
            faults += report.at("faults").get<std::string>();
            seconds.merge(report.at("seconds").get<std::map<std::string, double>>());
        });
    const std::chrono::duration<double> all = Clock::now() - start;
    fmt::print("{}{}{} hostile submissions graded in {:.0f} s, {}\n", faults, slowest_of(seconds),
               corpus.all.size(), all.count(), faults.empty() ? "as expected" : "not as expected");
    return faults.empty() ? 0 : 1;
}

} // namespace

int main(int argc, char** argv)
{
    try {
        return check({argv + 1, argv + argc});
    } catch (const std::exception& exception) {
        fmt::print(stderr, "check_corpus: {}\n", exception.what());
        return 2;
    }
}
