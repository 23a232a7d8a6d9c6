// SPDX-License-Identifier: MIT
#include "cli/instructor/release.hpp"

#include "cli/options.hpp"
#include "cli/secret.hpp"
#include "errors/input_error.hpp"
#include "errors/quotes.hpp"
#include "grading/class/called_stubs.hpp"
#include "grading/places.hpp"
#include "grading/selection.hpp"
#include "release/autograder.hpp"
#include "release/autograder_proof.hpp"
#include "release/proof.hpp"
#include "release/repository.hpp"
#include "release/zip.hpp"
#include "report/write_whole.hpp"

#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <fmt/format.h>
#include <ratio>
#include <unistd.h>

namespace rigor {

namespace {

namespace fs = std::filesystem;

struct ReleaseOptions {
    std::string assignment, out, gradescope, classroom, secret;
};

// The folder in which a released tree is built to prove that it works. The folder is kept, so files
// that have not changed since the last release are not built again.
fs::path proving_ground(const char* name)
{
    const fs::path folder = places().build / "release" / name;
    std::error_code error;
    fs::create_directories(folder, error);
    if (!fs::is_directory(folder))
        throw InputError(fmt::format("{}: cannot be made: {}", folder.string(), error.message()));
    return folder;
}

// Numbers the steps of the command's proofs, and says on stderr when each begins. A proof builds
// and grades a release, to check it before it is written.
class Steps {
public:
    explicit Steps(int total) : total_(total) {}

    OnProofStep on_step()
    {
        return [this](const std::string& step) {
            using Minutes = std::chrono::duration<double, std::ratio<60>>;
            const double minutes = Minutes(std::chrono::steady_clock::now() - start_).count();
            fmt::print(stderr, "release, step {} of {}, after {:.0f} min: {}\n", ++begun_, total_,
                       minutes, step);
        };
    }

private:
    int begun_ = 0, total_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

Assignment assignment_of(const ReleaseOptions& options)
{
    if (options.assignment.empty())
        throw InputError("expected an assignment, such as a4: --gradescope and --classroom are "
                         "about one");
    const std::vector<Selection> found =
        select_tasks(load_assignments(places().assignments()), {options.assignment});
    if (found.size() != 1 || found[0].tags.size() != found[0].assignment.tasks.size())
        throw InputError("expected an assignment, such as a4 or collision, found " +
                         in_quotes(options.assignment) + ", which is a part of one");
    return found[0].assignment;
}

// Writes the students' tree as a git repository in a draft folder and proves that it works. Only
// then is the draft folder renamed to `out`.
void release_tree(const ReleasedTree& tree, const std::string& out, Steps& steps)
{
    DraftFolder folder(out);
    const std::string commit = write_repository(tree, folder.draft());
    const fs::path work = proving_ground("students");
    write_commit(folder.draft(), work);
    const TreeProof proof =
        prove_students_tree(work, places().source / "reference", steps.on_step());
    folder.publish();
    fmt::print("{}: {} files, commit {}\n"
               "  built; the stubs: {} visible tasks, none implemented, 0 of {:g} points; the "
               "reference in their place: {:g} of {:g}\n",
               out, tree.size(), commit, proof.tasks, proof.points, proof.points, proof.points);
    std::fflush(stdout);
}

void check_place_of(const std::string& file)
{
    if (fs::is_directory(file))
        throw InputError("--gradescope: expected a file, found the folder " + file);
    const fs::path folder = fs::absolute(file).parent_path();
    if (access(folder.c_str(), W_OK) != 0)
        throw InputError(fmt::format("--gradescope: {} cannot be written: {}", folder.string(),
                                     std::strerror(errno)));
}

void release_autograder(const Assignment& assignment, const std::string& file,
                        const std::string& secret, Steps& steps)
{
    const fs::path layout = proving_ground("autograder"), draft = layout.string() + ".zip";
    const std::string bytes = zip_of(gradescope_tree(places().source, assignment, secret));
    write_whole(draft, bytes);
    const std::string user =
        prove_autograder(draft, layout, assignment, places().source, steps.on_step());
    write_whole(file, bytes);
    fs::remove(draft);
    const std::vector<std::string> lent = called_stubs(places().source, assignment.topic);
    if (!lent.empty())
        fmt::print("student/ has stubs of {}, which a right {}.cpp calls: the autograder has the "
                   "reference's in their place\n",
                   fmt::join(lent, ", "), assignment.topic);
    fmt::print(
        "{}: {:.1f} MB for Gradescope\n"
        "  set up and run as {}: a solved submission gets every point, a file without formulas "
        "and an empty submission none\n"
        "  random cases: {}\n",
        file, static_cast<double>(bytes.size()) / 1e6, user,
        secret.empty() ? "the same for all, a student can know them; --secret FILE draws others"
                       : "drawn from the secret, which is in the zip: keep the zip from students");
    std::fflush(stdout);
}

ReleasedTree classroom_tree(const Assignment& assignment)
{
    ReleasedTree tree = students_tree(places().source);
    add_file(tree, {workflow_path, classroom_workflow(assignment), false});
    return tree;
}

int release(const ReleaseOptions& options)
{
    if (!places().has_reference())
        throw InputError("this tree has no reference/: only the instructor's tree is released");
    if (options.out.empty() && options.gradescope.empty() && options.classroom.empty())
        throw InputError("expected --out DIR, --gradescope FILE or --classroom DIR" +
                         (options.assignment.empty()
                              ? std::string()
                              : ", found only " + in_quotes(options.assignment)));
    if (!options.secret.empty() && options.gradescope.empty())
        throw InputError("--secret: expected --gradescope FILE beside it, whose random cases it "
                         "draws");
    // Errors in the options are reported before anything is built.
    const std::string secret = secret_in(options.secret);
    const bool is_about_one = !options.gradescope.empty() || !options.classroom.empty();
    Assignment assignment;
    if (is_about_one || !options.assignment.empty()) assignment = assignment_of(options);
    for (const std::string& folder : {options.out, options.classroom})
        if (!folder.empty()) const DraftFolder can_be_written(folder);
    if (!options.gradescope.empty()) check_place_of(options.gradescope);

    const auto count = [](const std::string& wanted, int n) { return wanted.empty() ? 0 : n; };
    Steps steps(count(options.out, steps_of_tree_proof) +
                count(options.classroom, steps_of_tree_proof) +
                count(options.gradescope, steps_of_autograder_proof));
    if (!options.out.empty()) release_tree(students_tree(places().source), options.out, steps);
    if (!options.classroom.empty())
        release_tree(classroom_tree(assignment), options.classroom, steps);
    if (!options.gradescope.empty())
        release_autograder(assignment, options.gradescope, secret, steps);
    return exit_done;
}

} // namespace

Action declare_release(Options& options)
{
    const auto chosen = std::make_shared<ReleaseOptions>();
    options.word_or_none("ASSIGNMENT", chosen->assignment,
                         "For --gradescope and --classroom: a4-collision, a4 or collision");
    options.option("--out", "DIR", chosen->out,
                   "The students' tree, a folder and a git repository: new, empty, or an earlier "
                   "release");
    options.option("--gradescope", "FILE", chosen->gradescope,
                   "The autograder of an assignment, a zip to upload");
    options.option("--classroom", "DIR", chosen->classroom,
                   "The students' tree with a workflow that checks an assignment at each push, "
                   "for a template repository on GitHub");
    options.option("--secret", "FILE", chosen->secret,
                   "For --gradescope: a file with a secret that draws the random cases, as in "
                   "`grade`");
    options.examples({"release --out handout                             what students get",
                      "release a4 --gradescope a4.zip --secret secret    for Gradescope",
                      "release a4 --classroom a4-template                for GitHub"});
    return [chosen] { return release(*chosen); };
}

} // namespace rigor
