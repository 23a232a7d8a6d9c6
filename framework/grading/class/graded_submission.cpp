// SPDX-License-Identifier: MIT
#include "grading/class/graded_submission.hpp"

#include "grading/build/write_file.hpp"
#include "grading/class/environment.hpp"
#include "grading/intake/intake.hpp"
#include "grading/intake/refused.hpp"
#include "report/exports/classroom50.hpp"
#include "report/exports/gradescope.hpp"
#include "report/exports/junit.hpp"
#include "report/result_json.hpp"
#include "report/table.hpp"

#include <ctime>
#include <fmt/format.h>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace rigor {

namespace fs = std::filesystem;

namespace {

void write_files(const Intake& intake, const fs::path& place)
{
    for (const auto& [name, text] : intake.files) {
        fs::create_directories((place / name).parent_path());
        write_file(place / name, text);
    }
}

// Throws if somebody has removed or changed what was graded: a test may have failed for want of a
// file, and would count as the student's failure.
void require_untouched(const Intake& intake, const fs::path& place, const fs::path& worker)
{
    for (const auto& [name, text] : intake.files) {
        std::ifstream in(place / name, std::ios::binary);
        if (!in || std::string(std::istreambuf_iterator<char>(in), {}) != text)
            throw std::runtime_error(
                "somebody has removed or changed a file while it was graded: " +
                (place / name).string());
    }
    if (!fs::exists(worker))
        throw std::runtime_error("somebody has removed a worker while it was graded: " +
                                 worker.string());
}

std::string time_now()
{
    const std::time_t now = std::time(nullptr);
    std::tm utc = {};
    gmtime_r(&now, &utc);
    char text[32] = {};
    std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc);
    return text;
}

ResultFiles files_about(const Result& result, const Implementation& implementation)
{
    std::string report = result.submission + "\n" + points_table(result, implementation, false);
    for (const std::string& note : result.notes)
        report += "\n" + note + "\n";
    return {{"result.json", to_json({result})},
            {"report.txt", report},
            {"junit.xml", junit_xml(result)},
            {"classroom50.json", classroom50_json(result, environment_variable, time_now())},
            {"gradescope.json", gradescope_json(result)}};
}

Result rejected(const Selection& selection, const Submission& submission, const GradingRun& run,
                const std::string& reason)
{
    Result result = ungraded(selection, run, SubmissionStatus::rejected, reason);
    result.submission = submission.name;
    return result;
}

} // namespace

ResultFiles result_files_in(const fs::path& folder)
{
    ResultFiles files;
    for (const char* name :
         {"result.json", "report.txt", "junit.xml", "classroom50.json", "gradescope.json"}) {
        std::ifstream in(folder / name, std::ios::binary);
        files[name].assign(std::istreambuf_iterator<char>(in), {});
    }
    return files;
}

std::string packed(const ResultFiles& files)
{
    return nlohmann::json(files).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

ResultFiles unpacked(const std::string& text)
{
    return nlohmann::json::parse(text).get<ResultFiles>();
}

ResultFiles graded_submission(const Selection& selection, const Submission& submission,
                              const GradingRun& run, const fs::path& place,
                              const std::string& fingerprint)
{
    Implementation implementation;
    Result result;
    try {
        if (!submission.refusal.empty()) throw Refused(submission.refusal);
        const Intake intake = take_submission(submission.path, selection.assignment.topic + ".cpp");
        write_files(intake, place);
        implementation = build_implementation(place.string());
        implementation.name = submission.name;
        result = grade(selection, implementation, run);
        require_untouched(intake, place, implementation.worker);
        if (!intake.ignored.empty())
            result.notes.push_back("ignored: " + first_names(intake.ignored));
        if (!implementation.left_out.empty())
            result.notes.push_back("left out: " + first_names(implementation.left_out));
    } catch (const Refused& refused) {
        result = rejected(selection, submission, run, refused.what());
    }
    if (result.status == SubmissionStatus::internal_error) throw std::runtime_error(result.message);
    result.fingerprint = fingerprint;
    return files_about(result, implementation);
}

ResultFiles faulty_submission(const Selection& selection, const Submission& submission,
                              const GradingRun& run, const std::string& fault)
{
    Result result = ungraded(selection, run, SubmissionStatus::internal_error, fault);
    result.submission = submission.name;
    return files_about(result, {});
}

} // namespace rigor
