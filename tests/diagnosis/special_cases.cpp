// SPDX-License-Identifier: MIT
#include "diagnosis/special_cases.hpp"

#include "support/random.hpp"

#include <algorithm>
#include <cmath>

namespace rigor::diagnosis {

namespace {

bool may_scale(const Role& role)
{
    switch (role.quantity.kind) {
    case Kind::unit:
    case Kind::direction:
    case Kind::rotation:
    case Kind::orientation:
    case Kind::index:
    case Kind::chosen:
        return false;
    default:
        return role.form == Form::real || role.form == Form::quaternion;
    }
}

void scale(const Layout& arguments, Value& value, int role, double factor)
{
    for (const Leaf& leaf : value.leaves)
        if (leaf.role == role)
            for (double& x : value.of(leaf, arguments.roles[role]))
                x *= factor;
}

// Collects changed inputs. It takes the drawn arguments in turns.
class Inputs {
public:
    Inputs(const Layout& arguments, const std::vector<Value>& drawn)
        : arguments_(arguments), drawn_(drawn)
    {
    }

    /// Adds a few of the arguments, changed.
    template <class Change> void add(const Change& change, double smallest = 1, int n = 3)
    {
        for (int i = 0; i < n; ++i) {
            Value value = drawn_[next_++ % drawn_.size()];
            change(value);
            inputs_.push_back({std::move(value), false, smallest});
        }
    }

    const Layout& arguments() const { return arguments_; }
    std::vector<Input> take() { return std::move(inputs_); }

private:
    const Layout& arguments_;
    const std::vector<Value>& drawn_;
    std::size_t next_ = 0;
    std::vector<Input> inputs_;
};

void add_sizes(Inputs& inputs, int role)
{
    const Layout& arguments = inputs.arguments();
    for (const double factor : {0.0, 1e-3, 1e-5, 1e-7, 1e-10, 1e-13, 1e3, 1e6})
        inputs.add([&](Value& value) { scale(arguments, value, role, factor); },
                   std::min(1.0, factor == 0 ? 1 : factor * factor), factor == 0 ? 8 : 3);
    if (arguments.roles[role].in_list) // the first element only
        for (const double factor : {0.0, 1e-8})
            inputs.add(
                [&](Value& value) {
                    const auto leaves = arguments.leaves(value, role);
                    if (leaves.empty()) return;
                    for (double& x : value.of(leaves[0], arguments.roles[role]))
                        x *= factor;
                },
                1, 4);
}

void add_matrices(Inputs& inputs, int role)
{
    const Role& what = inputs.arguments().roles[role];
    using Function = Matrix3d (*)(const Matrix3d&);
    const Function functions[] = {
        [](const Matrix3d& A) -> Matrix3d { return A.trace() * Matrix3d::Identity(); },
        [](const Matrix3d& A) -> Matrix3d { return -std::abs(A.trace()) * Matrix3d::Identity(); },
        [](const Matrix3d& A) -> Matrix3d { return A.diagonal().asDiagonal(); },
        [](const Matrix3d& A) -> Matrix3d { return A.col(0) * A.col(0).transpose(); },
        [](const Matrix3d& A) -> Matrix3d { return -A; },
    };
    for (const Function function : functions) {
        const bool is_negative = function(Matrix3d::Identity()).trace() < 0;
        if (is_negative && what.quantity.kind == Kind::definite) continue;
        inputs.add(
            [&](Value& value) {
                for (const Leaf& leaf : inputs.arguments().leaves(value, role)) {
                    Eigen::Map<Matrix3d> A(value.of(leaf, what).data());
                    A = function(Matrix3d(A));
                }
            },
            1, 4);
    }
}

void add_equal(Inputs& inputs, int role, int other)
{
    const Layout& arguments = inputs.arguments();
    for (const double nearly : {0.0, 1e-9, 1e-6})
        inputs.add(
            [&](Value& value) {
                const auto a = arguments.leaves(value, role), b = arguments.leaves(value, other);
                if (a.empty() || b.empty()) return;
                const Changeable x = value.of(a[0], arguments.roles[role]),
                                 y = value.of(b[0], arguments.roles[other]);
                for (std::size_t i = 0; i < x.size(); ++i)
                    x[i] = y[i] * (1 + nearly * static_cast<double>(i + 1));
            },
            1, 3);
}

// Vectors that are almost along a unit vector or almost across it: bodies that hardly approach or
// hardly slide.
void add_directions(Inputs& inputs, int role, int unit)
{
    const Layout& arguments = inputs.arguments();
    const auto change = [&](double along, double across) {
        inputs.add(
            [&, along, across](Value& value) {
                const auto a = arguments.leaves(value, role), b = arguments.leaves(value, unit);
                for (std::size_t i = 0; i < a.size() && !b.empty(); ++i) {
                    const Leaf& other = b[b.size() == a.size() ? i : 0];
                    Eigen::Map<Vector3d> v(value.of(a[i], arguments.roles[role]).data());
                    const Vector3d n(value.of(other, arguments.roles[unit]).data());
                    const double v_n = v.dot(n);
                    v = (across * (v - v_n * n) + along * v_n * n).eval();
                }
            },
            1, 4);
    };
    for (const double little : {0.0, 1e-4, 1e-8, 1e-10, 1e-13}) {
        change(little, 1);
        change(-little, 1);
        change(1, little);
    }
}

// Lists whose elements are equal at one place.
void add_equal_elements(Inputs& inputs, int role)
{
    const Layout& arguments = inputs.arguments();
    inputs.add(
        [&](Value& value) {
            const auto leaves = arguments.leaves(value, role);
            for (std::size_t i = 1; i < leaves.size(); ++i) {
                const auto first = value.of(leaves[0], arguments.roles[role]);
                std::copy(first.begin(), first.end(),
                          value.of(leaves[i], arguments.roles[role]).begin());
            }
        },
        1, 8);
}

// The places of inverse masses and inverse inertias, which are zero together.
void add_static(Inputs& inputs)
{
    const Layout& arguments = inputs.arguments();
    const auto is_inverse = [](const Role& role) { return role.quantity.dimension.mass < 0; };
    for (std::size_t i = 0; i < arguments.roles.size(); ++i) {
        const std::string& name = arguments.roles[i].name;
        if (!is_inverse(arguments.roles[i]) || !arguments.roles[i].is_scalar()) continue;
        const std::string parent = name.substr(0, name.find_last_of('.') + 1);
        inputs.add(
            [&](Value& value) {
                for (const Leaf& leaf : value.leaves) {
                    const Role& role = arguments.roles[leaf.role];
                    if (is_inverse(role) && role.name.starts_with(parent))
                        for (double& x : value.of(leaf, role))
                            x = 0;
                }
            },
            1, 6);
    }
}

void add_units(Inputs& inputs)
{
    const Layout& arguments = inputs.arguments();
    constexpr Dimension units[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (const Dimension& unit : units)
        for (const int exponent : {-50, -20, 20, 50}) {
            const int power = unit.time != 0 ? exponent / 2 : exponent;
            inputs.add(
                [&](Value& value) {
                    for (int role = 0; role < static_cast<int>(arguments.roles.size()); ++role) {
                        const Dimension& d = arguments.roles[role].quantity.dimension;
                        scale(arguments, value, role,
                              std::ldexp(1, power * (unit.mass * d.mass + unit.length * d.length +
                                                     unit.time * d.time)));
                    }
                },
                std::ldexp(1, -3 * std::abs(power)), 2);
        }
}

void add_vectors(Inputs& inputs, int role)
{
    const Role& what = inputs.arguments().roles[role];
    for (int axis = 0; axis < 3; ++axis)
        inputs.add(
            [&](Value& value) {
                for (const Leaf& leaf : inputs.arguments().leaves(value, role))
                    for (int i = 0; i < 3; ++i)
                        if (i != axis) value.of(leaf, what)[i] = 0;
            },
            1, 2);
}

} // namespace

std::vector<Input> special_cases(const Layout& arguments, const std::vector<Value>& drawn)
{
    Inputs inputs(arguments, drawn);
    const int n = static_cast<int>(arguments.roles.size());
    for (int i = 0; i < n; ++i) {
        const Role& role = arguments.roles[i];
        if (!may_scale(role)) continue;
        add_sizes(inputs, i);
        if (role.is_vector()) add_vectors(inputs, i);
        if (role.in_list) add_equal_elements(inputs, i);
        for (int j = 0; j < n; ++j)
            if (role.is_vector() && arguments.roles[j].quantity.kind == Kind::unit)
                add_directions(inputs, i, j);
        if (role.is_matrix() && role.rows == 3) add_matrices(inputs, i);
        if (role.quantity.kind == Kind::any_number || role.quantity.kind == Kind::quaternion)
            inputs.add([&](Value& value) { scale(arguments, value, i, -1); });
        for (int j = 0; j < i; ++j)
            if (may_scale(arguments.roles[j]) && role.same_shape(arguments.roles[j]) &&
                !role.in_list && !arguments.roles[j].in_list &&
                role.quantity.dimension == arguments.roles[j].quantity.dimension)
                add_equal(inputs, i, j);
    }
    add_static(inputs);
    add_units(inputs);
    return inputs.take();
}

std::vector<Input> neighbours(const Layout& arguments, const Value& input, unsigned seed, int n)
{
    std::vector<Input> result;
    testing::Random random(seed);
    for (int i = 0; i < n; ++i) {
        Value value = input;
        for (int role = 0; role < static_cast<int>(arguments.roles.size()); ++role)
            if (may_scale(arguments.roles[role]))
                scale(arguments, value, role, random.uniform(0.5, 1.5));
        result.push_back({std::move(value), false, 1e-9});
    }
    return result;
}

} // namespace rigor::diagnosis
