// SPDX-License-Identifier: MIT
// Solves the system of backward Euler by preconditioned conjugate gradients (Hestenes and Stiefel
// 1952). Coordinates that a handle or a contact prescribes ("ties", see ties.hpp) are projected out
// in each iteration, as in Baraff and Witkin 1998, "Large steps in cloth simulation". First comes
// the preconditioner, a factorization of A with the ties or the inverse diagonal blocks, then a
// start that satisfies the ties, then the iterations.
#include "deformable/solvers/implicit_system.hpp"

#include "deformable/solid/rigid_motion.hpp"

#include <algorithm>

namespace rigor {

using Vectors = std::vector<Vector3d>;

namespace {

// (P, L) = mass · (V, ω). `momentum` points to P and L.
void set_momentum(const Matrix6d& mass, const Vector3d& V, const Vector3d& w, Vector3d* momentum)
{
    momentum[0] = mass.topLeftCorner<3, 3>() * V + mass.topRightCorner<3, 3>() * w;
    momentum[1] = mass.bottomLeftCorner<3, 3>() * V + mass.bottomRightCorner<3, 3>() * w;
}

} // namespace

void ImplicitSystem::analyse(const Elements& elements, int nodes)
{
    matrix_.analyse(elements, nodes);
    nodes_ = nodes;
    inverse_diagonal_.resize(nodes);
    // The largest number of products of two blocks that a factorization may take, divided by the
    // number of stored blocks of A. A product of two blocks costs as much as three products of a
    // block and a vector. An iteration of conjugate gradients takes two products of a block and a
    // vector for each stored block. So the limit is the cost of 40 · 3 / 2 = 60 iterations; above
    // it, iterating is cheaper.
    constexpr double most_work = 40;
    is_factor_cheap_ = factor_.analyse(matrix_.row_starts(), matrix_.columns(),
                                       most_work * static_cast<double>(matrix_.blocks().size()));
    if (!is_factor_cheap_) return;
    tied_blocks_.resize(matrix_.blocks().size());
    free_.resize(nodes);
    is_tied_.resize(nodes);
}

void ImplicitSystem::multiply(const Vectors& x, Vectors& y) const
{
    matrix_.multiply(*active_, x, y);
    for (std::size_t b = 0; b < bodies_->size(); ++b) {
        set_momentum((*bodies_)[b].mass, x[nodes_ + 2 * b], x[nodes_ + 2 * b + 1],
                     &y[nodes_ + 2 * b]);
    }
}

double ImplicitSystem::dot(const Vectors& a, const Vectors& b) const
{
    double sum = 0;
    for (const int i : *active_)
        sum += a[i].dot(b[i]);
    for (std::size_t i = nodes_; i < nodes_ + 2 * bodies_->size(); ++i)
        sum += a[i].dot(b[i]);
    return sum;
}

// x ← T x, where T gives each tied (prescribed) coordinate the velocity of the body that prescribes
// it, or 0 if no body does.
void ImplicitSystem::expand(Vectors& x) const
{
    for (const TiedNode& t : *tied_) {
        Vector3d& v = x[t.node];
        v -= t.N * v;
        if (t.body < 0) continue;
        const Vector3d &V = x[nodes_ + 2 * t.body], &w = x[nodes_ + 2 * t.body + 1];
        v += t.N * (V + w.cross(t.r));
    }
}

// x ← Tᵀ x: an impulse on a tied coordinate acts on the body to which it is tied.
void ImplicitSystem::reduce(Vectors& x) const
{
    for (const TiedNode& t : *tied_) {
        const Vector3d f = t.N * x[t.node];
        x[t.node] -= f;
        if (t.body < 0) continue;
        x[nodes_ + 2 * t.body] += f;
        x[nodes_ + 2 * t.body + 1] += t.r.cross(f);
    }
}

// What the damping of a tie adds to A x: d (δ - N) (v - V - ω × r), with the letters of ties.hpp.
Vector3d ImplicitSystem::damping_impulse(const TiedNode& t, const Vectors& x) const
{
    Vector3d v = x[t.node];
    if (t.body >= 0) v -= x[nodes_ + 2 * t.body] + x[nodes_ + 2 * t.body + 1].cross(t.r);
    return t.damping * (v - t.N * v);
}

void ImplicitSystem::add_damping(const Vectors& x, Vectors& y) const
{
    for (const TiedNode& t : *tied_) {
        if (t.damping == 0) continue;
        const Vector3d f = damping_impulse(t, x);
        y[t.node] += f;
        if (t.body < 0) continue;
        y[nodes_ + 2 * t.body] -= f;
        y[nodes_ + 2 * t.body + 1] -= t.r.cross(f);
    }
}

// Factorizes P (A + d) P + s N, which is A with the ties applied, for the active nodes. N projects
// on the tied directions of a node, and P = δ - N on the others, with the unit matrix δ. d is the
// damping of the node's tie, and s the trace of the node's diagonal block of A.
void ImplicitSystem::factorise()
{
    for (const int i : *active_) {
        free_[i].setIdentity();
        is_tied_[i] = 0;
    }
    for (const TiedNode& t : *tied_) {
        free_[t.node] = free_[t.node] * (Matrix3d::Identity() - t.N);
        is_tied_[t.node] = 1;
    }
    const auto& row_starts = matrix_.row_starts();
    const auto& blocks = matrix_.blocks();
    for (const int i : *active_)
        for (int k = row_starts[i]; k < row_starts[i + 1]; ++k) {
            const int j = matrix_.columns()[k];
            tied_blocks_[k] = blocks[k];
            if (!is_tied_[i] && !is_tied_[j]) continue;
            tied_blocks_[k] = free_[i].transpose() * blocks[k] * free_[j];
            if (i == j) tied_blocks_[k] += blocks[k].trace() * (Matrix3d::Identity() - free_[i]);
        }
    for (const TiedNode& t : *tied_)
        tied_blocks_[matrix_.diagonal_place(t.node)] += t.damping * free_[t.node];
    factor_.steps_of(*active_, steps_);
    factor_.factorise(steps_, tied_blocks_);
}

void ImplicitSystem::prepare_preconditioner(const std::vector<SystemBody>& bodies)
{
    if (is_factor_cheap_)
        factorise();
    else
        for (const int i : *active_)
            inverse_diagonal_[i] = matrix_.diagonal(i).inverse();
    inverse_bodies_.assign(bodies.size(), Matrix6d::Zero());
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        inverse_bodies_[b] = bodies[b].mass;
    }
    for (const TiedNode& t : *tied_) {
        const Matrix3d& A = matrix_.diagonal(t.node);
        if (!is_factor_cheap_) {
            const Matrix3d P = Matrix3d::Identity() - t.N;
            const Matrix3d free = P * A * P + t.damping * P + A.trace() * t.N;
            inverse_diagonal_[t.node] = P * free.inverse() * P;
        }
        if (t.body < 0) continue;
        const Matrix36d J = point_jacobian(t.r);
        const Matrix3d held = t.N * A * t.N + t.damping * (Matrix3d::Identity() - t.N);
        inverse_bodies_[t.body] += J.transpose() * held * J;
    }
    for (Matrix6d& body : inverse_bodies_)
        body = body.inverse().eval();
}

void ImplicitSystem::precondition(const Vectors& r, Vectors& z) const
{
    if (is_factor_cheap_) {
        for (const int i : *active_)
            z[i] = r[i];
        factor_.solve(steps_, z);
        for (const TiedNode& t : *tied_)
            z[t.node] -= t.N * z[t.node];
    } else {
        for (const int i : *active_)
            z[i] = inverse_diagonal_[i] * r[i];
    }
    for (std::size_t b = 0; b < inverse_bodies_.size(); ++b) {
        const Vector6d f = inverse_bodies_[b] * stacked(r[nodes_ + 2 * b], r[nodes_ + 2 * b + 1]);
        z[nodes_ + 2 * b] = f.head<3>();
        z[nodes_ + 2 * b + 1] = f.tail<3>();
    }
}

int ImplicitSystem::solve(const Vectors& b, const std::vector<int>& nodes,
                          const std::vector<TiedNode>& tied, std::vector<SystemBody>& bodies,
                          Vectors& velocities)
{
    // The iterations end when the residual, divided by the right-hand side, is at most this, both
    // in the norm of the preconditioner. The number is below the tolerances of contacts
    // (contact_set.cpp).
    constexpr double tolerance = 1e-7;
    const std::size_t n = nodes_ + 2 * bodies.size();
    active_ = &nodes;
    tied_ = &tied;
    bodies_ = &bodies;
    for (Vectors* v : {&x_, &r_, &z_, &p_, &q_})
        v->resize(n);
    prepare_preconditioner(bodies);

    // Start from velocities that satisfy the ties.
    for (const int i : nodes) {
        x_[i] = velocities[i];
        r_[i] = b[i];
    }
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        x_[nodes_ + 2 * i] = bodies[i].V;
        x_[nodes_ + 2 * i + 1] = bodies[i].w;
        set_momentum(bodies[i].mass, bodies[i].V, bodies[i].w, &r_[nodes_ + 2 * i]);
    }
    expand(x_);
    for (const TiedNode& t : tied) {
        x_[t.node] += t.N * t.c;
        r_[t.node] += t.damping * (t.c - t.N * t.c);
    }
    precondition(r_, z_);
    const int iterations = iterate(tolerance * tolerance * dot(r_, z_));
    for (const int i : nodes)
        velocities[i] = x_[i];
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        bodies[i].V = x_[nodes_ + 2 * i];
        bodies[i].w = x_[nodes_ + 2 * i + 1];
    }
    return iterations;
}

// Iterates from x_ and r_ = b until r·z is at most `enough`, until rounding errors prevent
// progress, or until `most` iterations are done. @return the number of iterations
int ImplicitSystem::iterate(double enough)
{
    const auto for_each = [&](const auto& visit) {
        for (const int i : *active_)
            visit(i);
        for (int i = nodes_; i < nodes_ + 2 * static_cast<int>(bodies_->size()); ++i)
            visit(i);
    };
    multiply(x_, q_);
    add_damping(x_, q_);
    for_each([&](int i) { r_[i] -= q_[i]; });
    reduce(r_);
    precondition(r_, z_);
    for_each([&](int i) { p_[i] = z_[i]; });
    double rz = dot(r_, z_), least = rz;
    // The iterations end when r·z has grown by this factor since its least value, and the result is
    // then the best x_ so far. Such growth happens where rounding errors keep r·z above `enough`,
    // as in a solid that hardly moves.
    constexpr double most_growth = 1e8;
    best_ = x_;
    const int most = 10 * static_cast<int>(active_->size() + 2 * bodies_->size()) + 100;
    int iterations = 0;
    for (; rz > enough && iterations < most; ++iterations) {
        expand(p_);
        multiply(p_, q_);
        add_damping(p_, q_);
        reduce(q_);
        const double pq = dot(p_, q_); // q_ is 0 in the tied coordinates
        if (!(pq > 0)) break;
        const double a = rz / pq;
        for_each([&](int i) {
            x_[i] += a * p_[i];
            r_[i] -= a * q_[i];
        });
        precondition(r_, z_);
        const double rz_new = dot(r_, z_);
        if (rz_new < least) {
            least = rz_new;
            for_each([&](int i) { best_[i] = x_[i]; });
        } else if (!(rz_new <= most_growth * least)) {
            for_each([&](int i) { x_[i] = best_[i]; });
            break;
        }
        const double beta = rz_new / rz;
        rz = rz_new;
        for_each([&](int i) { p_[i] = z_[i] + beta * p_[i]; });
    }
    return iterations;
}

const Vectors& ImplicitSystem::residual(const Vectors& b, const std::vector<int>& nodes,
                                        const Vectors& velocities)
{
    for (const int i : nodes)
        x_[i] = velocities[i];
    matrix_.multiply(nodes, x_, q_);
    for (const int i : nodes)
        q_[i] -= b[i];
    return q_;
}

} // namespace rigor
