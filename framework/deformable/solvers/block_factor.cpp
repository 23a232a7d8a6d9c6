// SPDX-License-Identifier: MIT
// Computes the factorization A = L D Lᵀ row by row (Davis 2006, "Direct methods for sparse linear
// systems", 4.7). The analysis orders the nodes by approximate minimum degree, grows the
// elimination tree and finds the index at which each block is stored. Factorizing and solving then
// only use these indices.
#include "deformable/solvers/block_factor.hpp"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>

#include <algorithm>
#include <numeric>

namespace rigor {

namespace {

// The order of elimination by approximate minimum degree: for each step, the node eliminated in it.
std::vector<int> elimination_order(const std::vector<int>& row_starts,
                                   const std::vector<int>& columns)
{
    const int n = static_cast<int>(row_starts.size()) - 1;
    std::vector<Eigen::Triplet<double>> entries;
    for (int i = 0; i < n; ++i)
        for (int k = row_starts[i]; k < row_starts[i + 1]; ++k)
            entries.emplace_back(i, columns[k], 1.0);
    Eigen::SparseMatrix<double> pattern(n, n);
    pattern.setFromTriplets(entries.begin(), entries.end());
    Eigen::AMDOrdering<int>::PermutationType order;
    Eigen::AMDOrdering<int>()(pattern.selfadjointView<Eigen::Upper>(), order);
    const auto& steps = order.indices();
    return {steps.data(), steps.data() + steps.size()};
}

} // namespace

bool BlockFactor::analyse(const std::vector<int>& row_starts, const std::vector<int>& columns,
                          double most_work)
{
    place_entries(row_starts, columns);
    if (!grow_tree(most_work)) return false;
    place_rows();
    return true;
}

void BlockFactor::place_entries(const std::vector<int>& row_starts, const std::vector<int>& columns)
{
    const int n = static_cast<int>(row_starts.size()) - 1;
    node_of_ = elimination_order(row_starts, columns);
    step_of_.resize(n);
    for (int k = 0; k < n; ++k)
        step_of_[node_of_[k]] = k;
    diagonal_.resize(n);
    entry_starts_.assign(n + 1, 0);
    const auto for_each = [&](const auto& visit) {
        for (int i = 0; i < n; ++i)
            for (int k = row_starts[i]; k < row_starts[i + 1]; ++k)
                visit(step_of_[i], step_of_[columns[k]], k);
    };
    for_each([&](int a, int b, int k) {
        if (a == b)
            diagonal_[a] = k;
        else
            ++entry_starts_[std::max(a, b) + 1];
    });
    std::partial_sum(entry_starts_.begin(), entry_starts_.end(), entry_starts_.begin());
    entries_.resize(entry_starts_.back());
    std::vector<int> next = entry_starts_;
    for_each([&](int a, int b, int k) {
        if (a != b) entries_[next[std::max(a, b)]++] = {std::min(a, b), k, a < b};
    });
}

// Grows the elimination tree and counts the blocks in each column of L. The blocks of row k of L
// are in those columns that lie on the paths up the tree from the columns of row k of A to k.
bool BlockFactor::grow_tree(double most_work)
{
    const int n = static_cast<int>(diagonal_.size());
    parent_.assign(n, -1);
    std::vector<int> seen(n, -1), counts(n, 0);
    work_ = 0;
    for (int k = 0; k < n && work_ <= most_work; ++k) {
        seen[k] = k;
        for (int e = entry_starts_[k]; e < entry_starts_[k + 1]; ++e)
            for (int i = entries_[e].column; seen[i] != k; i = parent_[i]) {
                if (parent_[i] < 0) parent_[i] = k;
                seen[i] = k;
                work_ += 2 + counts[i]++;
            }
    }
    column_starts_.assign(n + 1, 0);
    std::partial_sum(counts.begin(), counts.end(), column_starts_.begin() + 1);
    return work_ <= most_work;
}

void BlockFactor::place_rows()
{
    const int n = static_cast<int>(diagonal_.size());
    rows_.resize(column_starts_.back());
    row_blocks_.clear();
    row_blocks_.reserve(rows_.size());
    row_block_starts_.assign(1, 0);
    std::vector<int> seen(n, -1), next = column_starts_;
    for (int k = 0; k < n; ++k) {
        seen[k] = k;
        for (int e = entry_starts_[k]; e < entry_starts_[k + 1]; ++e)
            for (int i = entries_[e].column; seen[i] != k; i = parent_[i]) {
                seen[i] = k;
                row_blocks_.push_back({i, next[i]});
                rows_[next[i]++] = k;
            }
        std::sort(row_blocks_.begin() + row_block_starts_.back(), row_blocks_.end(),
                  [](const RowBlock& a, const RowBlock& b) { return a.column < b.column; });
        row_block_starts_.push_back(static_cast<int>(row_blocks_.size()));
    }
    L_.resize(rows_.size());
    inverse_D_.resize(n);
    row_.resize(n);
}

void BlockFactor::factorise(const std::vector<int>& steps, const std::vector<Matrix3d>& blocks)
{
    for (const int k : steps) {
        for (int p = row_block_starts_[k]; p < row_block_starts_[k + 1]; ++p)
            row_[row_blocks_[p].column].setZero();
        for (int e = entry_starts_[k]; e < entry_starts_[k + 1]; ++e) {
            const Entry& entry = entries_[e];
            if (entry.is_transposed)
                row_[entry.column] = blocks[entry.block].transpose();
            else
                row_[entry.column] = blocks[entry.block];
        }
        Matrix3d D = blocks[diagonal_[k]];
        for (int p = row_block_starts_[k]; p < row_block_starts_[k + 1]; ++p) {
            const auto [i, at] = row_blocks_[p];
            const Matrix3d X = row_[i]; // L_ki D_i
            const Matrix3d L = X * inverse_D_[i];
            for (int q = column_starts_[i]; q < at; ++q)
                row_[rows_[q]].noalias() -= X * L_[q].transpose();
            D.noalias() -= X * L.transpose();
            L_[at] = L;
        }
        inverse_D_[k] = D.inverse();
    }
}

void BlockFactor::steps_of(const std::vector<int>& nodes, std::vector<int>& steps) const
{
    steps.clear();
    for (const int node : nodes)
        steps.push_back(step_of_[node]);
    std::sort(steps.begin(), steps.end());
}

void BlockFactor::solve(const std::vector<int>& steps, std::vector<Vector3d>& x) const
{
    for (const int k : steps) { // solve L y = x
        const Vector3d y = x[node_of_[k]];
        for (int q = column_starts_[k]; q < column_starts_[k + 1]; ++q)
            x[node_of_[rows_[q]]].noalias() -= L_[q] * y;
    }
    for (auto step = steps.rbegin(); step != steps.rend(); ++step) { // solve Lᵀ x = D⁻¹ y
        const int k = *step;
        Vector3d y = inverse_D_[k] * x[node_of_[k]];
        for (int q = column_starts_[k]; q < column_starts_[k + 1]; ++q)
            y.noalias() -= L_[q].transpose() * x[node_of_[rows_[q]]];
        x[node_of_[k]] = y;
    }
}

} // namespace rigor
