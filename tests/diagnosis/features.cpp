// SPDX-License-Identifier: MIT
#include "diagnosis/features.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rigor::diagnosis {

namespace {

using Vector = Eigen::Map<const Vector3d>;
using Matrix = Eigen::Map<const Matrix3d>;

// The only leaf of a place that is in no list.
Numbers only(const Value& value, const Role& role, int index)
{
    for (const Leaf& leaf : value.leaves)
        if (leaf.role == index) return value.of(leaf, role);
    return {};
}

double length(Numbers numbers)
{
    double sum = 0;
    for (const double x : numbers)
        sum = std::hypot(sum, x);
    return sum;
}

template <class Function>
void add(std::vector<Feature>& result, const std::string& words, const Role& role, int index,
         const Function& function)
{
    result.push_back({words, [role, index, function](const Value& value) {
                          const Numbers numbers = only(value, role, index);
                          return numbers.empty() ? std::nan("") : function(numbers);
                      }});
}

void add_own(std::vector<Feature>& result, const Role& role, int index)
{
    const std::string& name = role.name;
    if (role.size() == 1)
        add(result, "`" + name + "`", role, index, [](Numbers x) { return x[0]; });
    else if (role.quantity.kind != Kind::unit && role.quantity.kind != Kind::rotation)
        add(result, "|`" + name + "`|", role, index, length);
    if (role.is_vector())
        for (int i = 0; i < 3; ++i)
            add(result, fmt::format("`{}`.{}", name, "xyz"[i]), role, index,
                [i](Numbers x) { return x[i]; });
    if (role.form == Form::quaternion)
        add(result, "`" + name + ".s`", role, index, [](Numbers x) { return x[0]; });
    if (!role.is_matrix() || role.rows != 3) return;
    add(result, "the trace of `" + name + "`", role, index,
        [](Numbers x) { return Matrix(x.data()).trace(); });
    add(result, "the determinant of `" + name + "`", role, index,
        [](Numbers x) { return Matrix(x.data()).determinant(); });
    add(result, "the deviator of `" + name + "`", role, index, [](Numbers x) {
        const Matrix A(x.data());
        return Matrix3d(A - A.trace() / 3 * Matrix3d::Identity()).norm();
    });
    for (const bool is_largest : {false, true})
        add(result,
            fmt::format("the {} eigenvalue of `{}`", is_largest ? "largest" : "smallest", name),
            role, index, [is_largest](Numbers x) {
                const Matrix3d A = Matrix(x.data());
                const Matrix3d S = (A + A.transpose()) / 2;
                return Eigen::SelfAdjointEigenSolver<Matrix3d>(S, Eigen::EigenvaluesOnly)
                    .eigenvalues()(is_largest ? 2 : 0);
            });
}

void add_pair(std::vector<Feature>& result, const Role& a, int i, const Role& b, int j)
{
    const auto add_two = [&](const std::string& words, const auto& function) {
        result.push_back({words, [=](const Value& value) {
                              const Numbers x = only(value, a, i), y = only(value, b, j);
                              return x.empty() || y.empty() ? std::nan("") : function(x, y);
                          }});
    };
    const bool same_unit = a.quantity.dimension == b.quantity.dimension;
    if (a.is_vector() && b.is_vector()) {
        add_two(fmt::format("`{}`·`{}`", a.name, b.name),
                [](Numbers x, Numbers y) { return Vector(x.data()).dot(Vector(y.data())); });
        if (b.quantity.kind == Kind::unit)
            add_two(fmt::format("the part of `{}` across `{}`", a.name, b.name),
                    [](Numbers x, Numbers y) {
                        const Vector v(x.data()), n(y.data());
                        return Vector3d(v - v.dot(n) * n).norm();
                    });
        if (same_unit)
            add_two(fmt::format("|`{}` - `{}`|", a.name, b.name), [](Numbers x, Numbers y) {
                return (Vector(x.data()) - Vector(y.data())).norm();
            });
        add_two(fmt::format("|`{}` × `{}`|", a.name, b.name), [](Numbers x, Numbers y) {
            return Vector3d(x.data()).cross(Vector3d(y.data())).norm();
        });
    } else if (a.size() == 1 && b.size() == 1) {
        if (same_unit)
            add_two(fmt::format("`{}` - `{}`", a.name, b.name),
                    [](Numbers x, Numbers y) { return x[0] - y[0]; });
        add_two(fmt::format("`{}` `{}`", a.name, b.name),
                [](Numbers x, Numbers y) { return x[0] * y[0]; });
    } else if (a.size() == 1 || b.size() == 1) {
        if (a.is_vector() || b.is_vector()) // such as an angle, ω Δt
            add_two(fmt::format("|`{}`| |`{}`|", a.name, b.name),
                    [](Numbers x, Numbers y) { return length(x) * length(y); });
    }
}

void add_list(std::vector<Feature>& result, const Role& role, int index)
{
    if (role.size() != 1) return;
    const auto over = [&](const std::string& words, const auto& function) {
        result.push_back({words + " `" + role.name + "`", [=](const Value& value) {
                              std::vector<double> all;
                              for (const Leaf& leaf : value.leaves)
                                  if (leaf.role == index) all.push_back(value.of(leaf, role)[0]);
                              return all.empty() ? std::nan("") : function(all);
                          }});
    };
    using Values = std::vector<double>;
    over("the sum of all", [](const Values& all) {
        double sum = 0;
        for (const double x : all)
            sum += x;
        return sum;
    });
    over("the smallest",
         [](const Values& all) { return *std::min_element(all.begin(), all.end()); });
    over("the largest",
         [](const Values& all) { return *std::max_element(all.begin(), all.end()); });
}

} // namespace

std::vector<Feature> features(const Layout& arguments)
{
    std::vector<Feature> result;
    const int n = static_cast<int>(arguments.roles.size());
    for (int i = 0; i < n; ++i)
        if (!arguments.roles[i].in_list) add_own(result, arguments.roles[i], i);
    const bool has_list =
        std::any_of(arguments.encoding.parts.begin(), arguments.encoding.parts.end(),
                    [](const Encoding& part) { return part.form == Form::list; });
    if (has_list) // its length comes first among the sizes if it is the first argument
        if (arguments.encoding.parts[0].form == Form::list)
            result.push_back(
                {fmt::format("the number of `{}`", arguments.encoding.names[0]),
                 [](const Value& value) { return static_cast<double>(value.sizes[0]); }});
    for (int i = 0; i < n; ++i)
        for (int j = i + 1; j < n; ++j)
            if (!arguments.roles[i].in_list && !arguments.roles[j].in_list)
                add_pair(result, arguments.roles[i], i, arguments.roles[j], j);
    for (int i = 0; i < n; ++i)
        if (arguments.roles[i].in_list) add_list(result, arguments.roles[i], i);
    return result;
}

} // namespace rigor::diagnosis
