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
#include "grading/class/slurm/commands.hpp"
#include "grading/class/slurm/interruption.hpp"
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

// A job of Slurm. The destructor cancels it, unless it was released.
class RunningJob {
public:
    RunningJob(const slurm::ArrayJob& job, const slurm::SharedFolder& shared)
        : name_(job.name), number_(slurm::submit(job))
    {
        shared.write_job(number_);
    }
    ~RunningJob()
    {
        if (!has_ended_) slurm::cancel(number_, name_);
    }
    RunningJob(const RunningJob&) = delete;
    RunningJob& operator=(const RunningJob&) = delete;

    const std::string& number() const { return number_; }
    /// From now on the destructor does not cancel the job, because it has ended or Slurm does not
    /// answer.
    void release() { has_ended_ = true; }

private:
    std::string name_, number_;
    bool has_ended_ = false;
};

class SlurmRun {
public:
    SlurmRun(const SlurmOptions& options, const ClassWork& work,
             const std::vector<std::size_t>& numbers, const OnGraded& on_graded,
             const OnWait& on_wait)
        : options_(options), work_(work), on_graded_(on_graded), on_wait_(on_wait),
          missing_(numbers), shared_(work.out), folders_(work.out),
          name_(fmt::format("rigor-{:016x}", hash_of(work.out.string())))
    {
    }

    std::string grade_all()
    {
        take_over_from_broken_run();
        for (round_ = 1;; ++round_) {
            const slurm::Plan plan = next_plan();
            run_round(plan);
            std::string fault = shared_.control_fault();
            const std::size_t lost = plan.chunks.size() - shared_.ended(round_).size();
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
            shared_.remove();
            return fault;
        }
    }

private:
    void note(const std::string& text) const
    {
        if (options_.on_note) options_.on_note(text);
    }

    // Cancels the job of a run that was killed. The results that this job has made are taken,
    // except those that report a fault.
    void take_over_from_broken_run()
    {
        if (const std::string job = shared_.job(); !job.empty()) slurm::cancel(job, name_);
        shared_.make();
        for (const std::string& fingerprint : shared_.all_graded()) {
            const std::optional<ResultFiles> files = shared_.graded(fingerprint);
            const std::optional<Row> row =
                files ? read_row(files->at("result.json")) : std::nullopt;
            if (!row || row->fingerprint != fingerprint) shared_.remove_graded(fingerprint);
        }
        take_results();
    }

    void take_results()
    {
        const std::set<std::string> there = shared_.all_graded();
        std::erase_if(missing_, [&](std::size_t i) {
            const std::string& fingerprint = work_.fingerprints[i];
            const std::optional<ResultFiles> files =
                there.count(fingerprint) ? shared_.graded(fingerprint) : std::nullopt;
            if (files) on_graded_(i, *files);
            return files.has_value();
        });
    }

    // The plan of the next job. If no submission is missing, the job has one task, which grades
    // only the controls, the submissions with known points.
    slurm::Plan next_plan() const
    {
        slurm::Plan plan;
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
        RunningJob job(job_for(plan), shared_);
        note(fmt::format("Slurm's job {} has {} {}", job.number(), plan.chunks.size(),
                         plan.chunks.size() == 1 ? "task" : "tasks"));
        const slurm::TaskCounts counts = follow(job, plan, interruption);
        take_results();
        if (!shared_.control_fault().empty()) return; // ~RunningJob cancels the job
        job.release();
        const bool is_whole = shared_.ended(round_).size() == plan.chunks.size();
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
    slurm::TaskCounts follow(RunningJob& job, const slurm::Plan& plan,
                             const Interruption& interruption)
    {
        slurm::TaskCounts counts;
        Clock::time_point asked = {}, answered = Clock::now();
        while (true) {
            take_results();
            if (!shared_.control_fault().empty() ||
                shared_.ended(round_).size() == plan.chunks.size())
                return counts;
            if (interruption.is_wanted()) call_off(job);
            if (Clock::now() - asked >= ask_every) {
                const std::optional<slurm::TaskCounts> answer = slurm::task_counts(job.number());
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
        while (Clock::now() - start < last_look &&
               shared_.ended(round_).size() < plan.chunks.size()) {
            take_results();
            std::this_thread::sleep_for(look_every);
        }
    }

    [[noreturn]] void call_off(const RunningJob& job) const
    {
        const std::string text =
            fmt::format("broken off: Slurm's job {} is cancelled, and the same command goes on "
                        "from here",
                        job.number());
        note(text);
        throw InputError(text);
    }

    [[noreturn]] void leave_alone(RunningJob& job) const
    {
        job.release();
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
        const std::set<std::size_t> ended = shared_.ended(round_);
        for (std::size_t task = 0; task < plan.chunks.size(); ++task) {
            if (ended.count(task)) continue;
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
    slurm::SharedFolder shared_;
    WorkFolders folders_; // removes the working folders of all tasks, even of lost ones
    std::string name_;
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
