// SPDX-License-Identifier: MIT
#include "cli/instructor/class_work.hpp"

#include "cli/prepare.hpp"
#include "cli/secret.hpp"
#include "errors/input_error.hpp"
#include "errors/quotes.hpp"
#include "grading/class/called_stubs.hpp"
#include "grading/class/fingerprint.hpp"
#include "grading/places.hpp"
#include "sandbox/tier.hpp"

#include <cstdio>
#include <fmt/format.h>

namespace rigor {

Selection whole_assignment(const std::string& word)
{
    const std::vector<Selection> found =
        select_tasks(load_assignments(places().assignments()), {word});
    if (found.size() != 1 || found[0].tags.size() != found[0].assignment.tasks.size())
        throw InputError("expected an assignment, such as a4 or collision, found " +
                         in_quotes(word) + ", which is a part of one");
    return found[0];
}

std::string warning_about_stubs(const std::string& topic)
{
    const std::vector<std::string> stubs = called_stubs(places().source, topic);
    if (stubs.empty()) return "";
    std::string files;
    for (const std::string& stub : stubs)
        files += "reference/" + stub + ".cpp ";
    return fmt::format("student/ has stubs of {}, which a right {}.cpp calls: a submission that "
                       "has no files of its own for them loses points. To lend it the "
                       "reference's: cp {}student/",
                       fmt::join(stubs, ", "), topic, files);
}

ClassWork prepared_class_work(const Selection& selection, std::uint32_t seed,
                              const std::string& secret_file)
{
    require_hidden(places());
    ClassWork work;
    work.selection = selection;
    work.run = prepared_grading_run();
    work.run.seed = seed;
    work.run.secret = secret_in(secret_file);
    if (places().has_reference()) work.reference = prepared_implementation("reference");
    prepare_submissions();
    work.parts = shared_parts(work.selection, work.run);
    work.fingerprint = fingerprint_of(work.parts);
    fmt::print(stderr, "walls around the submissions: {}\n", description(usual_tier()));
    if (has_too_weak_walls())
        fmt::print(stderr, "no walls are possible here: hidden tests are left out; with "
                           "RIGOR_TIER=C they run all the same\n");
    fmt::print(stderr, "random cases: {}\n",
               work.run.secret.empty()
                   ? "the same for all, since there is no --secret: a student can know them"
                   : "drawn from the secret, others for each submission");
    if (const std::string warning = warning_about_stubs(selection.assignment.topic);
        !warning.empty())
        fmt::print(stderr, "{}\n", warning);
    if (!work.reference)
        fmt::print(stderr, "this tree has no reference/: no control must get every point\n");
    return work;
}

} // namespace rigor
