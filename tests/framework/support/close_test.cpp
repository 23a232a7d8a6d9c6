// SPDX-License-Identifier: MIT
// Tests of the matchers: what they must refuse, and what they must say.
#include "support/close.hpp"

#include "support/largest_error.hpp"

#include <cmath>
#include <limits>

using namespace rigor;
using namespace rigor::testing;

namespace {

const double nan_value = std::numeric_limits<double>::quiet_NaN();
const double infinity = std::numeric_limits<double>::infinity();

template <class T> bool close(const T& actual, const T& expected, const Tolerance& tolerance)
{
    verdict() = {};
    const bool result = IsClose(expected, tolerance).match(actual);
    return result;
}

} // namespace

TEST_CASE("close: NaN is close to nothing", "[support]")
{
    CHECK_FALSE(close(nan_value, 1.0, Rounding(1e300, 1)));
    CHECK(verdict().status == "not_finite");
    CHECK_FALSE(close(nan_value, nan_value, Rounding(8, 1)));
    CHECK_FALSE(close(infinity, 1.0, Rounding(1e300, 1)));
    CHECK(close(infinity, infinity, Rounding(8, 1)));

    Body body;
    body.angular_momentum.y() = nan_value;
    CHECK_FALSE(close(body, Body(), Rounding(1e300, 1)));
    CHECK(verdict().place == "angular_momentum(1)");
}

TEST_CASE("close: the bound is k eps times the scale", "[support]")
{
    const double eps = std::numeric_limits<double>::epsilon();
    CHECK(close(1 + 8 * eps, 1.0, Rounding(8, 1)));
    CHECK_FALSE(close(1 + 9 * eps, 1.0, Rounding(8, 1)));
    CHECK(close(Vector3d(1000, 0, 1000 * eps), Vector3d(1000, 0, 0), Rounding(2)));
    CHECK_FALSE(close(Vector3d(1, 0, 1e-300), Vector3d(1, 0, 0), Exactly()));
    CHECK_FALSE(close(1e-300, 0.0, Rounding(8))); // a relative tolerance of 0 is 0
    CHECK(close(0.1, 0.0, Statistical(0.2, 100)));
    CHECK_FALSE(close(0.11, 0.0, Statistical(0.2, 100)));
}

TEST_CASE("close: the largest error that held is kept as a part of its tolerance", "[support]")
{
    const double eps = std::numeric_limits<double>::epsilon();
    double& largest = largest_error_in_tolerances();
    largest = 0;
    CHECK(close(1 + 2 * eps, 1.0, Rounding(8, 1)));
    CHECK(largest == 0.25);
    CHECK(close(Vector3d(1, 1 + 4 * eps, 1), Vector3d(1, 1, 1), Rounding(8, 1)));
    CHECK(close(1.0, 1.0, Exactly()));
    CHECK_FALSE(close(2.0, 1.0, Rounding(8, 1))); // a failure has its own error
    CHECK(largest == 0.5);
    check_at_most(1 + 3 * eps, 1, "a value", 1); // 4 eps are allowed
    CHECK(largest == 0.75);
}

TEST_CASE("close: the bound comes from the expected value alone", "[support]")
{
    // A bound that grew with the answer would accept any answer that is large enough.
    for (int power = 0; power <= 1000; power += 100) {
        const double answer = std::ldexp(1, power);
        CHECK_FALSE(close(answer, 0.0, Rounding(1e6)));
        CHECK_FALSE(close(answer, 0.5, Rounding(1e6)));
        CHECK_FALSE(close(Vector3d(1, answer, 0), Vector3d(1, 0, 0), Rounding(1e6)));
        CHECK_FALSE(close(Matrix3d(answer * Matrix3d::Identity()), Matrix3d(Matrix3d::Zero()),
                          Rounding(1e6)));
    }
}

TEST_CASE("close: a sign is not lost", "[support]")
{
    CHECK_FALSE(close(-1.0, 1.0, Rounding(1e6)));
    CHECK_FALSE(close(Vector3d(0, 0, -1), Vector3d(0, 0, 1), Rounding(1e6)));
    CHECK_FALSE(close(-infinity, infinity, Rounding(1e6)));
    CHECK_FALSE(close(Vector3d(1, 2, 3), Vector3d(1, 2, -3), Rounding(1e6)));
}

TEST_CASE("close: the component that exceeds its bound most is reported", "[support]")
{
    const auto worst = [](const std::vector<double>& errors, const std::vector<double>& scales) {
        std::vector<double> actual = scales; // each number has the bound 0.1 times its scale
        for (std::size_t i = 0; i < errors.size(); ++i)
            actual[i] += errors[i];
        const Tolerance tolerance = {"R", 0, 0.1, ""};
        return difference_between(components(actual), components(scales), tolerance).index;
    };
    CHECK(worst({1, 0.5}, {1, 0.1}) == 1);
    CHECK(worst({0.5, 1}, {0.1, 1}) == 0);
    CHECK(worst({1, 2, 1.5}, {0, 0, 0}) == 1); // with the bound 0 the largest error
    CHECK(worst({1e-3, 1, 1e-3}, {0, 1, 0}) == 0);
}

TEST_CASE("close: a wrong component hides behind no other", "[support]")
{
    // Each component is compared by itself. A NaN is refused although it exceeds no bound.
    const Vector3d expected(1, 2, 3);
    for (int i = 0; i < 3; ++i) {
        Vector3d actual = expected;
        actual[i] = nan_value;
        CHECK_FALSE(close(actual, expected, Rounding(1e300, 1)));
        CHECK(verdict().status == "not_finite");
        actual = expected;
        actual[i] += 1e-9;
        CHECK_FALSE(close(actual, expected, Rounding(1e3)));
    }
}

TEST_CASE("close: the worst component is named with both its values", "[support]")
{
    const Matrix3d expected = Matrix3d::Identity();
    Matrix3d actual = expected;
    actual(0, 2) = 1e-3;
    actual(1, 0) = 0.5;
    CHECK_FALSE(close(actual, expected, Rounding(8, 1)));
    CHECK(verdict().place == "(1, 0)");
    CHECK(verdict().error == 0.5);
    CHECK(verdict().expected == "(1 0 0; 0 1 0; 0 0 1); (1, 0): 0");
    CHECK(verdict().actual == "(1 0 0.001; 0.5 1 0; 0 0 1); (1, 0): 0.5");
    CHECK(verdict().tolerance_class == "R");
}

TEST_CASE("close: sizes and empty optionals are compared before numbers", "[support]")
{
    CHECK_FALSE(close(std::optional<int>(), std::optional<int>(0), Exactly()));
    CHECK_FALSE(close(std::optional<int>(0), std::optional<int>(), Exactly()));
    CHECK(close(std::optional<int>(), std::optional<int>(), Exactly()));
    CHECK_FALSE(close(std::vector<double>{1}, std::vector<double>{1, 2}, Exactly()));
    CHECK(close(std::vector<double>{1, 2}, std::vector<double>{1, 2}, Exactly()));
}

TEST_CASE("close: the first failure of a test case is the one reported", "[support]")
{
    verdict() = {};
    CHECK_FALSE(IsClose(1.0, Rounding(8, 1)).match(2.0));
    CHECK_FALSE(IsClose(1.0, Rounding(8, 1)).match(7.0));
    CHECK(verdict().actual == "2");
}

TEST_CASE("close: a reflection is no rotation", "[support]")
{
    CHECK(IsRotation().match(Matrix3d::Identity()));
    CHECK_FALSE(IsRotation().match(-Matrix3d::Identity()));
    CHECK_FALSE(IsRotation().match(2 * Matrix3d::Identity()));
    CHECK_FALSE(IsRotation().match(Matrix3d::Constant(nan_value)));
}

TEST_CASE("close: a bound that is not finite accepts nothing", "[support]")
{
    const Vector3d huge(1e200, 1e200, 0);
    const double overflown = huge.squaredNorm(); // as the scale of a law may be
    for (const double scale : {overflown, nan_value}) {
        CAPTURE(scale);
        CHECK_FALSE(close(1.0, 2.0, Rounding(8, scale)));
        CHECK(verdict().status == "failed");
        CHECK_FALSE(close(1.0, 1.0, Rounding(8, scale)));
        CHECK_FALSE(close(infinity, infinity, Rounding(8, scale)));
        CHECK_FALSE(close(1.0, 2.0, Order(scale)));
        CHECK_FALSE(close(1.0, 2.0, Statistical(scale, 100)));
    }
    CHECK_FALSE(close(1.0, infinity, Rounding(8))); // the bound comes from the expected value
    CHECK_FALSE(close(huge, Vector3d(1e200, infinity, 0), Rounding(8)));
    CHECK(close(huge, huge, Rounding(8)));
    CHECK(close(infinity, infinity, Exactly()));
    CHECK_FALSE(close(1.0, infinity, Exactly()));
}

TEST_CASE("close: the failure says that the tolerance is not finite", "[support]")
{
    verdict() = {};
    const Tolerance tolerance = Rounding(8, infinity);
    const Difference difference = compare(1.0, 2.0, tolerance);
    CHECK(difference.kind == Difference::unbounded);
    CHECK(describe("2", tolerance, difference).find("the tolerance is not finite") !=
          std::string::npos);
    verdict() = {};
}
