// SPDX-License-Identifier: MIT
// Relations are found in made-up formulas, and nothing is said where there is none.
#include "support/catch.hpp"
#include "synthetic.hpp"

#include <bit>
#include <cstdint>

namespace rigor::testing {

namespace {

Vector3d right(const MadeArguments& f)
{
    return f.a * (f.A * f.u) + f.v.cross(f.u);
}

void check_found(const std::string& words, const Function& wrong)
{
    const std::string sentence = found(right, wrong);
    CAPTURE(sentence, words);
    CHECK(sentence.find(words) != std::string::npos);
}

} // namespace

TEST_CASE("diagnosis: an answer that follows from the right one is named", "[diagnosis]")
{
    const std::string on_all = ", on all 40 random inputs";
    check_found("Your answer is 2 times the right one" + on_all,
                [](const MadeArguments& f) -> Vector3d { return 2 * right(f); });
    check_found("½ times the right one" + on_all,
                [](const MadeArguments& f) -> Vector3d { return right(f) / 2; });
    check_found("π/4 times the right one",
                [](const MadeArguments& f) -> Vector3d { return right(f) * 0.78539816339744831; });
    check_found("1.2345 times the right one",
                [](const MadeArguments& f) -> Vector3d { return 1.2345 * right(f); });
    check_found("the right one with the opposite sign",
                [](const MadeArguments& f) -> Vector3d { return -right(f); });
    check_found("always 0", [](const MadeArguments&) -> Vector3d { return Vector3d::Zero(); });
    check_found("the same for all arguments",
                [](const MadeArguments&) { return Vector3d(1, 2, 3); });
    check_found("in the order z, x, y", [](const MadeArguments& f) {
        const Vector3d v = right(f);
        return Vector3d(v.z(), v.x(), v.y());
    });
    check_found("divided by its length",
                [](const MadeArguments& f) -> Vector3d { return right(f).normalized(); });
    check_found("with the opposite sign of y", [](const MadeArguments& f) -> Vector3d {
        return right(f).cwiseProduct(Vector3d(1, -1, 1));
    });
    check_found("about 7 digits", [](const MadeArguments& f) -> Vector3d {
        return right(f).cast<float>().cast<double>();
    });
}

TEST_CASE("diagnosis: an answer for other arguments is named", "[diagnosis]")
{
    const auto changed = [](auto change) {
        return [change](MadeArguments f) {
            change(f);
            return right(f);
        };
    };
    check_found("for `A` transposed", changed([](MadeArguments& f) { f.A.transposeInPlace(); }));
    check_found("for `A` inverted", changed([](MadeArguments& f) { f.A = f.A.inverse().eval(); }));
    check_found("for `A` without its off-diagonal entries",
                changed([](MadeArguments& f) { f.A = Matrix3d(f.A.diagonal().asDiagonal()); }));
    check_found("for `A` = the identity", changed([](MadeArguments& f) { f.A.setIdentity(); }));
    check_found("for `v` negated", changed([](MadeArguments& f) { f.v = -f.v; }));
    check_found("for `v` = 0", changed([](MadeArguments& f) { f.v.setZero(); }));
    check_found("for `a` = 1", changed([](MadeArguments& f) { f.a = 1; }));
    check_found("for `u` and `v` exchanged",
                changed([](MadeArguments& f) { std::swap(f.u, f.v); }));
    check_found("for `v` in the place of `u`", changed([](MadeArguments& f) { f.u = f.v; }));
    check_found("for `u` multiplied by `A`", changed([](MadeArguments& f) { f.u = f.A * f.u; }));
    check_found("for `v` negated and `A` transposed", changed([](MadeArguments& f) {
                    f.A.transposeInPlace();
                    f.v = -f.v;
                }));
    check_found("2 times the right one for `A` transposed", [](MadeArguments f) -> Vector3d {
        f.A.transposeInPlace();
        return 2 * right(f);
    });
}

TEST_CASE("diagnosis: an argument's part in a wrong answer is named", "[diagnosis]")
{
    check_found("the right one divided by `a`",
                [](const MadeArguments& f) -> Vector3d { return right(f) / f.a; });
    check_found("the right one multiplied by |`v`|",
                [](const MadeArguments& f) -> Vector3d { return right(f) * f.v.norm(); });
    check_found("the right one plus `u`",
                [](const MadeArguments& f) -> Vector3d { return right(f) + f.u; });
    check_found(
        "the right one with the opposite sign of its part across `n`",
        [](const MadeArguments& f) -> Vector3d { return 2 * right(f).dot(f.n) * f.n - right(f); });
    check_found("the right one without its part along `n`", [](const MadeArguments& f) -> Vector3d {
        return right(f) - right(f).dot(f.n) * f.n;
    });
    check_found("Your answer is `u`", [](const MadeArguments& f) { return f.u; });
    check_found("does not depend on `a`", [](const MadeArguments& f) -> Vector3d {
        return f.A * f.u.cwiseAbs2() + f.v.array().sin().matrix();
    });
}

TEST_CASE("diagnosis: the arguments for which an answer is wrong are named", "[diagnosis]")
{
    check_found("0 where `a` is negative, and right elsewhere",
                [](const MadeArguments& f) -> Vector3d {
                    if (f.a < 0) return Vector3d::Zero();
                    return right(f);
                });
    check_found("where `u`·`v` is positive", [](const MadeArguments& f) -> Vector3d {
        return f.u.dot(f.v) > 0 ? Vector3d(right(f).array().sin()) : right(f);
    });
    check_found("where `u`·`v` is negative", [](const MadeArguments& f) -> Vector3d {
        return f.u.dot(f.v) < -1e-13 ? Vector3d(right(f).array().sin()) : right(f);
    });
    check_found("where |`v`| is below", [](const MadeArguments& f) -> Vector3d {
        if (f.v.norm() < 1e-6) return Vector3d(f.u.array().cos());
        return right(f);
    });
}

TEST_CASE("diagnosis: nothing is said without a relation", "[diagnosis]")
{
    const std::pair<const char*, Function> wrong[] = {
        {"the right one", right},
        {"squares",
         [](const MadeArguments& f) -> Vector3d {
             return right(f).array().square() + f.a * f.v.array();
         }},
        {"a sine",
         [](const MadeArguments& f) -> Vector3d {
             return (right(f) + f.A * f.v * f.a).array().sin();
         }},
        {"noise", [](const MadeArguments& f) -> Vector3d {
             const auto bits = std::bit_cast<std::uint64_t>(f.u.x() + f.a + f.A(0, 0));
             Random random(static_cast<unsigned>(bits));
             return right(f) + random.vector();
         }}};
    for (const auto& [name, function] : wrong) {
        CAPTURE(name);
        CHECK(found(right, function) == "");
    }
}

} // namespace rigor::testing
