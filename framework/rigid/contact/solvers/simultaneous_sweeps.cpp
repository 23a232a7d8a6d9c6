// SPDX-License-Identifier: MIT
// Sweeps by the formula `resolve_simultaneously` of topic `contact`, on a copy of the island. Each
// sweep calls the formula for one iteration, which starts from the current impulses. Last, the
// final impulses and the velocities that they cause are stored in the problem.
#include "rigid/contact/solvers/simultaneous_sweeps.hpp"

#include "formulas/contact.hpp"
#include "rigid/contact/local_island.hpp"

#include <algorithm>

namespace rigor {

namespace {

class SimultaneousSweeps : public Sweeps {
public:
    SimultaneousSweeps(ContactProblem& problem, std::span<const int> active)
        : problem_(problem), active_(active), local_(local_island(problem, active))
    {
    }

    SweepProgress sweep(std::vector<Vector3d>& steps) override
    {
        result_ = resolve_simultaneously(local_.bodies, local_.contacts, 1);
        check_size(local_, result_, "resolve_simultaneously");
        is_current_ = true;
        SweepProgress progress;
        for (std::size_t k = 0; k < active_.size(); ++k) {
            const double K = problem_.contacts[active_[k]].normal_K;
            Vector3d& j = local_.contacts[k].impulse;
            steps[k] = result_.impulses[k] - j;
            j = result_.impulses[k];
            progress.change = std::max(progress.change, K * steps[k].norm());
            progress.total = std::max(progress.total, K * j.norm());
            progress.squared += K * steps[k].squaredNorm();
            if (!steps[k].isZero(0)) ++problem_.counters->contact_impulses;
        }
        return progress;
    }

    std::vector<Vector3d> impulses() const override
    {
        std::vector<Vector3d> all;
        for (const BodyContact& c : local_.contacts)
            all.push_back(c.impulse);
        return all;
    }

    void add(const std::vector<Vector3d>& changes) override
    {
        for (std::size_t k = 0; k < active_.size(); ++k)
            local_.contacts[k].impulse += changes[k];
        is_current_ = false;
    }

    void finish() override
    {
        if (!is_current_) result_ = resolve_simultaneously(local_.bodies, local_.contacts, 0);
        take_result(problem_, local_, active_, result_, "resolve_simultaneously");
    }

private:
    ContactProblem& problem_;
    std::span<const int> active_;
    LocalIsland local_;
    ContactResult result_;    // result of the last sweep
    bool is_current_ = false; // false before the first sweep, and after `add` changed impulses
};

} // namespace

std::unique_ptr<Sweeps> simultaneous_sweeps(ContactProblem& problem, std::span<const int> active)
{
    return std::make_unique<SimultaneousSweeps>(problem, active);
}

} // namespace rigor
