// SPDX-License-Identifier: MIT
// Shares the load of a body evenly among its supports. The normal impulses of the contacts that
// carry load are fitted by a linear function of the position, by the method of least squares. The
// residual of such a fit has no sum and no moment, so it can be removed without any effect on the
// body's motion.
#include "rigid/contact/solvers/shared_loads.hpp"

#include <Eigen/QR>

#include <algorithm>
#include <limits>

namespace rigor {

namespace {

// Two normals count as parallel if their difference is at most this long. It is far above the
// rounding error of a normal, and so small that the error of the moments does not matter.
constexpr double parallel = 1e-9;
// With fewer contacts than this, balance determines the loads.
constexpr std::size_t fewest_contacts = 3;
// A change of the loads by at most this share of the largest one is rounding, and is left out.
constexpr double rounding = 16 * std::numeric_limits<double>::epsilon();

// The normal of a contact, pointing to the body that can move.
Vector3d normal_to(const ContactConstraint& c, int moving)
{
    return c.body1 == moving ? c.normal : Vector3d(-c.normal);
}

bool is_on_parallel_supports(const ContactProblem& problem, const Island& island,
                             std::span<const int> active)
{
    if (island.bodies.size() != 1 || island.pairs.size() < 2 || active.size() < fewest_contacts)
        return false;
    const int moving = island.bodies.front();
    const Vector3d n = normal_to(problem.contacts[active.front()], moving);
    return std::all_of(active.begin(), active.end(), [&](int i) {
        return (normal_to(problem.contacts[i], moving) - n).norm() <= parallel;
    });
}

class SharedLoads : public Sweeps {
public:
    SharedLoads(const ContactProblem& problem, const Island& island, std::span<const int> active,
                std::unique_ptr<Sweeps> sweeps)
        : sweeps_(std::move(sweeps)),
          n_(normal_to(problem.contacts[active.front()], island.bodies.front()))
    {
        const Body& body = problem.bodies[island.bodies.front()];
        const Vector3d u = n_.unitOrthogonal(), w = n_.cross(u);
        for (int i : active) {
            const ContactConstraint& c = problem.contacts[i];
            const Vector3d r = c.point - body.position;
            places_.emplace_back(1, r.dot(u) / c.radius, r.dot(w) / c.radius);
            signs_.push_back(c.body1 == island.bodies.front() ? 1 : -1);
        }
    }

    SweepProgress sweep(std::vector<Vector3d>& steps) override
    {
        share();
        return sweeps_->sweep(steps);
    }
    std::vector<Vector3d> impulses() const override { return sweeps_->impulses(); }
    void add(const std::vector<Vector3d>& changes) override { sweeps_->add(changes); }
    void finish() override { sweeps_->finish(); }

private:
    // Replaces the normal impulses of the contacts that carry load by their linear fit, unless a
    // contact would then pull.
    void share()
    {
        const std::vector<Vector3d> j = sweeps_->impulses();
        std::vector<std::size_t> loaded;
        for (std::size_t k = 0; k < j.size(); ++k)
            if (load(j, k) > 0) loaded.push_back(k);
        if (loaded.size() < fewest_contacts) return;
        Eigen::MatrixX3d places(loaded.size(), 3);
        Eigen::VectorXd loads(loaded.size());
        for (std::size_t i = 0; i < loaded.size(); ++i) {
            places.row(i) = places_[loaded[i]];
            loads[i] = load(j, loaded[i]);
        }
        const Eigen::VectorXd shared =
            places * places.completeOrthogonalDecomposition().solve(loads);
        const double change = (shared - loads).cwiseAbs().maxCoeff();
        if (shared.minCoeff() < 0 || change <= rounding * loads.maxCoeff()) return;
        std::vector<Vector3d> changes(j.size(), Vector3d::Zero());
        for (std::size_t i = 0; i < loaded.size(); ++i)
            changes[loaded[i]] = signs_[loaded[i]] * (shared[i] - loads[i]) * n_;
        sweeps_->add(changes);
    }

    double load(const std::vector<Vector3d>& j, std::size_t k) const
    {
        return signs_[k] * j[k].dot(n_);
    }

    std::unique_ptr<Sweeps> sweeps_;
    Vector3d n_;                             // the normal, pointing to the body
    std::vector<Eigen::RowVector3d> places_; // 1 and the coordinates of each contact
    std::vector<double> signs_;              // 1 if the body is body 1 of the contact, else -1
};

} // namespace

std::unique_ptr<Sweeps> with_shared_loads(const ContactProblem& problem, const Island& island,
                                          std::span<const int> active,
                                          std::unique_ptr<Sweeps> sweeps)
{
    if (!is_on_parallel_supports(problem, island, active)) return sweeps;
    return std::make_unique<SharedLoads>(problem, island, active, std::move(sweeps));
}

} // namespace rigor
