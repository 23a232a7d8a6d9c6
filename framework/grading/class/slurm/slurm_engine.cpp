// SPDX-License-Identifier: MIT
// Grades a class in rounds. In each round the engine submits a job array of Slurm and follows it.
// It takes each result as soon as its file is there, and asks Slurm from time to time whether the
// tasks still wait or run. A task grades the controls too, which are submissions with known points.
// If these were right, the task writes a file at its end. The round is over when all tasks have
// written this file, when no task waits or runs any more, as Slurm says, or when a control was
// wrong, which ends the whole run. The submissions without a result are graded in the next round.
#include "grading/class/slurm/slurm_engine.hpp"

#include "errors/input_error.hpp"
#include "grading/build/submission_files.hpp"
#include "grading/class/fingerprint.hpp"
#include "grading/class/slurm/commands.hpp"
#include "grading/class/slurm/interruption.hpp"
#include "grading/class/slurm/running_job.hpp"
#include "grading/class/slurm/shared_folder.hpp"
#include "grading/class/work_folders.hpp"
#include "report/exports/row.hpp"

#include <algorithm>
#include <chrono>
#include <fmt/format.h>
#include <thread>

namespace rigor {

namespace {

using Clock = std::chrono::steady_clock;

constexpr unsigned most_rounds = 3;
constexpr std::size_t most_tasks = 1000; // in a job array; by default, Slurm takes up to 1001
constexpr std::chrono::milliseconds look_every(250);
constexpr std::chrono::seconds ask_every(2);
// The longest time that Slurm may leave questions without an answer. Its daemons are restarted now
// and then; the tasks go on meanwhile.
constexpr std::chrono::minutes longest_silence(10);
// How long to look for more files after the end of a job. NFS caches the list of files in a folder
// for some seconds, so files of another machine appear late.
constexpr std::chrono::seconds last_look(5);

class SlurmRun {
public:
    SlurmRun(const SlurmOptions& options, const ClassWork& work,
             const std::vector<std::size_t>& numbers, const OnGraded& on_graded,
             const OnWait& on_wait)
        : options_(options), work_(work), on_graded_(on_graded), on_wait_(on_wait),
          missing_(numbers), run_(slurm::new_run()), shared_(work.out, run_),
          name_(fmt::format("rigor-{:016x}", hash_of(work.out.string())))
    {
    }

    std::string grade_all()
    {
        take_over_from_broken_runs();
        shared_.make();
        folders_.emplace(work_.out);
        for (round_ = 1;; ++round_) {
            require_unchanged(work_.parts, work_.selection, work_.run);
            const slurm::Plan plan = next_plan();
            run_round(plan);
            std::string fault = shared_.control_fault();
            const std::size_t lost = plan.chunks.size() - ended(plan).size();
            if (fault.empty() && lost > 0) {
                const std::string reason = first_reason(plan);
                note(fmt::format("{} of {} tasks of Slurm's job were lost{}", lost,
                                 plan.chunks.size(), reason));
                if (round_ >= most_rounds && !missing_.empty()) give_up_missing(reason);
                // After `most_rounds` rounds, one more follows, which grades only the controls, the
                // submissions with known points.
                if (round_ <= most_rounds) continue;
                fault = "control after the last submission could not be graded" + reason;
            }
            if (!folders_->are_left()) shared_.remove();
            return fault;
        }
    }

private:
    void note(const std::string& text) const
    {
        if (options_.on_note) options_.on_note(text);
    }

    // Ends the jobs of runs that were broken off. The results that these jobs have made are taken,
    // except those that report a fault, and all of a run whose control was wrong.
    void take_over_from_broken_runs()
    {
        for (const slurm::SharedFolder& broken : slurm::SharedFolder::all(work_.out)) {
            if (const std::string job = broken.job(); !job.empty())
                slurm::end_job(job, name_,
                               [&] { on_wait_("waiting for the end of Slurm's job " + job, ""); });
            if (broken.control_fault().empty()) take_results(broken, false);
            broken.remove();
        }
    }

    // @param with_faults  whether to take results that report a fault; they have no fingerprint
    void take_results(const slurm::SharedFolder& from, bool with_faults)
    {
        const auto is_wanted = [&](const ResultFiles& files, const std::string& fingerprint) {
            const std::optional<Row> row = read_row(files.at("result.json"));
            return with_faults || (row && row->fingerprint == fingerprint);
        };
        const std::set<std::string> there = from.all_graded();
        std::erase_if(missing_, [&](std::size_t i) {
            const std::string& fingerprint = work_.fingerprints[i];
            const std::optional<ResultFiles> files =
                there.count(fingerprint) ? from.graded(fingerprint) : std::nullopt;
            if (!files || !is_wanted(*files, fingerprint)) return false;
            on_graded_(i, *files);
            return true;
        });
    }

    // The tasks of a job that have ended well.
    std::set<std::size_t> ended(const slurm::Plan& plan) const
    {
        return shared_.ended(plan.round, plan.chunks.size());
    }

    // The plan of the next job. If no submission is missing, the job has one task, which grades
    // only the controls, the submissions with known points.
    slurm::Plan next_plan() const
    {
        slurm::Plan plan;
        plan.run = run_;
        plan.round = round_;
        plan.assignment = work_.selection.assignment.name;
        plan.out = work_.out.string();
        plan.seed = work_.run.seed;
        plan.secret_file = options_.secret_file;
        plan.fingerprint = work_.fingerprint;
        const std::size_t size = std::max(std::max<std::size_t>(1, options_.chunk),
                                          (missing_.size() + most_tasks - 1) / most_tasks);
        for (const std::size_t i : missing_) {
            if (plan.submissions.size() % size == 0) plan.chunks.emplace_back();
            plan.chunks.back().push_back(plan.submissions.size());
            plan.submissions.push_back(work_.submissions[i]);
            plan.fingerprints.push_back(work_.fingerprints[i]);
        }
        if (plan.chunks.empty()) plan.chunks.emplace_back();
        return plan;
    }

    slurm::ArrayJob job_for(const slurm::Plan& plan) const
    {
        slurm::ArrayJob job;
        job.name = name_;
        job.tasks = plan.chunks.size();
        job.at_once = options_.at_once;
        job.script = shared_.script();
        job.log = shared_.log_pattern(round_);
        job.program = options_.task_command;
        job.program.push_back(shared_.write_plan(plan).string());
        return job;
    }

    void run_round(const slurm::Plan& plan)
    {
        const Interruption interruption;
        slurm::RunningJob job(job_for(plan), shared_, *folders_);
        note(fmt::format("Slurm's job {} has {} {}", job.number(), plan.chunks.size(),
                         plan.chunks.size() == 1 ? "task" : "tasks"));
        const slurm::TaskCounts counts = follow(job, plan, interruption);
        take_results(shared_, true);
        if (!shared_.control_fault().empty()) return; // ~RunningJob ends the job
        job.note_end();
        const bool is_whole = ended(plan).size() == plan.chunks.size();
        if (!is_whole && counts.cancelled > 0)
            throw InputError(fmt::format("Slurm's job {} was cancelled: the same command goes on "
                                         "from here",
                                         job.number()));
        if (!is_whole && !shared_.has_log(round_))
            throw InputError("--out: expected a folder that all nodes see and may write, found " +
                             work_.out.string() + ", in which no task could write");
    }

    // Returns when all tasks have ended well, when no task waits or runs any more, or when a
    // control (a submission with known points) was wrong.
    slurm::TaskCounts follow(slurm::RunningJob& job, const slurm::Plan& plan,
                             const Interruption& interruption)
    {
        slurm::TaskCounts counts;
        Clock::time_point asked = {}, answered = Clock::now();
        while (true) {
            take_results(shared_, true);
            if (!shared_.control_fault().empty() || ended(plan).size() == plan.chunks.size())
                return counts;
            if (interruption.is_wanted()) call_off(job);
            if (Clock::now() - asked >= ask_every) {
                const std::optional<slurm::TaskCounts> answer =
                    slurm::task_counts(job.number(), name_);
                asked = Clock::now();
                if (answer) {
                    counts = *answer;
                    answered = asked;
                    if (counts.is_over()) {
                        look_once_more(plan);
                        return counts;
                    }
                }
                if (asked - answered > longest_silence) leave_alone(job);
            }
            on_wait_("grading", in_words(counts, asked == answered));
            std::this_thread::sleep_for(look_every);
        }
    }

    void look_once_more(const slurm::Plan& plan)
    {
        const Clock::time_point start = Clock::now();
        while (Clock::now() - start < last_look && ended(plan).size() < plan.chunks.size()) {
            take_results(shared_, true);
            std::this_thread::sleep_for(look_every);
        }
    }

    [[noreturn]] void call_off(const slurm::RunningJob& job) const
    {
        const std::string text =
            fmt::format("broken off: Slurm's job {} is cancelled, and the same command goes on "
                        "from here",
                        job.number());
        note(text);
        throw InputError(text);
    }

    [[noreturn]] void leave_alone(slurm::RunningJob& job) const
    {
        job.leave_alone();
        throw InputError(fmt::format("Slurm has not answered for {} minutes: its job {} may go on, "
                                     "and the same command takes what it has graded",
                                     longest_silence.count(), job.number()));
    }

    static std::string in_words(const slurm::TaskCounts& counts, bool has_answered)
    {
        if (!has_answered) return "Slurm does not answer";
        if (counts.running == 0 && counts.waiting > 0) return "waits: " + counts.reason;
        return fmt::format("{} {}", counts.running, counts.running == 1 ? "task" : "tasks");
    }

    // The last line that a lost task printed; if several printed something, that of the first task.
    std::string first_reason(const slurm::Plan& plan) const
    {
        const std::set<std::size_t> well = ended(plan);
        for (std::size_t task = 0; task < plan.chunks.size(); ++task) {
            if (well.count(task)) continue;
            const std::string words = shared_.last_words(round_, task);
            if (!words.empty()) return ", the first of them: " + words;
        }
        return "";
    }

    void give_up_missing(const std::string& reason)
    {
        const std::string fault =
            fmt::format("the tasks of {} Slurm jobs were lost with it{}", most_rounds, reason);
        for (const std::size_t i : missing_)
            on_graded_(i,
                       faulty_submission(work_.selection, work_.submissions[i], work_.run, fault));
        missing_.clear();
    }

    const SlurmOptions& options_;
    const ClassWork& work_;
    const OnGraded& on_graded_;
    const OnWait& on_wait_;
    std::vector<std::size_t> missing_; // indices of the submissions without a result
    std::string run_;
    slurm::SharedFolder shared_;
    // The working folders of all tasks, even of lost ones. They exist as soon as no task of an
    // earlier run works in them.
    std::optional<WorkFolders> folders_;
    std::string name_; // what Slurm calls the jobs
    unsigned round_ = 0;
};

} // namespace

SlurmEngine::SlurmEngine(SlurmOptions options) : options_(std::move(options))
{
    slurm::require_installed();
}

std::string SlurmEngine::grade(const ClassWork& work, const std::vector<std::size_t>& numbers,
                               const OnGraded& on_graded, const OnWait& on_wait)
{
    return SlurmRun(options_, work, numbers, on_graded, on_wait).grade_all();
}

} // namespace rigor
