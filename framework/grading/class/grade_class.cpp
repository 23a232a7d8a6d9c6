// SPDX-License-Identifier: MIT
// Finds the submissions whose results are missing or out of date. An engine (engine.hpp) grades
// these and passes on the texts of the files to write. Among these files, result.json is written
// last, and whole. So a run that is killed loses only what it was grading, and the next run finds
// the other results by their fingerprints.
#include "grading/class/grade_class.hpp"

#include "errors/input_error.hpp"
#include "errors/quotes.hpp"
#include "grading/class/fingerprint.hpp"
#include "report/write_whole.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <random>
#include <stdexcept>
#include <utility>

namespace rigor {

namespace fs = std::filesystem;

namespace {

class ClassGrading {
public:
    ClassGrading(ClassWork work, const ClassFolder& folder, Engine& engine,
                 const ClassListener& listener, OldResults old)
        : work_(std::move(work)), folder_(folder), engine_(engine), listener_(listener), old_(old),
          before_(work_.submissions.size()), rows_(work_.submissions.size())
    {
        work_.out = folder.path();
    }

    ClassOutcome grade_all()
    {
        find_known();
        if (old_ == OldResults::stay) require_current();
        const std::size_t total = rows_.size(), kept = total - to_do_.size();
        if (listener_.on_kept && kept > 0) listener_.on_kept(kept, total);
        ClassOutcome outcome;
        outcome.graded = to_do_.size();
        if (!to_do_.empty() || folder_.has_unconfirmed()) {
            outcome.control_fault = grade(to_do_);
            if (outcome.control_fault.empty() && !changed_.empty())
                outcome.control_fault = grade_changed();
            if (!outcome.control_fault.empty()) {
                folder_.drop_unconfirmed();
                return outcome;
            }
            folder_.confirm();
        }
        for (std::optional<Row>& row : rows_)
            outcome.rows.push_back(std::move(row.value()));
        return outcome;
    }

private:
    const std::string& name(std::size_t i) const { return work_.submissions[i].name; }

    bool is_of_this_run(const Row& row, std::size_t i) const
    {
        const std::vector<std::string>& tags = work_.selection.tags;
        return row.submission == name(i) && row.assignment == work_.selection.assignment.name &&
               std::equal(row.tasks.begin(), row.tasks.end(), tags.begin(), tags.end(),
                          [](const TaskPoints& task, const auto& tag) { return task.tag == tag; });
    }

    void find_known()
    {
        for (std::size_t i = 0; i < work_.submissions.size(); ++i) {
            progress(i, work_.submissions.size(), "looking for what has changed", "");
            work_.fingerprints.push_back(fingerprint_of(work_.submissions[i], work_.fingerprint));
            before_[i] = folder_.row_of(name(i));
            std::optional<Row>& row = before_[i];
            if (row && is_of_this_run(*row, i) && row->fingerprint == work_.fingerprints[i])
                rows_[i] = std::exchange(row, std::nullopt);
            else
                to_do_.push_back(i);
        }
        std::mt19937 random(work_.run.seed);
        for (std::size_t i = to_do_.size(); i > 1; --i) // shuffle (Fisher and Yates)
            std::swap(to_do_[i - 1], to_do_[random() % i]);
    }

    // @throws InputError if there is a result that was made with other tests
    void require_current() const
    {
        std::vector<std::string> names;
        for (const std::size_t i : to_do_)
            if (before_[i] && before_[i]->has_points() &&
                !is_of_the_same_tests(before_[i]->fingerprint, work_.fingerprint))
                names.push_back(name(i));
        std::sort(names.begin(), names.end());
        if (names.empty()) return;
        throw InputError(fmt::format(
            "{}: expected results of these tests, points, seeds, walls and files of other topics "
            "in student/, found {} of others, such as that of {}: --regrade shows what would "
            "change, and --regrade --apply writes it",
            folder_.path().string(), names.size(), in_quotes(names[0])));
    }

    // @return what is wrong with a control; empty if nothing is
    std::string grade(const std::vector<std::size_t>& numbers)
    {
        std::map<std::string, std::string> expected;
        for (const std::size_t i : numbers)
            expected[name(i)] = work_.fingerprints[i];
        folder_.begin_unconfirmed(expected);
        return engine_.grade(
            work_, numbers, [&](std::size_t i, const ResultFiles& files) { take(i, files); },
            [&](const std::string& doing, const std::string& detail) {
                progress(done_, to_do_.size(), doing, detail);
            });
    }

    // Grades once more, as they are now, the submissions that changed before they were graded or
    // meanwhile. One that changes again is reported as a fault.
    std::string grade_changed()
    {
        is_second_time_ = true;
        for (const std::size_t i : changed_)
            work_.fingerprints[i] = fingerprint_of(work_.submissions[i], work_.fingerprint);
        return grade(changed_);
    }

    // Takes a result if the submission still is what its fingerprint says.
    void take(std::size_t i, const ResultFiles& files)
    {
        const Submission& submission = work_.submissions[i];
        if (fingerprint_of(submission, work_.fingerprint) == work_.fingerprints[i])
            keep(i, files);
        else if (!is_second_time_)
            changed_.push_back(i);
        else
            keep(i, faulty_submission(work_.selection, submission, work_.run,
                                      "the submission changed while it was graded (tried twice)"));
    }

    void keep(std::size_t i, const ResultFiles& files)
    {
        write(i, files);
        rows_[i] = read_row(files.at("result.json"));
        if (!rows_[i]) throw std::runtime_error(name(i) + ": its result is not a whole result");
        ++done_;
        if (listener_.on_row) listener_.on_row(*rows_[i], before_[i]);
    }

    // Writes result.json last, because its presence says that the other files are there.
    void write(std::size_t i, const ResultFiles& files) const
    {
        const fs::path result = folder_.result_of(name(i));
        std::error_code error;
        fs::create_directories(result.parent_path(), error);
        if (error)
            throw InputError(result.parent_path().string() +
                             ": cannot be made: " + error.message());
        fs::remove(result, error);
        for (const auto& [file_name, text] : files) {
            const fs::path file = result.parent_path() / file_name;
            if (text.empty())
                fs::remove(file, error);
            else if (file != result)
                write_whole(file, text);
        }
        write_whole(result, files.at("result.json"));
    }

    void progress(std::size_t done, std::size_t total, const std::string& doing,
                  const std::string& detail) const
    {
        if (listener_.on_progress) listener_.on_progress(done, total, doing, detail);
    }

    ClassWork work_;
    const ClassFolder& folder_;
    Engine& engine_;
    const ClassListener& listener_;
    OldResults old_;
    // The old results of the submissions that are graded again, and all results after this run.
    std::vector<std::optional<Row>> before_, rows_;
    std::vector<std::size_t> to_do_, changed_;
    bool is_second_time_ = false; // whether the changed submissions are graded now
    std::size_t done_ = 0;
};

} // namespace

ClassOutcome grade_class(ClassWork work, const ClassFolder& folder, Engine& engine,
                         const ClassListener& listener, OldResults old)
{
    return ClassGrading(std::move(work), folder, engine, listener, old).grade_all();
}

} // namespace rigor
