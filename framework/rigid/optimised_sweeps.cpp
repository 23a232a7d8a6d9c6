// SPDX-License-Identifier: MIT
#include "rigid/sweeps.hpp"
#include "rigid/two_bodies.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

namespace {

using namespace optimised;

// A contact, all that a visit needs.
struct Row {
    TwoVectors r;                                  // lever arms x - Xᵢ
    Vector3d n, j;                                 // normal, and total impulse on body 1
    double per_normal_K = 0, per_tangential_K = 0; // 1/(nᵀKn), 1/λ
    double target = 0, friction = 0;
};

// Rows of one pair of bodies, [first, last).
struct RowPair {
    int body1 = 0, body2 = 0, first = 0, last = 0;
    TwoMasses masses;
};

// jₙ ← max(0, jₙ - (v·n - s)/(nᵀKn)),  j_T ← j_T - v_T/λ, shortened to |j_T| = μ jₙ where it is longer.
// @return the change
[[gnu::always_inline]] inline Vector3d law(const Row& row, const Vector3d& v)
{
    const double v_n = v.dot(row.n), old_n = row.j.dot(row.n);
    const double j_n = std::max(0.0, old_n - (v_n - row.target) * row.per_normal_K);
    Vector3d j_T = row.j - old_n * row.n - row.per_tangential_K * (v - v_n * row.n);
    const double squared = j_T.squaredNorm(), limit = row.friction * j_n;
    if (squared > limit * limit) j_T *= limit / std::sqrt(squared);
    return j_n * row.n + j_T - row.j;
}

class OptimisedSweeps : public Sweeps {
public:
    OptimisedSweeps(ContactProblem& problem, const std::vector<Held>& held)
        : problem_(problem), held_(held)
    {
        rows_.reserve(held.size());
        for (const Held& h : held) {
            const SolvedContact& c = problem.contacts[h.contact];
            const Body &body1 = problem.bodies[c.body1], &body2 = problem.bodies[c.body2];
            if (pairs_.empty() || pairs_.back().body1 != c.body1 ||
                pairs_.back().body2 != c.body2) {
                const int first = static_cast<int>(rows_.size());
                pairs_.push_back({c.body1, c.body2, first, first, TwoMasses(body1, body2)});
            }
            ++pairs_.back().last;
            rows_.push_back({side_by_side(c.point - body1.position, c.point - body2.position),
                             c.normal, c.guess, 1 / h.normal_K, 1 / h.tangential_K, h.target,
                             c.friction});
        }
        for (const RowPair& pair : pairs_)
            visit(pair, [&](const Row& row, TwoMotions& motions) {
                motions.push(pair.masses, row.r, row.j);
            });
    }

    Progress sweep(std::vector<Vector3d>& steps) override
    {
        Progress progress;
        std::uint64_t impulses = 0;
        for (const RowPair& pair : pairs_)
            visit(pair, [&](Row& row, TwoMotions& motions) {
                Vector3d& step = steps[&row - rows_.data()];
                const Vector3d v = motions.relative_velocity(row.r);
                if (row.j.isZero(0) && v.dot(row.n) >= row.target) {
                    step.setZero();
                    return;
                }
                step = law(row, v);
                row.j += step;
                motions.push(pair.masses, row.r, step);
                ++impulses;
                const double K = 1 / row.per_normal_K, squared = step.squaredNorm();
                progress.change = std::max(progress.change, K * K * squared);
                progress.total = std::max(progress.total, K * K * row.j.squaredNorm());
                progress.squared += K * squared;
            });
        progress.change = std::sqrt(progress.change);
        progress.total = std::sqrt(progress.total);
        problem_.counters->contact_impulses += impulses;
        return progress;
    }

    std::vector<Vector3d> impulses() const override
    {
        std::vector<Vector3d> all;
        all.reserve(rows_.size());
        for (const Row& row : rows_)
            all.push_back(row.j);
        return all;
    }

    void add(const std::vector<Vector3d>& changes) override
    {
        for (const RowPair& pair : pairs_)
            visit(pair, [&](Row& row, TwoMotions& motions) {
                const Vector3d& change = changes[&row - rows_.data()];
                row.j += change;
                motions.push(pair.masses, row.r, change);
            });
    }

    void finish() override
    {
        for (std::size_t k = 0; k < rows_.size(); ++k) {
            const Row& row = rows_[k];
            SolvedContact& c = problem_.contacts[held_[k].contact];
            c.holding = row.j;
            Body &body1 = problem_.bodies[c.body1], &body2 = problem_.bodies[c.body2];
            if (!body1.is_static())
                body1.angular_momentum += (c.point - body1.position).cross(row.j);
            if (!body2.is_static())
                body2.angular_momentum -= (c.point - body2.position).cross(row.j);
        }
    }

private:
    template <class Action>
    [[gnu::always_inline]] void visit(const RowPair& pair, const Action& action)
    {
        Body &body1 = problem_.bodies[pair.body1], &body2 = problem_.bodies[pair.body2];
        TwoMotions motions{side_by_side(body1.velocity, body2.velocity),
                           side_by_side(body1.angular_velocity, body2.angular_velocity)};
        for (int k = pair.first; k < pair.last; ++k)
            action(rows_[k], motions);
        const auto& [V, w] = motions;
        if (!body1.is_static()) {
            body1.velocity = {V.x[0], V.y[0], V.z[0]};
            body1.angular_velocity = {w.x[0], w.y[0], w.z[0]};
        }
        if (!body2.is_static()) {
            body2.velocity = {V.x[1], V.y[1], V.z[1]};
            body2.angular_velocity = {w.x[1], w.y[1], w.z[1]};
        }
    }

    ContactProblem& problem_;
    const std::vector<Held>& held_;
    std::vector<Row> rows_;
    std::vector<RowPair> pairs_;
};

} // namespace

std::unique_ptr<Sweeps> optimised_sweeps(ContactProblem& problem, const std::vector<Held>& held)
{
    return std::make_unique<OptimisedSweeps>(problem, held);
}

} // namespace rigor
