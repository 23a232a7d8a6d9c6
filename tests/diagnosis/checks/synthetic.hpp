// SPDX-License-Identifier: MIT
// Formulas made for the tests of the diagnosis: a right one, and wrong ones.
#pragma once

#include "diagnosis/search.hpp"
#include "diagnosis/special_cases.hpp"
#include "support/random.hpp"

#include <cmath>

namespace rigor::testing {

using diagnosis::Value;

/// A function on numbers. Its arguments are a scalar `a`, vectors `u` and `v`, a matrix `A`, and a
/// unit vector `n`, in this order; its answer is a vector.
struct MadeArguments {
    double a;
    Vector3d u, v;
    Matrix3d A;
    Vector3d n;
};
using Function = std::function<Vector3d(const MadeArguments&)>;

inline diagnosis::Layout synthetic_arguments()
{
    diagnosis::Encoding type;
    type.names = {"a", "u", "v", "A", "n"};
    type.parts = {diagnosis::encoding_of<double>(quantities::speed),
                  diagnosis::encoding_of<Vector3d>(quantities::velocity),
                  diagnosis::encoding_of<Vector3d>(quantities::velocity),
                  diagnosis::encoding_of<Matrix3d>(quantities::matrix),
                  diagnosis::encoding_of<Vector3d>(quantities::unit)};
    return diagnosis::Layout(type);
}

inline MadeArguments unpacked(const Value& value)
{
    const double* x = value.numbers.data();
    return {x[0], Vector3d(x + 1), Vector3d(x + 4), Matrix3d(x + 7), Vector3d(x + 16)};
}

inline Value vector_value(const Vector3d& v)
{
    return {{v.x(), v.y(), v.z()}, {{0, 0}}, {}};
}

/// What is found about `wrong` in the place of `right`; empty if nothing is.
inline std::string found(const Function& right, const Function& wrong)
{
    const diagnosis::Layout arguments = synthetic_arguments(),
                            answer(diagnosis::encoding_of<Vector3d>(quantities::velocity));
    const auto ask = [](const Function& function) {
        return [function](const Value& value) -> std::optional<Value> {
            return vector_value(function(unpacked(value)));
        };
    };
    diagnosis::Evidence evidence = {arguments, answer, {}, ask(right)};
    Random random(7);
    std::vector<Value> drawn;
    std::vector<diagnosis::Input> inputs;
    for (int i = 0; i < 40; ++i) {
        Value value = {{}, {{0, 0}, {1, 1}, {2, 4}, {3, 7}, {4, 16}}, {}};
        for (int k = 0; k < 16; ++k)
            value.numbers.push_back(random.uniform(-1, 1));
        const Vector3d n = random.unit_vector();
        value.numbers.insert(value.numbers.end(), {n.x(), n.y(), n.z()});
        drawn.push_back(value);
        inputs.push_back({value, true, 1});
    }
    for (auto& input : special_cases(arguments, drawn))
        inputs.push_back(std::move(input));
    for (const auto& input : inputs)
        evidence.cases.push_back(compared(answer, {input.arguments,
                                                   *evidence.reference(input.arguments),
                                                   *ask(wrong)(input.arguments),
                                                   input.is_drawn,
                                                   1e-13 * input.smallest,
                                                   {}}));
    const auto finding = explain(evidence, ask(wrong));
    return finding ? finding->sentence : "";
}

} // namespace rigor::testing
