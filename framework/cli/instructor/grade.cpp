// SPDX-License-Identifier: MIT
#include "cli/instructor/grade.hpp"

#include "cli/instructor/class_progress.hpp"
#include "cli/instructor/class_work.hpp"
#include "cli/options.hpp"
#include "cli/secret.hpp"
#include "errors/input_error.hpp"
#include "errors/quotes.hpp"
#include "grading/class/class_folder.hpp"
#include "grading/class/grade_class.hpp"
#include "grading/class/known_results.hpp"
#include "grading/class/local_engine.hpp"
#include "grading/class/slurm/slurm_engine.hpp"
#include "grading/intake/found_submissions.hpp"
#include "grading/machine/allotment.hpp"
#include "grading/places.hpp"
#include "report/exports/changes.hpp"
#include "report/exports/gradebook.hpp"
#include "report/exports/learning_systems.hpp"
#include "report/write_whole.hpp"

#include <algorithm>
#include <cstdio>
#include <fmt/format.h>
#include <set>

namespace rigor {

namespace {

namespace fs = std::filesystem;

struct GradeOptions {
    std::string assignment, out, secret, engine = "local";
    std::vector<std::string> submissions;
    std::uint32_t jobs = 0, seed = 0, chunk = 0;
    bool is_regrade = false, is_applied = false;
};

// Names of the files about the whole class, which are written beside the submissions' folders.
constexpr const char *gradebook_file = "gradebook.csv", *summary_file = "summary.txt",
                     *canvas_file = "canvas.csv", *moodle_file = "moodle.csv";

// The names that no folder of a submission may have: those of the files, also while these are being
// written, and that of the folder with the state of the run.
std::set<std::string> reserved_names()
{
    std::set<std::string> names = {".rigor"};
    for (const char* file : {gradebook_file, summary_file, canvas_file, moodle_file})
        names.insert({file, draft_of(file).string()});
    return names;
}

unsigned jobs_of(const GradeOptions& options)
{
    constexpr unsigned most = 256;
    if (options.jobs > most)
        throw InputError(fmt::format("--jobs: expected at most {}, found {}", most, options.jobs));
    return options.jobs > 0 ? options.jobs : usable_processors();
}

// Refuses a results folder that lies inside a folder of submissions: the next run would take the
// results for a submission.
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

int status_of(const ClassOutcome& outcome)
{
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

// @param on_note  called with messages for the user while Slurm works
std::unique_ptr<Engine> engine_for(const GradeOptions& options,
                                   const std::function<void(const std::string&)>& on_note)
{
    if (!is_for_slurm(options)) return std::make_unique<LocalEngine>(jobs_of(options));
    SlurmOptions slurm;
    slurm.task_command = {places().program("rigor_class").string(), "grade-chunk"};
    if (!options.secret.empty()) slurm.secret_file = fs::canonical(options.secret).string();
    if (options.chunk > 0) slurm.chunk = options.chunk;
    slurm.at_once = options.jobs;
    slurm.on_note = on_note;
    return std::make_unique<SlurmEngine>(slurm);
}

// Checks the options before anything is done. @throws InputError if an option is wrong
void check_usage(const GradeOptions& options)
{
    if (options.submissions.empty())
        throw InputError("expected submissions: folders, archives, or a folder of them");
    if (options.out.empty()) throw InputError("expected --out DIR, the folder for the results");
    if (options.is_applied && !options.is_regrade) throw InputError("--apply goes with --regrade");
    jobs_of(options);
    is_for_slurm(options);
    secret_in(options.secret);
    require_outside(options.out, options.submissions);
}

// One run of the command, from the submissions to the gradebook.
class Grading {
public:
    explicit Grading(const GradeOptions& options)
        : options_(options), selection_(whole_assignment(options.assignment)),
          progress_("grading " + selection_.assignment.label())
    {
    }

    int run()
    {
        check_usage(options_);
        engine_ = engine_for(options_, [&](const std::string& text) { say(text); });
        const FoundSubmissions found = find_submissions(
            options_.submissions, selection_.assignment.topic + ".cpp", reserved_names());
        for (const std::string& note : found.notes)
            say(note);
        const ClassFolder folder(options_.out, selection_.assignment.name,
                                 names_of(found.submissions));
        if (options_.is_regrade) require_gradebook(folder);
        work_ = prepared_class_work(selection_, options_.seed, options_.secret);
        work_.submissions = found.submissions;
        if (!options_.is_regrade) return grade(folder);
        const fs::path shown = folder.path() / ".rigor" / "regrade";
        return options_.is_applied ? apply(folder, shown) : show(folder, shown);
    }

private:
    void say(const std::string& text)
    {
        progress_.clear();
        fmt::print(stderr, "{}\n", text);
    }

    static void require_gradebook(const ClassFolder& folder)
    {
        if (!fs::exists(folder.path() / gradebook_file))
            throw InputError(fmt::format("--regrade: expected a folder with a {}, found none in "
                                         "{}: the class has not been graded to the end there",
                                         gradebook_file, folder.path().string()));
    }

    // Grades the class. For each graded submission that had a result in this folder before,
    // `changes_` gets what has changed.
    ClassOutcome graded(const ClassFolder& folder, Engine& engine, OldResults old)
    {
        ClassListener listener;
        listener.on_progress = [&](std::size_t done, std::size_t total, const std::string& doing,
                                   const std::string& detail) {
            progress_.update(done, total, doing, detail);
        };
        listener.on_kept = [&](std::size_t kept, std::size_t total) {
            say(fmt::format("{} of {} submissions have not changed: their results are kept", kept,
                            total));
        };
        listener.on_row = [&](const Row& row, const std::optional<Row>& before) {
            if (before) changes_.push_back(change_text(before, row));
        };
        ClassOutcome outcome = grade_class(work_, folder, engine, listener, old);
        progress_.clear();
        if (!outcome.control_fault.empty())
            say(outcome.control_fault + ": the results of this run are not kept");
        return outcome;
    }

    // While gradebook.csv does not exist, results that were made with other tests, points, seeds or
    // another sandbox are replaced without asking. Once it exists, such results are an error.
    int grade(const ClassFolder& folder)
    {
        const bool is_published = fs::exists(folder.path() / gradebook_file);
        const ClassOutcome outcome =
            graded(folder, *engine_, is_published ? OldResults::stay : OldResults::are_replaced);
        return outcome.control_fault.empty() ? finished(folder, outcome) : exit_fault;
    }

    int finished(const ClassFolder& folder, const ClassOutcome& outcome)
    {
        const std::string warning = warning_about_stubs(selection_.assignment.topic),
                          summary = class_summary(outcome.rows) +
                                    (warning.empty() ? "" : "\n" + warning + "\n");
        const GradeFile canvas = canvas_grades(outcome.rows, selection_.assignment.title);
        const GradeFile moodle = moodle_grades(outcome.rows);
        write_whole(folder.path() / summary_file, summary);
        write_whole(folder.path() / canvas_file, canvas.csv);
        write_whole(folder.path() / moodle_file, moodle.csv);
        write_whole(folder.path() / gradebook_file, gradebook_csv(outcome.rows));
        fmt::print("{}", summary);
        std::sort(changes_.begin(), changes_.end());
        const std::string changes = fmt::format("{}", fmt::join(changes_, ""));
        if (!changes.empty()) fmt::print("\nnot as in the last run:\n{}", changes);
        fmt::print("\n{} graded now, {} as before; {}/{} has the points, and each submission a "
                   "folder with its report.txt\n",
                   outcome.graded, outcome.rows.size() - outcome.graded, options_.out,
                   gradebook_file);
        const std::string logins =
            canvas.logins > 0
                ? fmt::format(" ({} without a name from Canvas count as logins)", canvas.logins)
                : std::string();
        fmt::print("submissions in {}: {}{}, in {}, which takes only those that Moodle has named: "
                   "{}\n",
                   canvas_file, canvas.submissions, logins, moodle_file, moodle.submissions);
        std::fflush(stdout);
        return status_of(outcome);
    }

    // Grades again the submissions whose results could change, and writes to the separate folder
    // `place`. The results in `folder` stay as they are.
    int show(const ClassFolder& folder, const fs::path& place)
    {
        const ClassFolder shown(place, selection_.assignment.name, names_of(work_.submissions));
        KnownResults engine(folder, engine_.get());
        const ClassOutcome outcome = graded(shown, engine, OldResults::are_replaced);
        if (!outcome.control_fault.empty()) return exit_fault;
        std::vector<std::optional<Row>> before;
        for (const Row& row : outcome.rows)
            before.push_back(folder.row_of(row.submission));
        fmt::print("what --regrade changes in {}:\n{}nothing is written yet: the same command "
                   "with --apply writes it\n",
                   options_.out, changes_text(before, outcome.rows));
        return status_of(outcome);
    }

    int apply(const ClassFolder& folder, const fs::path& place)
    {
        int status = exit_fault;
        {
            const ClassFolder shown(place, selection_.assignment.name, names_of(work_.submissions));
            KnownResults engine(shown, nullptr);
            const ClassOutcome outcome = graded(folder, engine, OldResults::are_replaced);
            if (outcome.control_fault.empty()) status = finished(folder, outcome);
        }
        std::error_code kept; // ignored: if `place` remains, the next --regrade uses it again
        fs::remove_all(place, kept);
        return status;
    }

    const GradeOptions& options_;
    Selection selection_;
    ClassProgress progress_;
    std::unique_ptr<Engine> engine_;
    ClassWork work_;
    std::vector<std::string> changes_;
};

} // namespace

Action declare_grade(Options& options)
{
    const auto chosen = std::make_shared<GradeOptions>();
    options.word("ASSIGNMENT", chosen->assignment, "a4-collision, a4 or collision");
    options.words("SUBMISSION", chosen->submissions,
                  "Folders or archives (.zip, .tar, .tar.gz, ...), or a folder of them. A folder "
                  "is one submission if the assignment's file lies in it. Several paths are one "
                  "submission each, unless all are folders of them");
    options.option("--out", "DIR", chosen->out,
                   "Folder for the results: empty, new, or that of an earlier run, of which what "
                   "has not changed is kept");
    options.option(
        "--jobs", "N", chosen->jobs,
        "Submissions that are graded at the same time, each on one processor (as many as "
        "processors; with Slurm as many as it gives)");
    options.option("--engine", "local|slurm", chosen->engine,
                   "Where: on this machine (local), or on the nodes of a Slurm cluster");
    options.option("--chunk", "N", chosen->chunk,
                   "With Slurm: submissions in each task of its job array (8)");
    options.option("--seed", "N", chosen->seed, "First seed of the random cases (0)");
    options.option("--secret", "FILE", chosen->secret,
                   "File with a secret, which draws other random cases for each submission");
    options.flag("--regrade", chosen->is_regrade,
                 "After a change of tests or points: grade everybody again, show whose points "
                 "change, and write nothing");
    options.flag("--apply", chosen->is_applied, "With --regrade: write what it has shown");
    options.examples(
        {"grade a4 submissions --out grades       a folder of folders and archives",
         "grade a4 alice.zip bob/ --out grades    two submissions",
         "grade a4 submissions --out grades       again: only what is new or has changed",
         "grade a4 submissions --out grades --regrade   after a change of tests: what would change",
         "grade a4 submissions --out grades --engine slurm   on a cluster"});
    return [chosen] { return Grading(*chosen).run(); };
}

} // namespace rigor
