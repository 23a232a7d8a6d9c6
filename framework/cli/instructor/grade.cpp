// SPDX-License-Identifier: MIT
#include "cli/instructor/grade.hpp"

#include "cli/instructor/class_work.hpp"
#include "cli/options.hpp"
#include "cli/progress.hpp"
#include "cli/secret.hpp"
#include "errors/input_error.hpp"
#include "errors/quotes.hpp"
#include "grading/class/class_folder.hpp"
#include "grading/class/grade_class.hpp"
#include "grading/class/local_engine.hpp"
#include "grading/class/slurm/slurm_engine.hpp"
#include "grading/intake/found_submissions.hpp"
#include "grading/places.hpp"
#include "report/exports/gradebook.hpp"
#include "report/exports/learning_systems.hpp"
#include "report/write_whole.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fmt/format.h>
#include <thread>

namespace rigor {

namespace {

namespace fs = std::filesystem;

struct GradeOptions {
    std::string assignment, out, secret, engine = "local";
    std::vector<std::string> submissions;
    std::uint32_t jobs = 0, seed = 0, chunk = 0;
};

// The names of the files that are written beside the submissions' folders.
constexpr const char *gradebook_file = "gradebook.csv", *summary_file = "summary.txt",
                     *canvas_file = "canvas.csv", *moodle_file = "moodle.csv";

unsigned jobs_of(const GradeOptions& options)
{
    constexpr unsigned most = 256;
    if (options.jobs > most)
        throw InputError(fmt::format("--jobs: expected at most {}, found {}", most, options.jobs));
    return options.jobs > 0 ? options.jobs : std::max(1u, std::thread::hardware_concurrency());
}

// Results among the submissions would be taken for a submission in the next run.
void require_outside(const fs::path& out, const std::vector<std::string>& submissions)
{
    const std::string whole = fs::weakly_canonical(out).string() + "/";
    for (const std::string& path : submissions) {
        std::error_code error;
        const std::string folder = fs::canonical(path, error).string() + "/";
        if (!error && whole != folder && whole.starts_with(folder))
            throw InputError(fmt::format("--out: expected a folder outside of {}, found {}", path,
                                         out.string()));
    }
}

std::vector<std::string> names_of(const std::vector<Submission>& submissions)
{
    std::vector<std::string> names;
    names.reserve(submissions.size());
    for (const Submission& submission : submissions)
        names.push_back(submission.name);
    return names;
}

// A duration as a person says it.
std::string in_words(double seconds)
{
    if (seconds < 90) return fmt::format("{:.0f} s", seconds);
    if (seconds < 5400) return fmt::format("{:.0f} min", seconds / 60);
    return fmt::format("{:.1f} h", seconds / 3600);
}

// The progress of a run with the time that is left, as far as it can be told.
class ClassProgress {
public:
    explicit ClassProgress(const std::string& title) : bar_(title) {}

    void update(std::size_t done, std::size_t total, const std::string& doing,
                const std::string& detail)
    {
        const Clock::time_point now = Clock::now();
        if (doing != doing_) {
            doing_ = doing;
            start_ = now;
            done_at_start_ = done;
        }
        std::string text = doing;
        if (doing == "grading" && total > 0) {
            text = fmt::format("{} of {}", done, total);
            const double seconds = std::chrono::duration<double>(now - start_).count();
            if (done > done_at_start_)
                text += fmt::format(", {} left",
                                    in_words(seconds / static_cast<double>(done - done_at_start_) *
                                             static_cast<double>(total - done)));
        }
        if (!detail.empty()) text += ", " + detail;
        bar_.update(
            static_cast<double>(done) / static_cast<double>(std::max<std::size_t>(total, 1)), text);
    }
    void clear() { bar_.clear(); }

private:
    using Clock = std::chrono::steady_clock;
    Progress bar_;
    std::string doing_;
    Clock::time_point start_;
    std::size_t done_at_start_ = 0;
};

void write_class_files(const fs::path& out, const std::vector<Row>& rows,
                       const Assignment& assignment)
{
    write_whole(out / summary_file, class_summary(rows));
    write_whole(out / canvas_file, canvas_csv(rows, assignment.title));
    write_whole(out / moodle_file, moodle_csv(rows));
    write_whole(out / gradebook_file, gradebook_csv(rows));
}

std::string points_in_words(const Row& row)
{
    return row.has_points()
               ? fmt::format("{}, {:g}/{:g} points", row.status, row.points, row.max_points)
               : row.status;
}

// Adds a submission to the list of changes if its points have changed.
void note_change(const Row& row, const std::optional<Row>& before,
                 std::vector<std::string>& changes)
{
    if (!before || points_in_words(*before) == points_in_words(row)) return;
    changes.push_back(fmt::format("  {}: {}; before: {}\n", row.submission, points_in_words(row),
                                  points_in_words(*before)));
}

int tell(const ClassOutcome& outcome, std::vector<std::string> changes, const std::string& out)
{
    fmt::print("{}", class_summary(outcome.rows));
    std::sort(changes.begin(), changes.end());
    if (!changes.empty()) fmt::print("\nnot as in the last run:\n{}", fmt::join(changes, ""));
    fmt::print("\n{} graded now, {} as before; {}/{} has the points, and each submission a folder "
               "with its report.txt\n",
               outcome.graded, outcome.rows.size() - outcome.graded, out, gradebook_file);
    const bool has_fault = std::any_of(outcome.rows.begin(), outcome.rows.end(),
                                       [](const Row& row) { return !row.has_points(); });
    return has_fault ? exit_fault : exit_done;
}

bool is_for_slurm(const GradeOptions& options)
{
    if (options.engine == "slurm") return true;
    if (options.engine != "local")
        throw InputError("--engine: expected local or slurm, found " + in_quotes(options.engine));
    if (options.chunk > 0) throw InputError("--chunk goes with --engine slurm");
    return false;
}

// @param on_note  called for what the user should know while Slurm works
std::unique_ptr<Engine> engine_for(const GradeOptions& options,
                                   const std::function<void(const std::string&)>& on_note)
{
    if (!is_for_slurm(options)) return std::make_unique<LocalEngine>(jobs_of(options));
    SlurmOptions slurm;
    slurm.task_command = {places().program("rigor").string(), "grade-chunk"};
    if (!options.secret.empty()) slurm.secret_file = fs::canonical(options.secret).string();
    if (options.chunk > 0) slurm.chunk = options.chunk;
    slurm.at_once = options.jobs;
    slurm.on_note = on_note;
    return std::make_unique<SlurmEngine>(slurm);
}

// @throws InputError for what is wrong with the options, before anything is done
void check_usage(const GradeOptions& options)
{
    if (options.submissions.empty())
        throw InputError("expected submissions: folders, archives, or a folder of them");
    if (options.out.empty()) throw InputError("expected --out DIR, the folder for the results");
    jobs_of(options);
    is_for_slurm(options);
    secret_in(options.secret);
    require_outside(options.out, options.submissions);
}

int grade(const GradeOptions& options)
{
    const Selection selection = whole_assignment(options.assignment);
    check_usage(options);
    ClassProgress progress("grading " + selection.assignment.label());
    const auto engine = engine_for(options, [&](const std::string& text) {
        progress.clear();
        fmt::print(stderr, "{}\n", text);
    });
    const FoundSubmissions found =
        find_submissions(options.submissions, selection.assignment.topic + ".cpp",
                         {gradebook_file, summary_file, canvas_file, moodle_file, ".rigor"});
    for (const std::string& note : found.notes)
        fmt::print(stderr, "{}\n", note);
    const ClassFolder folder(options.out, selection.assignment.name, names_of(found.submissions));

    ClassWork work = prepared_class_work(selection, options.seed, options.secret);
    work.submissions = found.submissions;
    std::vector<std::string> changes;
    ClassListener listener;
    listener.on_progress = [&](std::size_t done, std::size_t total, const std::string& doing,
                               const std::string& detail) {
        progress.update(done, total, doing, detail);
    };
    listener.on_row = [&](const Row& row, const std::optional<Row>& before) {
        note_change(row, before, changes);
    };
    const ClassOutcome outcome = grade_class(std::move(work), folder, *engine, listener);
    progress.clear();
    if (!outcome.control_fault.empty()) {
        fmt::print(stderr, "{}: the results of this run are not kept\n", outcome.control_fault);
        return exit_fault;
    }
    write_class_files(folder.path(), outcome.rows, selection.assignment);
    return tell(outcome, changes, options.out);
}

} // namespace

Action declare_grade(Options& options)
{
    const auto chosen = std::make_shared<GradeOptions>();
    options.word("ASSIGNMENT", chosen->assignment, "a4-collision, a4 or collision");
    options.words("SUBMISSION", chosen->submissions,
                  "Folders or archives (.zip, .tar, .tar.gz, ...), or a folder of them. A folder "
                  "is one submission if the assignment's file lies in it");
    options.option("--out", "DIR", chosen->out,
                   "Folder for the results: empty, new, or that of an earlier run, of which what "
                   "has not changed is kept");
    options.option("--jobs", "N", chosen->jobs,
                   "Submissions that are graded at the same time (as many as processors; with "
                   "Slurm as many as it gives)");
    options.option("--engine", "local|slurm", chosen->engine,
                   "Where: on this machine (local), or on the nodes of a Slurm cluster");
    options.option("--chunk", "N", chosen->chunk,
                   "With Slurm: submissions in each task of its job array (8)");
    options.option("--seed", "N", chosen->seed, "First seed of the random cases (0)");
    options.option("--secret", "FILE", chosen->secret,
                   "File with a secret, which draws other random cases for each submission");
    options.examples(
        {"grade a4 submissions --out grades       a folder of folders and archives",
         "grade a4 alice.zip bob/ --out grades    two submissions",
         "grade a4 submissions --out grades       again: only what is new or has changed",
         "grade a4 submissions --out grades --engine slurm   on a cluster"});
    return [chosen] { return grade(*chosen); };
}

} // namespace rigor
