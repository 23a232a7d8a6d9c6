// SPDX-License-Identifier: MIT
// Projected Gauss–Seidel sweeps (Jean 1999; Erleben 2007) with the formula `collision_impulse`. For
// each contact, a sweep first subtracts the effect of this contact's impulse from the relative
// velocity. Then the formula gives the new impulse, and the change of the impulse is applied to
// both bodies.
#include "rigid/contact/solvers/collision_law_sweeps.hpp"

#include "formulas/collision.hpp"

#include <algorithm>

namespace rigor {

namespace {

class CollisionLawSweeps : public Sweeps {
public:
    CollisionLawSweeps(ContactProblem& problem, std::span<const int> active)
        : problem_(problem), active_(active)
    {
        for (int i : active) {
            ContactConstraint& c = problem.contacts[i];
            if (!c.initial_impulse.isZero(0)) add_to(c, c.initial_impulse);
        }
    }

    SweepProgress sweep(std::vector<Vector3d>& steps) override
    {
        SweepProgress progress;
        for (std::size_t k = 0; k < active_.size(); ++k) {
            ContactConstraint& c = problem_.contacts[active_[k]];
            steps[k] = correct(c);
            const double K = c.normal_K;
            const Vector3d& j = c.contact_impulse;
            progress.change = std::max(progress.change, K * steps[k].norm());
            progress.total = std::max(progress.total, K * j.norm());
            progress.squared += K * steps[k].squaredNorm();
        }
        return progress;
    }

    std::vector<Vector3d> impulses() const override
    {
        std::vector<Vector3d> all;
        for (int i : active_)
            all.push_back(problem_.contacts[i].contact_impulse);
        return all;
    }

    void add(const std::vector<Vector3d>& changes) override
    {
        for (std::size_t k = 0; k < active_.size(); ++k)
            if (!changes[k].isZero(0)) add_to(problem_.contacts[active_[k]], changes[k]);
    }

    void finish() override {}

private:
    void add_to(ContactConstraint& c, const Vector3d& change)
    {
        problem_.apply(c, c.point, change);
        c.contact_impulse += change;
    }

    // Corrects the impulse of one contact.
    // @return the change of the impulse
    Vector3d correct(ContactConstraint& c)
    {
        const Vector3d& n = c.normal;
        Vector3d v = problem_.velocity_at(c, c.point) - c.target_speed * n;
        const bool is_idle = c.contact_impulse.isZero(0);
        if (is_idle && v.dot(n) >= 0) return Vector3d::Zero();

        const Matrix3d K = c.tangential_K * Matrix3d::Identity() +
                           (c.normal_K - c.tangential_K) * n * n.transpose(); // K̃, see the header
        if (!is_idle) v -= K * c.contact_impulse;
        const Vector3d j = collision_impulse(K, v, n, 0, c.friction);
        const Vector3d change = j - c.contact_impulse;
        if (change.isZero(0)) return change;
        problem_.apply(c, c.point, change);
        c.contact_impulse = j;
        ++problem_.counters->contact_impulses;
        return change;
    }

    ContactProblem& problem_;
    std::span<const int> active_; // indices in `problem_.contacts`
};

} // namespace

std::unique_ptr<Sweeps> collision_law_sweeps(ContactProblem& problem, std::span<const int> active)
{
    return std::make_unique<CollisionLawSweeps>(problem, active);
}

} // namespace rigor
