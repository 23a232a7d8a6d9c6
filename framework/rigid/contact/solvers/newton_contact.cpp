// SPDX-License-Identifier: MIT
// The augmented Lagrangian method of Alart and Curnier (1991) for the contacts of an island. In
// each round, Newton's method with a line search finds the velocities that minimize a convex
// function, with the friction limits held fixed. Then the impulses and friction limits are updated
// and the penalty weight grows. The rounds end when the impulses no longer change.
#include "rigid/contact/solvers/newton_contact.hpp"

#include "rigid/bodies/height_order.hpp"
#include "rigid/contact/solvers/newton_row.hpp"

#include <Eigen/Sparse>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace rigor {

namespace {

using namespace newton;
using Eigen::VectorXd;

// The penalty ρ of a contact is a weight divided by nᵀKn. A round divides a velocity error by about
// the weight. But with a large weight, Newton's method finds which contacts touch and which slide
// only if it starts close to the solution. So the weight is `first_weight` in the first round and
// is multiplied by `growth` after each round, up to a last weight of at least `least_last_weight`.
constexpr double first_weight = 1000, least_last_weight = 1e6, growth = 10;
// A heavy body that rests on a light one feels only a small part of the penalty. Therefore the last
// weight is multiplied by `light` times `largest_ratio()`, if this product is above 1.
constexpr double light = 1e-3;
// Limits that bound the run time; islands that can be solved need fewer rounds and steps. After 30
// bisections the error of the step length t, which lies in [0, 1], is at most 1e-9.
constexpr int most_rounds = 14, most_steps = 40, most_bisections = 30;
// An inverse inertia J counts as singular if det J is at most `singular_determinant` |J|³. Then
// `least_inverse_inertia` |J| is added to its diagonal. About an axis with zero inverse inertia,
// this stands for a moment of inertia so large that the body hardly turns. A point mass has J = 0;
// for it, 1/(M · 1 m²) replaces |J|, where M is its mass.
constexpr double singular_determinant = 1e-12, least_inverse_inertia = 1e-9;
// The 1 m² in 1/(M · 1 m²), which gives 1/M the unit of an inverse inertia. It is so large that a
// point mass hardly turns: for a contact with a lever arm of 100 m, rotation adds only 1e-5/M to
// the compliance 1/M.
constexpr double point_area = 1;  // [m²]
constexpr double settled = 1e-13; // largest relative change of impulses that ends the rounds
// Once the penalty weight has its last value, each round must reduce the change of the impulses to
// at most this share of the change in the round before. Otherwise more rounds do not help, and the
// method ends.
constexpr double gain = 0.5;
// A line search ends where the slope of Φ has fallen to this share of the slope at the start of the
// search. With a smaller share the search takes more bisections; with a larger share Newton's
// method takes more steps.
constexpr double flat = 0.1;
// Newton's method ends when a step changes velocities by at most this share of the largest
// velocity.
constexpr double converged = 1e-13;
// Rounding error of a velocity, relative to the highest speed. A round computes j - ρ u (j:
// impulse, u: velocity error of a contact), which multiplies the rounding error by ρ =
// weight/(nᵀKn). So the rounds end where the impulses change velocities by at most the weight times
// this error (`rounding` in `solve`).
constexpr double u_rounding = 1e-15;

// Indices in `island.bodies`, sorted by the height of the bodies from the lowest up. The order does
// not depend on how the bodies are numbered, except for bodies with equal sort keys
// (`HeightOrder::Key`).
std::vector<int> from_the_lowest(const ContactProblem& problem, const Island& island)
{
    std::vector<int> indices(island.bodies.size());
    std::iota(indices.begin(), indices.end(), 0);
    const auto position = [&](int i) -> const Vector3d& {
        return problem.bodies[island.bodies[i]].position;
    };
    const HeightOrder key_of(problem.settings.gravity, indices, position);
    std::sort(indices.begin(), indices.end(), [&](int i, int j) {
        return std::pair(key_of(position(i)), i) < std::pair(key_of(position(j)), j);
    });
    return indices;
}

// Minus the part of v₁ - v₂ that comes from static and driven bodies, in a frame with the velocity
// V [m/s]. These bodies have no unknowns and no impulse changes their velocities, so this part
// belongs to the target velocity s of the contact.
Vector3d surface_velocity(const ContactProblem& problem, const ContactConstraint& c,
                          const Vector3d& V)
{
    Vector3d v = Vector3d::Zero();
    for (const auto& [i, sign] : {std::pair(c.body1, 1.0), std::pair(c.body2, -1.0)}) {
        const Body& body = problem.bodies[i];
        if (!body.is_static()) continue;
        v -= sign * (body.velocity - V + body.angular_velocity.cross(c.point - body.position));
    }
    return v;
}

class Newton {
public:
    Newton(const ContactProblem& problem, const Island& island, const std::vector<Body>& free,
           std::span<const int> active, const std::vector<Vector3d>& impulses)
    {
        std::vector<int> unknowns(problem.bodies.size(), -1);
        for (int k : from_the_lowest(problem, island)) {
            unknowns[island.bodies[k]] = static_cast<int>(bodies_.size());
            bodies_.push_back(&free[k]);
        }
        // All velocities are relative to the velocity V of the ground. So if the whole scene moves,
        // the velocities stay the same, and so do the tolerances that are relative to them.
        const Vector3d V = problem.grounds_of(island).front().velocity;
        const auto n = static_cast<Eigen::Index>(6 * bodies_.size());
        v_free_.resize(n);
        for (std::size_t i = 0; i < bodies_.size(); ++i) {
            v_free_.segment<3>(6 * i) = bodies_[i]->velocity - V;
            v_free_.segment<3>(6 * i + 3) = bodies_[i]->angular_velocity;
            // If a body cannot rotate about an axis, its inverse inertia is singular. A tiny value
            // on the diagonal stands for a very large moment of inertia about that axis.
            const Matrix3d& J = bodies_[i]->inverse_inertia;
            const bool can_turn = J.determinant() > singular_determinant * std::pow(J.norm(), 3);
            const bool is_point = J.isZero(0);
            const double size = is_point ? bodies_[i]->inverse_mass / point_area : J.norm();
            const double least = can_turn ? 0 : least_inverse_inertia * size;
            inertias_.push_back((J + least * Matrix3d::Identity()).inverse());
        }
        for (std::size_t k = 0; k < active.size(); ++k) {
            const ContactConstraint& c = problem.contacts[active[k]];
            NewtonRow row;
            row.body1 = unknowns[c.body1];
            row.body2 = unknowns[c.body2];
            row.n = c.normal;
            row.r1 = c.point - problem.bodies[c.body1].position;
            row.r2 = c.point - problem.bodies[c.body2].position;
            row.s = c.target_speed * c.normal + surface_velocity(problem, c, V);
            row.friction = c.friction;
            row.normal_K = c.normal_K;
            row.j = impulses[k];
            rows_.push_back(row);
        }
        levers_.resize(bodies_.size(), 0.0);
        for (const NewtonRow& row : rows_)
            for (const auto& [body, r] :
                 {std::pair(row.body1, row.r1), std::pair(row.body2, row.r2)})
                if (body >= 0) levers_[body] = std::max(levers_[body], r.norm());
        v_ = v_free_ + velocity_change();
        last_weight_ = least_last_weight * std::max(1.0, light * largest_ratio());
    }

    bool solve()
    {
        double weight = first_weight, before = std::numeric_limits<double>::infinity();
        for (int round = 0; round < most_rounds; ++round) {
            for (NewtonRow& row : rows_) {
                row.rho = weight / row.normal_K;
                row.limit = row.friction * std::max(0.0, row.j.dot(row.n));
            }
            if (!minimise()) return round > 0;
            double change = 0, total = 0, speed = 0;
            for (NewtonRow& row : rows_) {
                const Vector3d last = row.j;
                row.j = projected(row, row.j - row.rho * u(row, v_, row.s));
                change = std::max(change, row.normal_K * (row.j - last).norm());
                total = std::max(total, row.normal_K * row.j.norm());
                speed = std::max({speed, velocity(v_, row.body1, row.r1).norm(),
                                  velocity(v_, row.body2, row.r2).norm()});
            }
            const double rounding = u_rounding * weight * speed;
            if (change <= settled * total + rounding) break;
            // If no velocities satisfy all contacts, a velocity error remains, and the impulses
            // would grow in every round.
            if (weight == last_weight_ && change > gain * before) break;
            before = weight == last_weight_ ? change : std::numeric_limits<double>::infinity();
            weight = std::min(last_weight_, growth * weight);
        }
        return true;
    }

    const std::vector<NewtonRow>& rows() const { return rows_; }

private:
    // The largest mass of a body, divided by the smallest effective mass 1/(nᵀKn) of a contact.
    double largest_ratio() const
    {
        double most_mass = 0, most_K = 0;
        for (const Body* body : bodies_)
            most_mass = std::max(most_mass, 1 / body->inverse_mass);
        for (const NewtonRow& row : rows_)
            most_K = std::max(most_K, row.normal_K);
        return most_mass * most_K;
    }

    // The change of all velocities by the current impulses j of the rows: M⁻¹ Jᵀ j, where M is the
    // mass matrix and J v are the relative velocities at the contacts.
    VectorXd velocity_change() const
    {
        VectorXd change = VectorXd::Zero(v_free_.size());
        for (const NewtonRow& row : rows_) {
            const auto push = [&](int body, const Vector3d& r, const Vector3d& j) {
                if (body < 0) return;
                change.segment<3>(6 * body) += bodies_[body]->inverse_mass * j;
                change.segment<3>(6 * body + 3) += bodies_[body]->inverse_inertia * r.cross(j);
            };
            push(row.body1, row.r1, row.j);
            push(row.body2, row.r2, -row.j);
        }
        return change;
    }

    // Line search along dv for the minimum of Φ(v) = ½ (v - v_free)ᵀ M (v - v_free) + Σ φ(y). Here
    // M is the mass matrix, y = j - ρ u(v) with the velocity error u(v) = J v - s of a contact, and
    // φ is the convex function with the gradient P/ρ. The slope of Φ at v + t dv,
    //
    //     dvᵀ M (v + t dv - v_free) - Σ P(y - t ρ du)·du,   du = J dv
    //
    // never decreases with t, so bisection finds where it becomes zero.
    // @return t in [0, 1]
    double line_search(const VectorXd& dv) const
    {
        double start = 0, growing = 0;
        for (std::size_t i = 0; i < bodies_.size(); ++i) {
            const Vector3d V = dv.segment<3>(6 * i), w = dv.segment<3>(6 * i + 3);
            const Vector3d MV = V / bodies_[i]->inverse_mass, Iw = inertias_[i] * w;
            start += MV.dot(v_.segment<3>(6 * i) - v_free_.segment<3>(6 * i)) +
                     Iw.dot(v_.segment<3>(6 * i + 3) - v_free_.segment<3>(6 * i + 3));
            growing += MV.dot(V) + Iw.dot(w);
        }
        std::vector<Vector3d> y, du;
        for (const NewtonRow& row : rows_) {
            y.push_back(row.j - row.rho * u(row, v_, row.s));
            du.push_back(u(row, dv, Vector3d::Zero()));
        }
        const auto slope = [&](double t) {
            double sum = start + t * growing;
            for (std::size_t k = 0; k < rows_.size(); ++k)
                sum -= projected(rows_[k], y[k] - t * rows_[k].rho * du[k]).dot(du[k]);
            return sum;
        };
        if (slope(1) <= 0) return 1;
        const double enough = flat * slope(0);
        double low = 0, high = 1;
        for (int i = 0; i < most_bisections; ++i) {
            const double middle = (low + high) / 2, there = slope(middle);
            (there <= 0 ? low : high) = middle;
            if (there <= 0 && there >= enough) break;
        }
        return low;
    }

    // Gradient and Hessian H of Φ (see `line_search`) at v.
    void linearise(VectorXd& gradient, Eigen::SparseMatrix<double>& H) const
    {
        gradient = VectorXd::Zero(v_.size());
        std::vector<Matrix6d> diagonal(bodies_.size(), Matrix6d::Zero());
        for (std::size_t i = 0; i < bodies_.size(); ++i) {
            const double mass = 1 / bodies_[i]->inverse_mass;
            diagonal[i].topLeftCorner<3, 3>() = mass * Matrix3d::Identity();
            diagonal[i].bottomRightCorner<3, 3>() = inertias_[i];
            gradient.segment<6>(6 * i) =
                diagonal[i] * (v_.segment<6>(6 * i) - v_free_.segment<6>(6 * i));
        }
        std::vector<Eigen::Triplet<double>> entries;
        // Sum of the 6 × 6 blocks by which the contacts of one pair couple its two bodies. The
        // rows of a pair follow each other in `rows_`.
        Matrix6d coupling = Matrix6d::Zero();
        for (std::size_t k = 0; k < rows_.size(); ++k) {
            const NewtonRow& row = rows_[k];
            const auto [body1, body2] = std::pair(row.body1, row.body2);
            const Vector3d y = row.j - row.rho * u(row, v_, row.s);
            const Vector3d p = projected(row, y);
            const Matrix3d D = row.rho * slope(row, y);
            if (body1 >= 0) {
                gradient.segment<3>(6 * body1) -= p;
                gradient.segment<3>(6 * body1 + 3) -= row.r1.cross(p);
                add_product(row.r1, D, row.r1, diagonal[body1]);
            }
            if (body2 >= 0) {
                gradient.segment<3>(6 * body2) += p;
                gradient.segment<3>(6 * body2 + 3) += row.r2.cross(p);
                add_product(row.r2, D, row.r2, diagonal[body2]);
            }
            if (body1 < 0 || body2 < 0) continue;
            const bool is_first_lower = body1 > body2; // only the lower half of H is stored
            add_product(is_first_lower ? row.r1 : row.r2, -D, is_first_lower ? row.r2 : row.r1,
                        coupling);
            const bool is_last =
                k + 1 == rows_.size() || rows_[k + 1].body1 != body1 || rows_[k + 1].body2 != body2;
            if (!is_last) continue;
            add_block(std::max(body1, body2), std::min(body1, body2), coupling, entries);
            coupling.setZero();
        }
        for (std::size_t i = 0; i < bodies_.size(); ++i)
            add_block(static_cast<int>(i), static_cast<int>(i), diagonal[i], entries);
        H.resize(v_.size(), v_.size());
        H.setFromTriplets(entries.begin(), entries.end());
    }

    static void add_block(int row, int column, const Matrix6d& block,
                          std::vector<Eigen::Triplet<double>>& entries)
    {
        for (int i = 0; i < 6; ++i)
            for (int j = 0; j < (row == column ? i + 1 : 6); ++j)
                entries.emplace_back(6 * row + i, 6 * column + j, block(i, j));
    }

    // sum += Jᵀ(r) D J(q), where J(r) = (δ, -r*) maps (V, ω) to the velocity at the end of the
    // lever arm r. Here δ is the identity, and r* is the matrix with r* a = r × a.
    static void add_product(const Vector3d& r, const Matrix3d& D, const Vector3d& q, Matrix6d& sum)
    {
        Matrix3d Dq; // D q*
        Dq.col(0) = q.z() * D.col(1) - q.y() * D.col(2);
        Dq.col(1) = q.x() * D.col(2) - q.z() * D.col(0);
        Dq.col(2) = q.y() * D.col(0) - q.x() * D.col(1);
        sum.topLeftCorner<3, 3>() += D;
        sum.topRightCorner<3, 3>() -= Dq;
        for (int i = 0; i < 3; ++i) { // r* D and r* (D q*), column by column
            sum.block<3, 1>(3, i) += r.cross(Vector3d(D.col(i)));
            sum.block<3, 1>(3, 3 + i) -= r.cross(Vector3d(Dq.col(i)));
        }
    }

    // Finds the v that minimizes Φ in this round, by Newton's method.
    // @return whether the method converged
    bool minimise()
    {
        VectorXd gradient;
        Eigen::SparseMatrix<double> H;
        for (int step = 0; step < most_steps; ++step) {
            linearise(gradient, H);
            if (!is_analysed_) solver_.analyzePattern(H); // H always has the same pattern
            is_analysed_ = true;
            solver_.factorize(H);
            if (solver_.info() != Eigen::Success) return false;
            const VectorXd dv = -solver_.solve(gradient);
            if (!dv.allFinite()) return false;
            const double t = line_search(dv);
            v_ += t * dv;
            const double size = largest_speed(v_) + largest_speed(v_free_);
            const double moved = t * largest_speed(dv);
            if (moved <= converged * size) return true;
            if (step + 1 == most_steps && moved <= settled * size) return true;
        }
        return false;
    }

    // The largest component of a velocity V or of r ω, where r is the length of the body's longest
    // lever arm [m/s].
    double largest_speed(const VectorXd& v) const
    {
        double largest = 0;
        for (std::size_t i = 0; i < bodies_.size(); ++i)
            largest = std::max({largest, v.segment<3>(6 * i).cwiseAbs().maxCoeff(),
                                levers_[i] * v.segment<3>(6 * i + 3).cwiseAbs().maxCoeff()});
        return largest;
    }

    std::vector<const Body*> bodies_;
    std::vector<double> levers_;     // for each body, the length of its longest lever arm [m]
    std::vector<Matrix3d> inertias_; // inertia tensors in world space, all of them finite
    std::vector<NewtonRow> rows_;
    // V and ω of each body: `v_free_` before the contact stage, `v_` in the current iteration.
    VectorXd v_free_, v_;
    double last_weight_ = least_last_weight;
    Eigen::SimplicialLLT<Eigen::SparseMatrix<double>> solver_;
    bool is_analysed_ = false;
};

} // namespace

bool newton_impulses(const ContactProblem& problem, const Island& island,
                     const std::vector<Body>& free, std::span<const int> active,
                     std::vector<Vector3d>& impulses)
{
    Newton newton(problem, island, free, active, impulses);
    if (!newton.solve()) return false;
    for (std::size_t k = 0; k < impulses.size(); ++k) {
        const Vector3d& j = newton.rows()[k].j;
        if (!j.allFinite()) return false;
        impulses[k] = j;
    }
    return true;
}

} // namespace rigor
