// SPDX-License-Identifier: MIT
// Each submission is graded in a process of its own (isolated.hpp), which returns the texts of the
// files to write; result.json is written last, and whole. So a run that is killed loses only what
// it was grading, and the next run finds the rest by its fingerprint.
#include "grading/class/grade_class.hpp"

#include "errors/input_error.hpp"
#include "grading/build/submission_build.hpp"
#include "grading/build/submission_files.hpp"
#include "grading/class/control.hpp"
#include "grading/class/fingerprint.hpp"
#include "grading/class/graded_submission.hpp"
#include "grading/class/isolated.hpp"
#include "grading/places.hpp"
#include "report/write_whole.hpp"

#include <algorithm>
#include <chrono>
#include <fmt/format.h>
#include <fstream>
#include <random>

namespace rigor {

namespace fs = std::filesystem;

namespace {

std::string content_of(const fs::path& file)
{
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

// The folders that submissions are unpacked in. They and what was built from them are removed
// again, also those of a run that was killed.
class WorkFolders {
public:
    explicit WorkFolders(const fs::path& out)
        : folder_(places().build / "grading" / fmt::format("{:016x}", hash_of(out.string())))
    {
        clear();
        fs::create_directories(folder_);
    }
    ~WorkFolders() { clear(); }
    WorkFolders(const WorkFolders&) = delete;
    WorkFolders& operator=(const WorkFolders&) = delete;

    fs::path make(const std::string& name) const
    {
        fs::create_directories(folder_ / name);
        return folder_ / name;
    }
    void remove(const std::string& name) const
    {
        std::error_code error;
        remove_submission_build(folder_ / name);
        fs::remove_all(folder_ / name, error);
    }

private:
    void clear() const
    {
        std::error_code error;
        for (fs::directory_iterator entry(folder_, error), end; !error && entry != end;
             entry.increment(error))
            remove_submission_build(entry->path());
        fs::remove_all(folder_, error);
    }

    fs::path folder_;
};

class ClassGrading {
public:
    ClassGrading(const ClassRun& run, const std::vector<Submission>& submissions,
                 const ClassFolder& folder)
        : run_(run), submissions_(submissions), folder_(folder), work_(folder.path()),
          rows_(submissions.size())
    {
        for (const Submission& submission : submissions)
            names_.push_back(submission.name);
    }

    ClassOutcome grade_all()
    {
        find_known();
        ClassOutcome outcome;
        outcome.graded = to_do_.size();
        if (!to_do_.empty() || folder_.has_unconfirmed()) {
            folder_.begin_unconfirmed();
            outcome.control_fault = grade_between_controls();
            if (!outcome.control_fault.empty()) {
                folder_.drop_unconfirmed(names_);
                return outcome;
            }
            folder_.confirm();
        }
        for (const std::optional<Row>& row : rows_)
            outcome.rows.push_back(row.value());
        return outcome;
    }

private:
    bool is_of_this_run(const Row& row, std::size_t i) const
    {
        const std::vector<std::string>& tags = run_.selection.tags;
        return row.submission == names_[i] && row.assignment == run_.selection.assignment.name &&
               std::equal(row.tasks.begin(), row.tasks.end(), tags.begin(), tags.end(),
                          [](const TaskPoints& task, const auto& tag) { return task.tag == tag; });
    }

    void find_known()
    {
        const std::uint64_t common = fingerprint_of(run_.selection, run_.run);
        for (std::size_t i = 0; i < submissions_.size(); ++i) {
            progress(i, submissions_.size(), "looking for what has changed");
            fingerprints_.push_back(fingerprint_of(submissions_[i], common));
            std::optional<Row> row = read_row(content_of(folder_.result_of(names_[i])));
            if (row && is_of_this_run(*row, i) && row->fingerprint == fingerprints_[i])
                rows_[i] = std::move(row);
            else
                to_do_.push_back(i);
        }
        std::mt19937 random(run_.run.seed);
        for (std::size_t i = to_do_.size(); i > 1; --i) // Fisher and Yates
            std::swap(to_do_[i - 1], to_do_[random() % i]);
    }

    // @return what is wrong with a control
    std::string grade_between_controls()
    {
        if (std::string fault = fault_of_controls("before the first submission"); !fault.empty())
            return fault;
        std::size_t done = 0;
        const auto work = [&](std::size_t k) {
            const std::size_t i = to_do_[k];
            return packed(graded_submission(run_.selection, submissions_[i], run_.run,
                                            work_.make(std::to_string(i)), fingerprints_[i]));
        };
        const auto on_done = [&](const WorkDone& ended) {
            take(to_do_[ended.index], ended);
            ++done;
        };
        run_isolated(
            to_do_.size(), run_.jobs, work, on_done,
            [&] { progress(done, to_do_.size(), "grading"); }, longest_grading());
        return fault_of_controls("after the last submission");
    }

    // The compiler, each call and each scene have limits of their own, so that only a fault of the
    // framework takes this long: hours at the most, and not for ever. The controls were just
    // graded, at this machine's speed and under its load.
    std::chrono::duration<double> longest_grading() const
    {
        constexpr double multiple = 100;
        constexpr std::chrono::minutes least(30); // compilers that run into their limits
        return std::max<std::chrono::duration<double>>(least, multiple * longest_control_);
    }

    void take(std::size_t i, const WorkDone& ended)
    {
        work_.remove(std::to_string(i));
        const std::optional<Row> before = read_row(content_of(folder_.result_of(names_[i])));
        const std::string fault = ended.fault + (ended.was_tried_twice ? " (tried twice)" : "");
        const ResultFiles files =
            ended.text ? unpacked(*ended.text)
                       : faulty_submission(run_.selection, submissions_[i], run_.run, fault);
        write(i, files);
        rows_[i] = read_row(files.at("result.json"));
        if (!rows_[i]) throw std::runtime_error(names_[i] + ": its result is not a whole result");
        if (run_.on_row) run_.on_row(*rows_[i], before);
    }

    // Writes result.json last: it says that the others are there.
    void write(std::size_t i, const ResultFiles& files) const
    {
        const fs::path result = folder_.result_of(names_[i]);
        std::error_code error;
        fs::create_directories(result.parent_path(), error);
        if (error)
            throw InputError(result.parent_path().string() +
                             ": cannot be made: " + error.message());
        fs::remove(result, error);
        for (const auto& [name, text] : files) {
            const fs::path file = result.parent_path() / name;
            if (text.empty())
                fs::remove(file, error);
            else if (file != result)
                write_whole(file, text);
        }
        write_whole(result, files.at("result.json"));
    }

    Result graded_control(bool is_complete) const
    {
        if (is_complete) return grade(run_.selection, *run_.reference, run_.run);
        const fs::path place = work_.make("empty");
        std::ofstream(place / (run_.selection.assignment.topic + ".cpp")) << "// no formulas\n";
        return grade(run_.selection, build_implementation(place.string()), run_.run);
    }

    std::string fault_of_controls(const std::string& when)
    {
        const auto start = std::chrono::steady_clock::now();
        std::string fault;
        const auto work = [&](std::size_t i) {
            return fault_of_control(graded_control(i == 1), i == 1);
        };
        const auto on_done = [&](const WorkDone& ended) {
            const std::string what = ended.index == 1 ? "the reference" : "a file without formulas";
            const std::string wrong =
                ended.text ? *ended.text : "could not be graded: " + ended.fault;
            if (!wrong.empty()) fault = fmt::format("control {}: {} {}", when, what, wrong);
        };
        run_isolated(run_.reference ? 2 : 1, run_.jobs, work, on_done,
                     [&] { progress(0, 1, "controls"); });
        longest_control_ = std::chrono::steady_clock::now() - start;
        return fault;
    }

    void progress(std::size_t done, std::size_t total, const std::string& doing) const
    {
        if (run_.on_progress) run_.on_progress(done, total, doing);
    }

    const ClassRun& run_;
    const std::vector<Submission>& submissions_;
    const ClassFolder& folder_;
    WorkFolders work_;
    std::chrono::duration<double> longest_control_{0};
    std::vector<std::string> names_, fingerprints_;
    std::vector<std::optional<Row>> rows_;
    std::vector<std::size_t> to_do_;
};

} // namespace

ClassOutcome grade_class(const ClassRun& run, const std::vector<Submission>& submissions,
                         const ClassFolder& folder)
{
    return ClassGrading(run, submissions, folder).grade_all();
}

} // namespace rigor
