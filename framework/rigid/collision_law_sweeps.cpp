// SPDX-License-Identifier: MIT
#include "formulas/collision.hpp"
#include "rigid/sweeps.hpp"

#include <algorithm>

namespace rigor {

namespace {

class CollisionLawSweeps : public Sweeps {
public:
    CollisionLawSweeps(ContactProblem& problem, std::span<const Held> held)
        : problem_(problem), held_(held)
    {
        for (const Held& h : held) {
            SolvedContact& c = problem.contacts[h.contact];
            if (!c.guess.isZero(0)) add_to(c, c.guess);
        }
    }

    Progress sweep(std::vector<Vector3d>& steps) override
    {
        Progress progress;
        for (std::size_t k = 0; k < held_.size(); ++k) {
            steps[k] = hold(held_[k]);
            const double K = held_[k].normal_K;
            const Vector3d& j = problem_.contacts[held_[k].contact].holding;
            progress.change = std::max(progress.change, K * steps[k].norm());
            progress.total = std::max(progress.total, K * j.norm());
            progress.squared += K * steps[k].squaredNorm();
        }
        return progress;
    }

    std::vector<Vector3d> impulses() const override
    {
        std::vector<Vector3d> all;
        for (const Held& h : held_)
            all.push_back(problem_.contacts[h.contact].holding);
        return all;
    }

    void add(const std::vector<Vector3d>& changes) override
    {
        for (std::size_t k = 0; k < held_.size(); ++k)
            if (!changes[k].isZero(0)) add_to(problem_.contacts[held_[k].contact], changes[k]);
    }

    void finish() override {}

private:
    void add_to(SolvedContact& c, const Vector3d& change)
    {
        problem_.apply(c, c.point, change);
        c.holding += change;
    }

    // Corrects one contact's impulse. @return by how much
    Vector3d hold(const Held& h)
    {
        SolvedContact& c = problem_.contacts[h.contact];
        const Vector3d& n = c.normal;
        Vector3d v = problem_.velocity_at(c, c.point) - h.target * n;
        const bool is_idle = c.holding.isZero(0);
        if (is_idle && v.dot(n) >= 0) return Vector3d::Zero();

        const Matrix3d K = h.tangential_K * Matrix3d::Identity() +
                           (h.normal_K - h.tangential_K) * n * n.transpose(); // K̃
        if (!is_idle) v -= K * c.holding;
        const Vector3d j = collision_impulse(K, v, n, 0, c.friction);
        const Vector3d change = j - c.holding;
        if (change.isZero(0)) return change;
        problem_.apply(c, c.point, change);
        c.holding = j;
        ++problem_.counters->contact_impulses;
        return change;
    }

    ContactProblem& problem_;
    std::span<const Held> held_;
};

} // namespace

std::unique_ptr<Sweeps> collision_law_sweeps(ContactProblem& problem, std::span<const Held> held)
{
    return std::make_unique<CollisionLawSweeps>(problem, held);
}

} // namespace rigor
