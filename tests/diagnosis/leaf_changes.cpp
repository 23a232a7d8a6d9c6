// SPDX-License-Identifier: MIT
// Changes of a number, vector, matrix or quaternion by itself.
#include "diagnosis/transforms.hpp"

#include <cmath>

namespace rigor::diagnosis {

namespace {

template <class Function> auto each(const Function& function)
{
    return [function](Changeable numbers) {
        for (double& x : numbers)
            x = function(x);
        return true;
    };
}

bool normalize(Changeable numbers)
{
    double square = 0;
    for (const double x : numbers)
        square += x * x;
    if (!(square > 0)) return false;
    for (double& x : numbers)
        x /= std::sqrt(square);
    return true;
}

// Puts number `order[i]` at i.
std::function<bool(Changeable)> permuted(std::vector<int> order)
{
    return [order](Changeable numbers) {
        const std::vector<double> old(numbers.begin(), numbers.end());
        for (std::size_t i = 0; i < order.size(); ++i)
            numbers[i] = old[order[i]];
        return true;
    };
}

template <class Function> auto on_matrix(int rows, int columns, const Function& function)
{
    return [=](Changeable numbers) {
        Eigen::Map<Eigen::MatrixXd> A(numbers.data(), rows, columns);
        const Eigen::MatrixXd changed = function(Eigen::MatrixXd(A));
        if (!changed.allFinite()) return false;
        A = changed;
        return true;
    };
}

void add_scalar(std::vector<LeafChange>& changes)
{
    changes.push_back({"= 1", "it may have been left out", each([](double) { return 1.0; })});
    changes.push_back({"inverted", "it may be the inverse already, or not yet",
                       each([](double x) { return 1 / x; })});
    changes.push_back(
        {"halved", "a factor of 2 may be missing", each([](double x) { return x / 2; })});
    changes.push_back(
        {"doubled", "a factor of 2 may be too much", each([](double x) { return 2 * x; })});
    changes.push_back({"squared", "", each([](double x) { return x * x; })});
    changes.push_back({"replaced by its square root", "",
                       each([](double x) { return x < 0 ? x : std::sqrt(x); })});
    changes.push_back(
        {"replaced by its absolute value", "", each([](double x) { return std::abs(x); })});
}

void add_vector(std::vector<LeafChange>& changes)
{
    changes.push_back({"divided by its length", "", normalize});
    changes.push_back(
        {"halved", "a factor of 2 may be missing", each([](double x) { return x / 2; })});
    changes.push_back(
        {"doubled", "a factor of 2 may be too much", each([](double x) { return 2 * x; })});
    const char* axes[] = {"(1, 0, 0)", "(0, 1, 0)", "(0, 0, 1)"};
    for (int axis = 0; axis < 3; ++axis)
        changes.push_back({std::string("= ") + axes[axis], "it may have been left out",
                           [axis](Changeable numbers) {
                               for (int i = 0; i < 3; ++i)
                                   numbers[i] = i == axis;
                               return true;
                           }});
    changes.push_back({"in the order y, z, x", "", permuted({1, 2, 0})});
    changes.push_back({"in the order z, x, y", "", permuted({2, 0, 1})});
    changes.push_back({"in the order z, y, x", "", permuted({2, 1, 0})});
    changes.push_back({"in the order y, x, z", "", permuted({1, 0, 2})});
    changes.push_back({"in the order x, z, y", "", permuted({0, 2, 1})});
    changes.push_back({"replaced by the absolute values of its components", "",
                       each([](double x) { return std::abs(x); })});
    changes.push_back({"with each component replaced by their sum", "", [](Changeable numbers) {
                           const double sum = numbers[0] + numbers[1] + numbers[2];
                           numbers[0] = numbers[1] = numbers[2] = sum;
                           return true;
                       }});
}

void add_matrix(std::vector<LeafChange>& changes, int n)
{
    using M = Eigen::MatrixXd;
    const auto add = [&](const char* words, const char* advice, const auto& function) {
        changes.push_back({words, advice, on_matrix(n, n, function)});
    };
    add("transposed", "a transpose may be missing, or one too many",
        [](const M& A) -> M { return A.transpose(); });
    add("inverted", "it may be the inverse already, or not yet",
        [](const M& A) -> M { return A.inverse(); });
    add("= the identity", "it may have been left out",
        [](const M& A) -> M { return M::Identity(A.rows(), A.cols()); });
    add("without its off-diagonal entries", "only the diagonal may have been used",
        [](const M& A) -> M { return A.diagonal().asDiagonal(); });
    add("without its diagonal", "",
        [](const M& A) -> M { return A - M(A.diagonal().asDiagonal()); });
    add("with its off-diagonal entries negated", "",
        [](const M& A) -> M { return 2 * M(A.diagonal().asDiagonal()) - A; });
    add("without its part above the diagonal", "",
        [](const M& A) -> M { return A.triangularView<Eigen::Lower>(); });
    add("without its part below the diagonal", "",
        [](const M& A) -> M { return A.triangularView<Eigen::Upper>(); });
    add("replaced by its deviator", "the trace may have been subtracted too often",
        [](const M& A) -> M { return A - A.trace() / 3 * M::Identity(A.rows(), A.cols()); });
    add("replaced by its mean normal part", "",
        [](const M& A) -> M { return A.trace() / 3 * M::Identity(A.rows(), A.cols()); });
    add("without its trace on the diagonal", "",
        [](const M& A) -> M { return A - A.trace() * M::Identity(A.rows(), A.cols()); });
    add("symmetrized", "", [](const M& A) -> M { return (A + A.transpose()) / 2; });
    add("halved", "a factor of 2 may be missing", [](const M& A) -> M { return A / 2; });
    add("doubled", "a factor of 2 may be too much", [](const M& A) -> M { return 2 * A; });
    add("squared", "", [](const M& A) -> M { return A * A; });
}

void add_quaternion(std::vector<LeafChange>& changes)
{
    changes.push_back(
        {"conjugated", "q and its conjugate may have changed places", [](Changeable q) {
             for (int i = 1; i < 4; ++i)
                 q[i] = -q[i];
             return true;
         }});
    changes.push_back({"with its scalar part negated", "", [](Changeable q) {
                           q[0] = -q[0];
                           return true;
                       }});
    changes.push_back({"= 1, no rotation", "it may have been left out", [](Changeable q) {
                           q[0] = 1;
                           q[1] = q[2] = q[3] = 0;
                           return true;
                       }});
    changes.push_back({"normalized", "it is not unit here, and must not be made so", normalize});
    changes.push_back({"without its vector part", "", [](Changeable q) {
                           q[1] = q[2] = q[3] = 0;
                           return true;
                       }});
    changes.push_back({"without its scalar part", "", [](Changeable q) {
                           q[0] = 0;
                           return true;
                       }});
    changes.push_back({"read with its scalar part last", "the scalar part is the first of the four",
                       permuted({3, 0, 1, 2})});
    changes.push_back({"written with its scalar part last",
                       "the scalar part is the first of the four", permuted({1, 2, 3, 0})});
}

} // namespace

std::vector<LeafChange> changes_of(const Role& role)
{
    std::vector<LeafChange> changes;
    if (role.form == Form::boolean) {
        changes.push_back({"negated", "", each([](double x) { return 1 - x; })});
        changes.push_back(
            {"= false", "it may have been left out", each([](double) { return 0.0; })});
        changes.push_back({"= true", "", each([](double) { return 1.0; })});
        return changes;
    }
    if (role.form == Form::integer) {
        if (role.in_list) return changes; // an index, which would not exist
        for (const int step : {1, -1})
            changes.push_back({step > 0 ? "increased by 1" : "decreased by 1",
                               "the count may begin or end at another number",
                               each([step](double x) { return x + step; })});
        changes.push_back({"= 1", "it may have been left out", each([](double) { return 1.0; })});
        changes.push_back({"= 0", "it may have been left out", each([](double) { return 0.0; })});
        return changes;
    }
    changes.push_back({"= 0", "it has no effect in your code", each([](double) { return 0.0; })});
    changes.push_back({"negated", "a sign may be wrong", each([](double x) { return -x; })});
    if (role.is_scalar()) add_scalar(changes);
    if (role.is_vector()) add_vector(changes);
    if (role.is_matrix()) add_matrix(changes, role.rows);
    if (role.form == Form::quaternion) add_quaternion(changes);
    return changes;
}

} // namespace rigor::diagnosis
