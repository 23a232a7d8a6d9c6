// SPDX-License-Identifier: MIT
// Assembles the matrix of backward Euler, (1 + α h) M + h (h + β) K, with the corotated stiffness
// K of each element. The analysis makes a block for each pair of nodes that share an element, and
// finds the parts that such pairs connect. Assembly then adds the stiffness of all elements to the
// blocks.
#include "deformable/solvers/block_matrix.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

using Vectors = std::vector<Vector3d>;

void BlockMatrix::analyse(const Elements& elements, int nodes)
{
    nodes_ = nodes;
    std::vector<std::vector<int>> neighbours(nodes);
    for (int i = 0; i < nodes; ++i)
        neighbours[i] = {i}; // also for a node without elements, which a wrong formula may leave
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
    find_parts();
}

void BlockMatrix::find_parts()
{
    part_of_.assign(nodes_, -1);
    parts_ = 0;
    // Collect the neighbors with lower and with higher indices, because a row of the matrix stores
    // only the blocks of those with higher ones.
    std::vector<std::vector<int>> neighbours(nodes_);
    for_each_block([&](int i, int j, const Matrix3d&) {
        neighbours[i].push_back(j);
        neighbours[j].push_back(i);
    });
    std::vector<int> open;
    for (int first = 0; first < nodes_; ++first) {
        if (part_of_[first] >= 0) continue;
        open.assign(1, first);
        part_of_[first] = parts_;
        while (!open.empty()) {
            const int i = open.back();
            open.pop_back();
            for (const int j : neighbours[i]) {
                if (part_of_[j] >= 0) continue;
                part_of_[j] = parts_;
                open.push_back(j);
            }
        }
        ++parts_;
    }
}

void BlockMatrix::assemble(const Elements& elements, const std::vector<ElementStrain>& strains,
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
        std::array<Vector3d, 4> a; // R ∇N of each corner
        for (int i = 0; i < 4; ++i)
            a[i] = strains[e].R * gradients[i];
        const double w = factor * elements.volume(e);
        const auto t = elements.nodes(e);
        for (int i = 0, k = 0; i < 4; ++i)
            for (int j = i; j < 4; ++j, ++k) {
                // K_ij = w (λ aᵢ aⱼᵀ + G aⱼ aᵢᵀ + G aᵢ·aⱼ δ), with w = h (h + β) V
                const Matrix3d outer = a[i] * a[j].transpose();
                Matrix3d K = w * lambda * outer + w * G * outer.transpose();
                K.diagonal().array() += w * G * outer.trace();
                Matrix3d& block = blocks_[places_[e][k]];
                if (t[i] <= t[j])
                    block += K;
                else
                    block += K.transpose();
            }
    }
}

void BlockMatrix::soften(const Elements& elements, const Matrix3d& R, const ElementFlow& flow,
                         double factor)
{
    const auto gradients = elements.gradients(flow.element);
    const auto t = elements.nodes(flow.element);
    std::array<Vector3d, 4> g, n, kept; // for each corner: R ∇N, R n ∇N, R k ∇N
    for (int i = 0; i < 4; ++i) {
        g[i] = R * gradients[i];
        n[i] = R * (flow.along * gradients[i]);
        kept[i] = R * (flow.kept * gradients[i]);
    }
    const double V = factor * elements.volume(flow.element), a = flow.softened;
    for (int i = 0, k = 0; i < 4; ++i)
        for (int j = i; j < 4; ++j, ++k) {
            const Matrix3d outer = g[i] * g[j].transpose();
            Matrix3d K = 0.5 * outer.transpose() - 1.0 / 3 * outer - kept[i] * kept[j].transpose();
            K.diagonal().array() += 0.5 * outer.trace();
            K = V * (a * K + n[i] * n[j].transpose());
            Matrix3d& block = blocks_[places_[flow.element][k]];
            if (t[i] <= t[j])
                block -= K;
            else
                block -= K.transpose();
        }
}

void BlockMatrix::stiffen(const Elements& elements, const TurnStiffness& term, double time_step)
{
    const auto t = elements.nodes(term.element);
    for (int i = 0, k = 0; i < 4; ++i)
        for (int j = i; j < 4; ++j, ++k) {
            const int low = t[i] <= t[j] ? i : j, high = t[i] <= t[j] ? j : i;
            blocks_[places_[term.element][k]] +=
                time_step * time_step * term.c[low] * term.c[high].transpose();
        }
}

double BlockMatrix::quadratic_form(const Vectors& x) const
{
    double sum = 0;
    for_each_block(
        [&](int i, int j, const Matrix3d& A) { sum += (i == j ? 1 : 2) * x[i].dot(A * x[j]); });
    return sum;
}

void BlockMatrix::multiply(const std::vector<int>& nodes, const Vectors& x, Vectors& y) const
{
    for (const int i : nodes)
        y[i].setZero();
    for (const int i : nodes) {
        const double x0 = x[i][0], x1 = x[i][1], x2 = x[i][2];
        const double* D = blocks_[diagonal_[i]].data();
        double s0 = D[0] * x0 + D[3] * x1 + D[6] * x2, s1 = D[1] * x0 + D[4] * x1 + D[7] * x2,
               s2 = D[2] * x0 + D[5] * x1 + D[8] * x2;
        for (int k = row_starts_[i] + 1; k < row_starts_[i + 1]; ++k) {
            const double *A = blocks_[k].data(), *v = x[columns_[k]].data();
            s0 += A[0] * v[0] + A[3] * v[1] + A[6] * v[2];
            s1 += A[1] * v[0] + A[4] * v[1] + A[7] * v[2];
            s2 += A[2] * v[0] + A[5] * v[1] + A[8] * v[2];
            double* w = y[columns_[k]].data(); // add Aᵀ x: Aᵀ is the block below the diagonal
            w[0] += A[0] * x0 + A[1] * x1 + A[2] * x2;
            w[1] += A[3] * x0 + A[4] * x1 + A[5] * x2;
            w[2] += A[6] * x0 + A[7] * x1 + A[8] * x2;
        }
        y[i] += Vector3d(s0, s1, s2);
    }
}

} // namespace rigor
