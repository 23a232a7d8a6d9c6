// SPDX-License-Identifier: MIT
// The command that Slurm runs on a node: it grades the submissions of one task of the job array
// that `grade --engine slurm` has started.
#include "cli/instructor/grade_chunk.hpp"

#include "cli/instructor/class_work.hpp"
#include "cli/options.hpp"
#include "errors/input_error.hpp"
#include "errors/quotes.hpp"
#include "grading/class/slurm/slurm_task.hpp"

#include <cstdio>
#include <cstdlib>
#include <fmt/format.h>
#include <memory>

namespace rigor {

namespace {

std::size_t number_of_task()
{
    const char* text = std::getenv("SLURM_ARRAY_TASK_ID");
    const std::string number = text ? text : "";
    if (number.empty() || number.size() > 9 ||
        number.find_first_not_of("0123456789") != std::string::npos)
        throw InputError("expected to be started by Slurm, as a task of a job array: "
                         "SLURM_ARRAY_TASK_ID is " +
                         (text ? in_quotes(number) : "not set"));
    return std::stoul(number);
}

int grade_chunk(const std::string& plan_file)
{
    const std::size_t task = number_of_task();
    const slurm::Plan plan = slurm::read_plan(plan_file);
    const std::string fault = run_slurm_task(
        plan, task,
        prepared_class_work(whole_assignment(plan.assignment), plan.seed, plan.secret_file));
    if (fault.empty()) return exit_done;
    fmt::print(stderr, "{}\n", fault);
    return exit_fault;
}

} // namespace

Action declare_grade_chunk(Options& options)
{
    const auto plan = std::make_shared<std::string>();
    options.word("PLAN", *plan, "The plan that `grade --engine slurm` has written");
    return [plan] { return grade_chunk(*plan); };
}

} // namespace rigor
