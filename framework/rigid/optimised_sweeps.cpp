// SPDX-License-Identifier: MIT
#include "rigid/sweeps.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

namespace {

// A contact, all that a visit needs on two cache lines.
struct Row {
    Vector3d n, r1, r2;                            // normal, and lever arms x - Xᵢ
    Vector3d j;                                    // total impulse on body 1
    double per_normal_K = 0, per_tangential_K = 0; // 1/(nᵀKn), 1/λ
    double target = 0, friction = 0;
};

// Rows of one pair of bodies, [first, last).
struct RowPair {
    int body1 = 0, body2 = 0, first = 0, last = 0;
};

// What the impulses on a pair move, in registers while its rows are visited.
struct Motion {
    Vector3d V, w;
    double inverse_mass;
    const Matrix3d& I_inverse;

    explicit Motion(const Body& body)
        : V(body.velocity), w(body.angular_velocity), inverse_mass(body.inverse_mass),
          I_inverse(body.inverse_inertia)
    {
    }
    Vector3d at(const Vector3d& r) const { return V + w.cross(r); }
    void push(const Vector3d& r, const Vector3d& j)
    {
        V += inverse_mass * j;
        w += I_inverse * r.cross(j);
    }
    void store(Body& body) const
    {
        body.velocity = V;
        body.angular_velocity = w;
    }
};

// jₙ ← max(0, jₙ - (v·n - s)/(nᵀKn)),  j_T ← j_T - v_T/λ, shortened to |j_T| = μ jₙ where it is longer.
// @return the change
Vector3d law(const Row& row, const Vector3d& v)
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
            if (pairs_.empty() || pairs_.back().body1 != c.body1 ||
                pairs_.back().body2 != c.body2) {
                const int first = static_cast<int>(rows_.size());
                pairs_.push_back({c.body1, c.body2, first, first});
            }
            ++pairs_.back().last;
            rows_.push_back({c.normal, c.point - problem.bodies[c.body1].position,
                             c.point - problem.bodies[c.body2].position, c.guess, 1 / h.normal_K,
                             1 / h.tangential_K, h.target, c.friction});
        }
        for (const RowPair& pair : pairs_)
            visit(pair, [](const Row& row, Motion& m1, Motion& m2) {
                m1.push(row.r1, row.j);
                m2.push(row.r2, -row.j);
            });
    }

    Progress sweep(std::vector<Vector3d>& steps) override
    {
        Progress progress;
        std::uint64_t impulses = 0;
        for (const RowPair& pair : pairs_)
            visit(pair, [&](Row& row, Motion& m1, Motion& m2) {
                Vector3d& step = steps[&row - rows_.data()];
                const Vector3d v = m1.at(row.r1) - m2.at(row.r2);
                if (row.j.isZero(0) && v.dot(row.n) >= row.target) {
                    step.setZero();
                    return;
                }
                step = law(row, v);
                row.j += step;
                m1.push(row.r1, step);
                m2.push(row.r2, -step);
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

    void add(const std::vector<Vector3d>& changes) override
    {
        for (const RowPair& pair : pairs_)
            visit(pair, [&](Row& row, Motion& m1, Motion& m2) {
                const Vector3d& change = changes[&row - rows_.data()];
                row.j += change;
                m1.push(row.r1, change);
                m2.push(row.r2, -change);
            });
    }

    void finish() override
    {
        for (std::size_t k = 0; k < rows_.size(); ++k) {
            const Row& row = rows_[k];
            SolvedContact& c = problem_.contacts[held_[k].contact];
            c.holding = row.j;
            Body &body1 = problem_.bodies[c.body1], &body2 = problem_.bodies[c.body2];
            if (!body1.is_static()) body1.angular_momentum += row.r1.cross(row.j);
            if (!body2.is_static()) body2.angular_momentum -= row.r2.cross(row.j);
        }
    }

private:
    template <class Action> void visit(const RowPair& pair, const Action& action)
    {
        Body &body1 = problem_.bodies[pair.body1], &body2 = problem_.bodies[pair.body2];
        Motion m1(body1), m2(body2);
        for (int k = pair.first; k < pair.last; ++k)
            action(rows_[k], m1, m2);
        if (!body1.is_static()) m1.store(body1);
        if (!body2.is_static()) m2.store(body2);
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
