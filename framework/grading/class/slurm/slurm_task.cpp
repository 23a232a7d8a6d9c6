// SPDX-License-Identifier: MIT
#include "grading/class/slurm/slurm_task.hpp"

#include "errors/input_error.hpp"
#include "grading/class/environment.hpp"
#include "grading/class/fingerprint.hpp"
#include "grading/class/local_engine.hpp"

#include <fmt/format.h>

namespace rigor {

namespace {

std::string node()
{
    const std::string name = environment_variable("SLURMD_NODENAME");
    return name.empty() ? "this node" : "node " + name;
}

// Refuses to grade on this node if its tree, programs or sandbox differ from those of the machine
// that submitted the job, because the points could differ too.
void require_same_framework(const slurm::Plan& plan, const ClassWork& work)
{
    if (work.fingerprint == plan.fingerprint) return;
    throw InputError(node() +
                     ": expected the tree, the programs and the walls of the machine that "
                     "submitted the job, found others: " +
                     work.run.test_program.string());
}

// Why a submission is not as it was when the plan was made; empty if it is.
std::string difference(const slurm::Plan& plan, std::size_t i, const ClassWork& work)
{
    if (fingerprint_of(plan.submissions[i], work.fingerprint) == plan.fingerprints[i]) return "";
    return fmt::format("{}: expected the submission as it was when the run began, found another or "
                       "none: {}",
                       node(), plan.submissions[i].path.string());
}

} // namespace

std::string run_slurm_task(const slurm::Plan& plan, std::size_t task, ClassWork work)
{
    if (task >= plan.chunks.size())
        throw InputError(
            fmt::format("expected a task below {}, found {}", plan.chunks.size(), task));
    const slurm::SharedFolder shared(plan.out, plan.run);
    work.out = plan.out;
    work.submissions = plan.submissions;
    work.fingerprints = plan.fingerprints;
    require_same_framework(plan, work);
    // A submission that has changed, before or while it was graded, is reported as a fault.
    const auto report = [&](std::size_t i, const std::string& fault) {
        shared.write_graded(
            plan.fingerprints[i],
            faulty_submission(work.selection, plan.submissions[i], work.run, fault));
    };
    const auto write = [&](std::size_t i, const ResultFiles& files) {
        if (const std::string fault = difference(plan, i, work); !fault.empty())
            report(i, fault);
        else
            shared.write_graded(plan.fingerprints[i], files);
    };
    std::vector<std::size_t> numbers; // indices of the chunk's submissions without a result yet
    for (const std::size_t i : plan.chunks[task]) {
        if (shared.graded(plan.fingerprints[i])) continue;
        if (const std::string fault = difference(plan, i, work); !fault.empty())
            report(i, fault);
        else
            numbers.push_back(i);
    }
    LocalEngine engine(1, fmt::format("{}_{}", environment_variable("SLURM_JOB_ID"),
                                      environment_variable("SLURM_RESTART_COUNT")));
    std::string fault =
        engine.grade(work, numbers, write, [](const std::string&, const std::string&) {});
    if (fault.empty())
        shared.write_ended(plan.round, task);
    else
        shared.write_control_fault(node() + ": " + fault);
    return fault;
}

} // namespace rigor
