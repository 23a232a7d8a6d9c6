// SPDX-License-Identifier: MIT
// Shares the load of a body evenly among its supports. The normal impulses of the contacts are
// fitted by a linear function of the position, by the method of least squares. The residuals of
// such a fit have the sum 0 and the moment 0, so the body moves in the same way without them.
#include "rigid/contact/solvers/shared_loads.hpp"

#include <Eigen/QR>

#include <limits>

namespace rigor {

namespace {

// Two normals count as parallel if their difference is at most this long. This limit is far above
// the rounding error of a normal, and so small that the error of the moments does not matter.
constexpr double parallel = 1e-9;
// With fewer contacts than this, balance determines the loads.
constexpr std::size_t fewest_contacts = 3;
// A change of the loads by at most this share of the largest load is rounding, and is left out.
constexpr double rounding = 16 * std::numeric_limits<double>::epsilon();

// The normal of a contact, pointing to the body that can move.
Vector3d normal_to(const ContactConstraint& c, int moving)
{
    return c.body1 == moving ? c.normal : Vector3d(-c.normal);
}

bool is_on_turning_supports(const ContactProblem& problem, const Island& island,
                            std::span<const int> active)
{
    if (island.bodies.size() != 1 || island.pairs.size() < 2 || active.size() < fewest_contacts)
        return false;
    const int body = island.bodies.front();
    const Vector3d n = normal_to(problem.contacts[active.front()], body);
    bool any_turns = false;
    for (int i : active) {
        const ContactConstraint& c = problem.contacts[i];
        if ((normal_to(c, body) - n).norm() > parallel) return false;
        if (c.gap > nearly_touching_gap * c.radius) return false; // it may carry no load
        const Body& support = problem.bodies[c.body1 == body ? c.body2 : c.body1];
        any_turns |= !support.angular_velocity.isZero(0);
    }
    return any_turns;
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
        places_.resize(static_cast<Eigen::Index>(active.size()), 3);
        for (std::size_t k = 0; k < active.size(); ++k) {
            const ContactConstraint& c = problem.contacts[active[k]];
            const Vector3d r = (c.point - body.position) / c.radius;
            places_.row(k) << 1, r.dot(u), r.dot(w);
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
    // Replaces the normal impulses by their linear fit, unless a contact would pull then.
    void share()
    {
        const std::vector<Vector3d> j = sweeps_->impulses();
        Eigen::VectorXd loads(places_.rows());
        for (std::size_t k = 0; k < j.size(); ++k)
            loads[k] = signs_[k] * j[k].dot(n_);
        if (!(loads.maxCoeff() > 0)) return;
        const Eigen::VectorXd shared =
            places_ * places_.completeOrthogonalDecomposition().solve(loads);
        const Eigen::VectorXd change = shared - loads;
        if (shared.minCoeff() < 0 || change.cwiseAbs().maxCoeff() <= rounding * loads.maxCoeff())
            return;
        std::vector<Vector3d> changes;
        for (std::size_t k = 0; k < j.size(); ++k)
            changes.push_back(signs_[k] * change[k] * n_);
        sweeps_->add(changes);
    }

    std::unique_ptr<Sweeps> sweeps_;
    Vector3d n_;                // the normal, pointing to the body
    Eigen::MatrixX3d places_;   // a row for each contact: 1 and its coordinates across the normal
    std::vector<double> signs_; // 1 if the body is body 1 of the contact, else -1
};

} // namespace

std::unique_ptr<Sweeps> with_shared_loads(const ContactProblem& problem, const Island& island,
                                          std::span<const int> active,
                                          std::unique_ptr<Sweeps> sweeps)
{
    if (!is_on_turning_supports(problem, island, active)) return sweeps;
    return std::make_unique<SharedLoads>(problem, island, active, std::move(sweeps));
}

} // namespace rigor
