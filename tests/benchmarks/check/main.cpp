// SPDX-License-Identifier: MIT
// The time from saving a topic's file to the verdicts of its tasks, for each topic of the student
// and of the reference. The file gets one more line, and is restored afterwards.
#include "grading/places.hpp"
#include "grading/run_tests.hpp"
#include "grading/selection.hpp"
#include "support/bench/bench.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace {

using namespace rigor;
namespace fs = std::filesystem;

// Appends a line to a file. The destructor restores the text and the time of the file.
class Edited {
public:
    explicit Edited(const fs::path& file) : file_(file), time_(fs::last_write_time(file))
    {
        std::ifstream in(file);
        text_.assign(std::istreambuf_iterator<char>(in), {});
        std::ofstream(file, std::ios::app) << "// edited\n";
    }
    ~Edited()
    {
        std::ofstream(file_) << text_;
        std::error_code nobody_to_tell;
        fs::last_write_time(file_, time_, nobody_to_tell);
    }
    Edited(const Edited&) = delete;
    Edited& operator=(const Edited&) = delete;

private:
    fs::path file_;
    fs::file_time_type time_;
    std::string text_;
};

long steps_with(const Implementation& implementation, const std::string& words)
{
    return std::count_if(
        implementation.build_steps.begin(), implementation.build_steps.end(),
        [&](const std::string& step) { return step.find(words) != std::string::npos; });
}

// Edits, builds and tests one topic of an implementation.
// @return whether only its file was compiled and only its worker was linked
bool measure(Bench& bench, const std::string& who, const Selection& selection)
{
    build_implementation(who); // what was out of date before is not measured
    GradingRun run = own_grading_run();
    const std::string& topic = selection.assignment.topic;
    const Edited saved(places().source / who / (topic + ".cpp"));

    Implementation implementation;
    Result result;
    const double build = seconds([&] { implementation = build_implementation(who); });
    const double tests = seconds([&] { result = grade(selection, implementation, run); });
    if (result.status != SubmissionStatus::graded)
        throw std::runtime_error(who + " cannot be checked: " + result.message);

    const long files = steps_with(implementation, topic + ".cpp"),
               links = steps_with(implementation, "Linking");
    const long others = static_cast<long>(implementation.build_steps.size()) - files - links;
    bench.row({{"topic", topic},
               {"of", who},
               {"files compiled", static_cast<double>(files)},
               {"links", static_cast<double>(links)},
               {"other steps", static_cast<double>(others)},
               {"build [s]", build},
               {"tests [s]", tests},
               {"to the verdict [s]", build + tests}});
    return files == 1 && links == 1 && others == 0;
}

} // namespace

int main(int argc, char** argv)
{
    try {
        Bench bench("check");
        int more_or_less = 0;
        for (const Selection& selection :
             select_tasks(load_assignments(places().assignments()), {}))
            for (const char* who : {"student", "reference"}) {
                if (!fs::exists(places().source / who)) continue;
                more_or_less += !measure(bench, who, selection);
            }
        bench.note(
            "each topic's file is touched, then built and judged as `rigor check TOPIC` does");
        bench.reach({"edits after which anything but one file and its worker was built",
                     static_cast<double>(more_or_less), 0});
        return bench.finish(wants_json(argc, argv));
    } catch (const std::exception& error) {
        std::fprintf(stderr, "bench check: %s\n", error.what());
        return 3;
    }
}
