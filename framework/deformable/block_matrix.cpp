// SPDX-License-Identifier: MIT
#include "deformable/block_matrix.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

namespace {

using Vectors = std::vector<Vector3d>;

double dot(const Vectors& a, const Vectors& b)
{
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        sum += a[i].dot(b[i]);
    return sum;
}

} // namespace

void ImplicitSystem::analyse(const Elements& elements, int nodes)
{
    nodes_ = nodes;
    std::vector<std::vector<int>> neighbours(nodes);
    for (int e = 0; e < elements.size(); ++e) {
        const auto t = elements.nodes(e);
        for (const int i : t)
            for (const int j : t)
                neighbours[i].push_back(j);
    }
    row_starts_.assign(1, 0);
    columns_.clear();
    diagonal_.resize(nodes);
    for (int i = 0; i < nodes; ++i) {
        auto& row = neighbours[i];
        std::sort(row.begin(), row.end());
        row.erase(std::unique(row.begin(), row.end()), row.end());
        row.erase(row.begin(), std::lower_bound(row.begin(), row.end(), i));
        diagonal_[i] = row_starts_.back();
        columns_.insert(columns_.end(), row.begin(), row.end());
        row_starts_.push_back(static_cast<int>(columns_.size()));
    }
    const auto place = [&](int i, int j) {
        const auto first = columns_.begin() + row_starts_[i],
                   last = columns_.begin() + row_starts_[i + 1];
        return static_cast<int>(std::lower_bound(first, last, j) - columns_.begin());
    };
    blocks_.resize(columns_.size());
    places_.resize(elements.size());
    for (int e = 0; e < elements.size(); ++e) {
        const auto t = elements.nodes(e);
        for (int i = 0, k = 0; i < 4; ++i)
            for (int j = i; j < 4; ++j)
                places_[e][k++] = place(std::min(t[i], t[j]), std::max(t[i], t[j]));
    }
    inverse_diagonal_.resize(nodes);
}

void ImplicitSystem::assemble(const Elements& elements, const std::vector<ElementStrain>& strains,
                              const std::vector<double>& masses, const SolidMaterial& material,
                              double time_step)
{
    const double h = time_step, factor = h * (h + material.damping);
    const double lambda = material.lame_lambda(), G = material.shear_modulus();
    for (Matrix3d& block : blocks_)
        block.setZero();
    for (int i = 0; i < nodes_; ++i)
        blocks_[diagonal_[i]].diagonal().setConstant((1 + h * material.drag) * masses[i]);
    for (int e = 0; e < elements.size(); ++e) {
        const auto gradients = elements.gradients(e);
        std::array<Vector3d, 4> a; // R ∇N
        for (int i = 0; i < 4; ++i)
            a[i] = strains[e].R * gradients[i];
        const double V = factor * elements.volume(e);
        const auto t = elements.nodes(e);
        for (int i = 0, k = 0; i < 4; ++i)
            for (int j = i; j < 4; ++j, ++k) {
                // K_ij = V (λ aᵢ aⱼᵀ + G aⱼ aᵢᵀ + G aᵢ·aⱼ δ)
                const Matrix3d outer = a[i] * a[j].transpose();
                Matrix3d K = V * lambda * outer + V * G * outer.transpose();
                K.diagonal().array() += V * G * outer.trace();
                Matrix3d& block = blocks_[places_[e][k]];
                if (t[i] <= t[j])
                    block += K;
                else
                    block += K.transpose();
            }
    }
}

void ImplicitSystem::multiply(const Vectors& x, Vectors& y) const
{
    std::fill(y.begin(), y.begin() + nodes_, Vector3d::Zero());
    for (int i = 0; i < nodes_; ++i) {
        const double x0 = x[i][0], x1 = x[i][1], x2 = x[i][2];
        const double* D = blocks_[diagonal_[i]].data();
        double s0 = D[0] * x0 + D[3] * x1 + D[6] * x2, s1 = D[1] * x0 + D[4] * x1 + D[7] * x2,
               s2 = D[2] * x0 + D[5] * x1 + D[8] * x2;
        for (int k = row_starts_[i] + 1; k < row_starts_[i + 1]; ++k) {
            const double *A = blocks_[k].data(), *v = x[columns_[k]].data();
            s0 += A[0] * v[0] + A[3] * v[1] + A[6] * v[2];
            s1 += A[1] * v[0] + A[4] * v[1] + A[7] * v[2];
            s2 += A[2] * v[0] + A[5] * v[1] + A[8] * v[2];
            double* w = y[columns_[k]].data(); // by the block below the diagonal, Aᵀ
            w[0] += A[0] * x0 + A[1] * x1 + A[2] * x2;
            w[1] += A[3] * x0 + A[4] * x1 + A[5] * x2;
            w[2] += A[6] * x0 + A[7] * x1 + A[8] * x2;
        }
        y[i] += Vector3d(s0, s1, s2);
    }
    for (std::size_t b = 0; b < bodies_->size(); ++b) {
        y[nodes_ + 2 * b] = (*bodies_)[b].mass * x[nodes_ + 2 * b];
        y[nodes_ + 2 * b + 1] = (*bodies_)[b].inertia * x[nodes_ + 2 * b + 1];
    }
}

// x ← T x: tied coordinates follow their bodies.
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

// x ← Tᵀ x: what acts on tied coordinates acts on their bodies.
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

void ImplicitSystem::prepare_preconditioner(const std::vector<SystemBody>& bodies)
{
    for (int i = 0; i < nodes_; ++i)
        inverse_diagonal_[i] = blocks_[diagonal_[i]].inverse();
    inverse_bodies_.assign(bodies.size(), Matrix6d::Zero());
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        inverse_bodies_[b].topLeftCorner<3, 3>() = bodies[b].mass * Matrix3d::Identity();
        inverse_bodies_[b].bottomRightCorner<3, 3>() = bodies[b].inertia;
    }
    for (const TiedNode& t : *tied_) {
        const Matrix3d& A = blocks_[diagonal_[t.node]];
        const Matrix3d P = Matrix3d::Identity() - t.N;
        const Matrix3d free = P * A * P + A.trace() * t.N;
        inverse_diagonal_[t.node] = P * free.inverse() * P;
        if (t.body < 0) continue;
        Eigen::Matrix<double, 3, 6> J; // of the node's motion with the body
        J << t.N, t.N * Eigen::Matrix3d{
                            {0, t.r.z(), -t.r.y()}, {-t.r.z(), 0, t.r.x()}, {t.r.y(), -t.r.x(), 0}};
        inverse_bodies_[t.body] += J.transpose() * A * J;
    }
    for (Matrix6d& body : inverse_bodies_)
        body = body.inverse().eval();
}

void ImplicitSystem::precondition(const Vectors& r, Vectors& z) const
{
    for (int i = 0; i < nodes_; ++i)
        z[i] = inverse_diagonal_[i] * r[i];
    for (std::size_t b = 0; b < inverse_bodies_.size(); ++b) {
        Eigen::Matrix<double, 6, 1> f;
        f << r[nodes_ + 2 * b], r[nodes_ + 2 * b + 1];
        f = (inverse_bodies_[b] * f).eval();
        z[nodes_ + 2 * b] = f.head<3>();
        z[nodes_ + 2 * b + 1] = f.tail<3>();
    }
}

int ImplicitSystem::solve(const Vectors& b, const std::vector<TiedNode>& tied,
                          std::vector<SystemBody>& bodies, Vectors& velocities)
{
    constexpr double tolerance = 1e-7;
    const std::size_t n = nodes_ + 2 * bodies.size();
    tied_ = &tied;
    bodies_ = &bodies;
    for (Vectors* v : {&x_, &r_, &z_, &p_, &q_})
        v->resize(n);
    prepare_preconditioner(bodies);

    // from a velocity that the ties allow
    std::copy(velocities.begin(), velocities.end(), x_.begin());
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        x_[nodes_ + 2 * i] = bodies[i].V;
        x_[nodes_ + 2 * i + 1] = bodies[i].w;
    }
    expand(x_);
    for (const TiedNode& t : tied)
        x_[t.node] += t.N * t.c;

    std::copy(b.begin(), b.end(), r_.begin());
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        r_[nodes_ + 2 * i] = bodies[i].mass * bodies[i].V;
        r_[nodes_ + 2 * i + 1] = bodies[i].inertia * bodies[i].w;
    }
    precondition(r_, z_);
    const double enough = tolerance * tolerance * dot(r_, z_);
    multiply(x_, q_);
    for (std::size_t i = 0; i < n; ++i)
        r_[i] -= q_[i];
    reduce(r_);
    precondition(r_, z_);
    p_ = z_;
    double rz = dot(r_, z_);
    const int most = 10 * static_cast<int>(n) + 100;
    int iterations = 0;
    for (; rz > enough && iterations < most; ++iterations) {
        expand(p_);
        multiply(p_, q_);
        reduce(q_);
        const double pq = dot(p_, q_); // tied coordinates of q are 0
        if (!(pq > 0)) break;
        const double a = rz / pq;
        for (std::size_t i = 0; i < n; ++i) {
            x_[i] += a * p_[i];
            r_[i] -= a * q_[i];
        }
        precondition(r_, z_);
        const double rz_new = dot(r_, z_);
        const double beta = rz_new / rz;
        rz = rz_new;
        for (std::size_t i = 0; i < n; ++i)
            p_[i] = z_[i] + beta * p_[i];
    }
    std::copy(x_.begin(), x_.begin() + nodes_, velocities.begin());
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        bodies[i].V = x_[nodes_ + 2 * i];
        bodies[i].w = x_[nodes_ + 2 * i + 1];
    }
    return iterations;
}

const Vectors& ImplicitSystem::missing(const Vectors& b, const Vectors& velocities)
{
    std::copy(velocities.begin(), velocities.end(), x_.begin());
    multiply(x_, q_);
    for (int i = 0; i < nodes_; ++i)
        q_[i] -= b[i];
    return q_;
}

} // namespace rigor
