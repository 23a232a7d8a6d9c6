// SPDX-License-Identifier: MIT
#include "one_submission.hpp"

#include "grading/build/compiled_folder.hpp"
#include "grading/build/submission_build.hpp"
#include "grading/places.hpp"
#include "grading/run_tests.hpp"
#include "grading/selection.hpp"
#include "support/temporary_folder.hpp"

#include <fmt/format.h>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace rigor {

namespace {

namespace fs = std::filesystem;

// A folder with the reference's files, whose build is removed with it.
class Submitted {
public:
    Submitted()
    {
        for (const auto& entry : fs::directory_iterator(places().source / "reference"))
            fs::copy_file(entry.path(), folder_.path() / entry.path().filename());
    }
    ~Submitted() { remove_submission_build(folder_.path()); }
    Submitted(const Submitted&) = delete;
    Submitted& operator=(const Submitted&) = delete;

    Implementation build() const { return build_implementation(folder_.path().string()); }
    /// Makes the next build link again what was compiled.
    void forget_link() const
    {
        fs::remove(CompiledFolder::place_of(folder_.path()) / "worker.key");
    }
    /// Puts a text behind the first place of another one.
    void insert(const std::string& file, const std::string& after, const std::string& text) const
    {
        std::ifstream in(folder_.path() / file);
        std::stringstream content;
        content << in.rdbuf();
        std::string all = content.str();
        const std::size_t at = all.find(after);
        if (at == std::string::npos) throw std::runtime_error(file + " has no '" + after + "'");
        std::ofstream(folder_.path() / file) << all.insert(at + after.size(), text);
    }

private:
    testing::TemporaryFolder folder_;
};

Selection tasks_of(const std::string& assignment)
{
    return select_tasks(load_assignments(places().assignments()), {assignment}).at(0);
}

double time_of_tests(const Selection& selection, const Implementation& implementation)
{
    Result result;
    const double time =
        seconds([&] { result = grade(selection, implementation, own_grading_run()); });
    if (result.status != SubmissionStatus::graded)
        throw std::runtime_error(selection.assignment.name + ": " + result.message);
    return time;
}

// The median of three runs, since a machine is busy with other things at times.
template <class Time> double median_of_three(const Time& time)
{
    return median({time(), time(), time()});
}

} // namespace

void measure_one_submission(Bench& bench)
{
    const Submitted submitted;
    const Implementation implementation = submitted.build();
    time_of_tests(tasks_of("A0"), implementation); // builds what grades, if it is not built yet
    constexpr double longest = 7;
    for (const Assignment& assignment : load_assignments(places().assignments())) {
        const Selection selection = tasks_of(assignment.label());
        const double link = median_of_three([&] {
            submitted.forget_link();
            return seconds([&] { submitted.build(); });
        });
        const double tests =
            median_of_three([&] { return time_of_tests(selection, implementation); });
        bench.row({{"one submission of", assignment.name},
                   {"link [s]", link},
                   {"tests [s]", tests},
                   {"together [s]", link + tests}});
        bench.reach({"tests of " + assignment.name + " [s]", tests, longest});
        const double limit = assignment.topic == "inertia" ? 1 : 2;
        if (assignment.topic == "inertia" || assignment.topic == "collision")
            bench.reach({"everything but the compiler for " + assignment.name + " [s]",
                         link + tests, limit});
    }

    submitted.insert("rotation.cpp",
                     "Quaternion multiply(const Quaternion& a, const Quaternion& b)\n{",
                     "\n    for (volatile int i = 0;; i = i + 1) {}\n");
    const Implementation endless = submitted.build();
    bench.reach({"tests of A3 with a formula that never returns [s]",
                 time_of_tests(tasks_of("a3"), endless), 30});
}

} // namespace rigor
