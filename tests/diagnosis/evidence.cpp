// SPDX-License-Identifier: MIT
#include "diagnosis/evidence.hpp"

#include <algorithm>
#include <cmath>

namespace rigor::diagnosis {

bool Case::is_different() const
{
    return std::any_of(agreement.begin(), agreement.end(),
                       [](Agreement a) { return a == Agreement::different; });
}

bool Case::is_same() const
{
    return std::all_of(agreement.begin(), agreement.end(),
                       [](Agreement a) { return a == Agreement::same; });
}

double norm(std::span<const double> numbers)
{
    double sum = 0;
    for (const double number : numbers)
        sum = std::hypot(sum, number);
    return sum;
}

bool close(std::span<const double> a, std::span<const double> b, double bound, double noise)
{
    double size = 0, difference = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (std::isnan(a[i]) && std::isnan(b[i])) continue;
        if (a[i] == b[i]) { // also for infinity
            if (std::isfinite(a[i])) size = std::hypot(size, a[i]);
            continue;
        }
        if (!std::isfinite(a[i]) || !std::isfinite(b[i])) return false;
        size = std::hypot(size, std::max(std::abs(a[i]), std::abs(b[i])));
        difference = std::hypot(difference, a[i] - b[i]);
    }
    return difference <= bound * size || difference <= noise;
}

namespace {

bool agree(const Role& role, std::span<const double> a, std::span<const double> b, double bound,
           double noise)
{
    if (role.quantity.kind == Kind::chosen) return true;
    if (close(a, b, bound, noise)) return true;
    if (role.quantity.kind != Kind::direction) return false;
    std::vector<double> opposite(b.begin(), b.end());
    for (double& number : opposite)
        number = -number;
    return close(a, opposite, bound, noise);
}

} // namespace

Agreement compare(const Layout& layout, int role, const Value& right, const Value& answer,
                  double noise)
{
    if (right.sizes != answer.sizes) return Agreement::different;
    const Role& what = layout.roles[role];
    Agreement worst = Agreement::same;
    for (std::size_t i = 0; i < right.leaves.size(); ++i) {
        const Leaf& leaf = right.leaves[i];
        if (leaf.role != role) continue;
        const auto a = right.of(leaf, what), b = answer.of(leaf, what);
        if (!agree(what, a, b, clear, noise)) return Agreement::different;
        if (!agree(what, a, b, rounding, noise)) worst = Agreement::unclear;
    }
    return worst;
}

bool agree(const Layout& layout, const Value& right, const Value& answer, double noise)
{
    for (int role = 0; role < static_cast<int>(layout.roles.size()); ++role)
        if (compare(layout, role, right, answer, noise) != Agreement::same) return false;
    return right.sizes == answer.sizes;
}

Case compared(const Layout& answer, Case c)
{
    c.agreement.clear();
    for (int role = 0; role < static_cast<int>(answer.roles.size()); ++role)
        c.agreement.push_back(compare(answer, role, c.right, c.answer, c.noise));
    return c;
}

} // namespace rigor::diagnosis
