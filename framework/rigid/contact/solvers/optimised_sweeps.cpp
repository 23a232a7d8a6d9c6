// SPDX-License-Identifier: MIT
// Projected Gauss–Seidel sweeps (Jean 1999; Erleben 2007). They compute the same as the formula
// `resolve_simultaneously`, in a form that the compiler can turn into SIMD code. The quantities of
// body 1 and body 2 are side by side in a register while the contacts of a pair are visited one
// after the other. Several threads sweep different blocks of the same color at the same time.
#include "rigid/contact/solvers/optimised_sweeps.hpp"

#include "rigid/bodies/two_bodies.hpp"
#include "rigid/contact/blocks.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

namespace {

using namespace optimised;

// The data that a sweep needs for one contact.
struct SweepRow {
    TwoVectors r;                                          // lever arms x - Xᵢ [m]
    Vector3d n;                                            // normal
    Vector3d j;                                            // total impulse on body 1 [N s]
    double normal_K = 0;                                   // nᵀKn [1/kg]
    double inverse_normal_K = 0, inverse_tangential_K = 0; // 1/(nᵀKn), 1/λ [kg]
    double target_speed = 0;                               // s, least v·n [m/s]
    double friction = 0;                                   // coefficient μ
};

// The rows [first, last) of one pair of bodies.
struct PairRows {
    int body1 = 0, body2 = 0, first = 0, last = 0;
    TwoMasses masses;
};

// The new impulse of a contact, by the law of `resolve_simultaneously`:
//
//     jₙ ← max(0, jₙ - (v·n - s)/(nᵀKn)),   j_T ← j_T - v_T/λ, shortened to |j_T| = μ jₙ if longer
//
// where λ is the larger eigenvalue of K in the tangent plane. With the matrix K̃ of
// collision_law_sweeps.hpp, `collision_impulse` gives the same impulse.
// @return the change of the impulse
[[gnu::always_inline]] inline Vector3d contact_law(const SweepRow& row, const Vector3d& v)
{
    const double v_n = v.dot(row.n), old_n = row.j.dot(row.n);
    const double j_n = std::max(0.0, old_n - (v_n - row.target_speed) * row.inverse_normal_K);
    Vector3d j_T = row.j - old_n * row.n - row.inverse_tangential_K * (v - v_n * row.n);
    const double squared = j_T.squaredNorm(), limit = row.friction * j_n;
    if (squared > limit * limit) j_T *= limit / std::sqrt(squared);
    return j_n * row.n + j_T - row.j;
}

class OptimisedSweeps : public Sweeps {
public:
    OptimisedSweeps(ContactProblem& problem, const Island& island, std::span<const int> active)
        : problem_(problem), island_(island), active_(active), rows_(active.size())
    {
        find_pairs();
        visit_blocks(island_, *problem_.pool, [&](int block) {
            for (PairRows& pair : pairs_of(block)) {
                pair.masses = TwoMasses(problem_.bodies[pair.body1], problem_.bodies[pair.body2]);
                for (int k = pair.first; k < pair.last; ++k)
                    rows_[k] = row_of(problem_.contacts[active_[k]]);
                visit(pair, [&](const SweepRow& row, TwoMotions& motions) {
                    motions.apply(pair.masses, row.r, row.j);
                });
            }
        });
    }

    SweepProgress sweep(std::vector<Vector3d>& steps) override
    {
        visit_blocks(island_, *problem_.pool, [&](int block) {
            Block& swept = blocks_[block];
            swept.progress = {};
            swept.impulses = 0;
            for (const PairRows& pair : pairs_of(block))
                sweep(pair, steps, swept);
        });
        SweepProgress all;
        for (const Block& block : blocks_) {
            const SweepProgress& progress = block.progress;
            problem_.counters->contact_impulses += block.impulses;
            all.change = std::max(all.change, progress.change);
            all.total = std::max(all.total, progress.total);
            all.squared += progress.squared;
        }
        all.change = std::sqrt(all.change);
        all.total = std::sqrt(all.total);
        return all;
    }

    std::vector<Vector3d> impulses() const override
    {
        std::vector<Vector3d> all;
        all.reserve(rows_.size());
        for (const SweepRow& row : rows_)
            all.push_back(row.j);
        return all;
    }

    void add(const std::vector<Vector3d>& changes) override
    {
        for (const PairRows& pair : pairs_)
            visit(pair, [&](SweepRow& row, TwoMotions& motions) {
                const Vector3d& change = changes[&row - rows_.data()];
                row.j += change;
                motions.apply(pair.masses, row.r, change);
            });
    }

    void finish() override
    {
        visit_blocks(island_, *problem_.pool, [&](int block) {
            for (const PairRows& pair : pairs_of(block))
                finish(pair);
        });
    }

private:
    // A block of the island: its range of `pairs_`, the progress of the last sweep over it, and the
    // number of impulses that this sweep applied. Here `change` and `total` of the progress are
    // squares.
    struct Block {
        IndexRange pairs;
        SweepProgress progress;
        std::uint64_t impulses = 0;
    };

    // Finds the rows of each pair, and the pairs of each block.
    void find_pairs()
    {
        int k = 0;
        const int n = static_cast<int>(active_.size());
        blocks_.reserve(island_.blocks.size());
        pairs_.reserve(std::min(island_.pairs.size(), active_.size()));
        for (const IndexRange& block : island_.blocks) {
            const int first_pair = static_cast<int>(pairs_.size());
            for (int i = block.first; i < block.last; ++i) {
                const int first = k, last_contact = island_.pairs[i].last;
                const ContactConstraint& c = problem_.contacts[island_.pairs[i].first];
                while (k < n && active_[k] >= island_.pairs[i].first && active_[k] < last_contact)
                    ++k;
                if (k > first) pairs_.push_back({c.body1, c.body2, first, k, {}});
            }
            blocks_.push_back({{first_pair, static_cast<int>(pairs_.size())}, {}, 0});
        }
    }

    std::span<PairRows> pairs_of(int block)
    {
        const auto [first, last] = blocks_[block].pairs;
        return std::span(pairs_).subspan(first, last - first);
    }

    SweepRow row_of(const ContactConstraint& c) const
    {
        const Body &body1 = problem_.bodies[c.body1], &body2 = problem_.bodies[c.body2];
        return {side_by_side(c.point - body1.position, c.point - body2.position),
                c.normal,
                c.initial_impulse,
                c.normal_K,
                1 / c.normal_K,
                1 / c.tangential_K,
                c.target_speed,
                c.friction};
    }

    void sweep(const PairRows& pair, std::vector<Vector3d>& steps, Block& swept)
    {
        SweepProgress& progress = swept.progress;
        visit(pair, [&](SweepRow& row, TwoMotions& motions) {
            Vector3d& step = steps[&row - rows_.data()];
            const Vector3d v = motions.relative_velocity(row.r);
            if (row.j.isZero(0) && v.dot(row.n) >= row.target_speed) {
                step.setZero();
                return;
            }
            step = contact_law(row, v);
            row.j += step;
            motions.apply(pair.masses, row.r, step);
            ++swept.impulses;
            const double K = row.normal_K, squared = step.squaredNorm();
            progress.change = std::max(progress.change, K * K * squared);
            progress.total = std::max(progress.total, K * K * row.j.squaredNorm());
            progress.squared += K * squared;
        });
    }

    void finish(const PairRows& pair)
    {
        Body &body1 = problem_.bodies[pair.body1], &body2 = problem_.bodies[pair.body2];
        for (int k = pair.first; k < pair.last; ++k) {
            ContactConstraint& c = problem_.contacts[active_[k]];
            c.contact_impulse = rows_[k].j;
            if (!body1.is_static())
                body1.angular_momentum += (c.point - body1.position).cross(c.contact_impulse);
            if (!body2.is_static())
                body2.angular_momentum -= (c.point - body2.position).cross(c.contact_impulse);
        }
    }

    template <class Action>
    [[gnu::always_inline]] void visit(const PairRows& pair, const Action& action)
    {
        Body &body1 = problem_.bodies[pair.body1], &body2 = problem_.bodies[pair.body2];
        TwoMotions motions{side_by_side(body1.velocity, body2.velocity),
                           side_by_side(body1.angular_velocity, body2.angular_velocity)};
        for (int k = pair.first; k < pair.last; ++k)
            action(rows_[k], motions);
        const auto& [V, w] = motions;
        if (!body1.is_static()) {
            body1.velocity = of_first(V);
            body1.angular_velocity = of_first(w);
        }
        if (!body2.is_static()) {
            body2.velocity = of_second(V);
            body2.angular_velocity = of_second(w);
        }
    }

    ContactProblem& problem_;
    const Island& island_;
    std::span<const int> active_;
    UninitializedVector<SweepRow> rows_;
    std::vector<PairRows> pairs_;
    std::vector<Block> blocks_;
};

} // namespace

std::unique_ptr<Sweeps> optimised_sweeps(ContactProblem& problem, const Island& island,
                                         std::span<const int> active)
{
    return std::make_unique<OptimisedSweeps>(problem, island, active);
}

} // namespace rigor
