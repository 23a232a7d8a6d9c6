// SPDX-License-Identifier: MIT
// How many multiplications it takes to turn a point, counted by numbers that count, and how many
// right and wrong formulas A8 has.
#include "formulas/rotation.hpp"
#include "graded/validation/drawn_forms.hpp"
#include "handouts/handouts.hpp"
#include "handouts/numbers.hpp"
#include "support/catch.hpp"

#include <fmt/format.h>

using namespace rigor;
using namespace rigor::handouts;
using namespace rigor::testing;

namespace {

int multiplications = 0;

struct Counted {
    double value = 0;
};

Counted operator+(Counted a, Counted b)
{
    return {a.value + b.value};
}

Counted operator-(Counted a, Counted b)
{
    return {a.value - b.value};
}

Counted operator*(Counted a, Counted b)
{
    ++multiplications;
    return {a.value * b.value};
}

struct Point {
    Counted x, y, z;
};

Point operator+(const Point& a, const Point& b)
{
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}

Point operator*(Counted s, const Point& a)
{
    return {s * a.x, s * a.y, s * a.z};
}

Point cross(const Point& a, const Point& b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

Counted dot(const Point& a, const Point& b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

// q (0, p) = (-v·p, s p + v × p), and of its product with (s, -v) the vector part alone.
Point by_two_products(Counted s, const Point& v, const Point& p)
{
    const Counted minus = dot(v, p);
    const Point u = s * p + cross(v, p);
    return minus * v + s * u + cross(v, u);
}

// p + s t + v × t with t = 2 v × p
Point by_short_form(Counted s, const Point& v, const Point& p)
{
    const Point half = cross(v, p), t = half + half;
    return p + s * t + cross(v, t);
}

struct Rows {
    Point x, y, z;
};

Rows matrix(Counted s, const Point& v)
{
    const Counted ss = s * s, xx = v.x * v.x, yy = v.y * v.y, zz = v.z * v.z;
    const Counted xy = v.x * v.y, xz = v.x * v.z, yz = v.y * v.z;
    const Counted sx = s * v.x, sy = s * v.y, sz = s * v.z;
    const auto twice = [](Counted a) { return a + a; };
    return {{ss + xx - yy - zz, twice(xy - sz), twice(xz + sy)},
            {twice(xy + sz), ss - xx + yy - zz, twice(yz - sx)},
            {twice(xz - sy), twice(yz + sx), ss - xx - yy + zz}};
}

Point by_matrix(const Rows& R, const Point& p)
{
    return {dot(R.x, p), dot(R.y, p), dot(R.z, p)};
}

// Counts, and checks that the point is turned as by the formula.
template <class Turn> int count(const Turn& turn)
{
    const Quaternion q = normalize({1, {2, 3, 4}});
    const Vector3d p(5, -6, 7), expected = rotate(q, p);
    const Point v = {{q.v.x()}, {q.v.y()}, {q.v.z()}};
    multiplications = 0;
    const Point turned = turn(Counted{q.s}, v, Point{{p.x()}, {p.y()}, {p.z()}});
    CHECK((Vector3d(turned.x.value, turned.y.value, turned.z.value) - expected).norm() < 1e-14);
    return multiplications;
}

} // namespace

TEST_CASE("A3: multiplications that turn a point", "[numbers]")
{
    const int product = count(by_two_products), short_form = count(by_short_form);
    const int first =
        count([](Counted s, const Point& v, const Point& p) { return by_matrix(matrix(s, v), p); });
    const int more = 9; // for each further point
    multiplications = 0;
    matrix({1}, {{0}, {0}, {0}});
    CHECK(multiplications == first - more);
    check_shown("A3", "take 24 multiplications", {double(product)});
    check_shown("A3", "so it wins at the first one, with 19 against 24.",
                {double(first), double(product)});
    check_shown("A3", "which takes 15 (multiply", {double(short_form)});
    check_shown("A3",
                "It wins at one point with 15 against 19, and loses from two points on, with 30 "
                "against 28.",
                {double(short_form), double(first), 2.0 * short_form, double(first + more)});
}

namespace {

std::string in_words(std::size_t n)
{
    const char* const words[] = {"no",  "one",   "two",   "three", "four", "five",
                                 "six", "seven", "eight", "nine",  "ten"};
    return n < std::size(words) ? words[n] : std::to_string(n);
}

std::string handout_of_validation()
{
    for (const Handout& handout : all_handouts())
        if (handout.label == "A8") return handout.text;
    FAIL("there is no handout of A8");
    return {};
}

} // namespace

TEST_CASE("the handout of A8 says how many formulas are tried", "[handouts]")
{
    const std::string text = handout_of_validation();
    const auto says = [&](const std::string& words) {
        CAPTURE(words);
        CHECK(text.find(words) != std::string::npos);
    };
    const auto right = [](std::size_t n, const char* what) {
        return in_words(n) + " right " + what;
    };

    says(fmt::format("- A8.1: {}; {} ordinary mistakes, such as exchanged masses; {} in",
                     right(right_collisions().size(), "formulas"),
                     line_collisions().ordinary.size(), line_collisions().special.size()));
    says(fmt::format("- A8.2: {}, {} ordinary mistakes, {} in special cases",
                     right(right_springs().size(), "formulas"), spring_forces().ordinary.size(),
                     spring_forces().special.size()));
    says(fmt::format("- A8.3: {}, {} ordinary mistakes, {} on and near single directions",
                     right(right_tangents().size(), "formulas"), tangents().ordinary.size(),
                     tangents().special.size()));
    says(fmt::format("- A8.4: {}, {} ordinary mistakes, {} in special cases",
                     right(right_steps().size(), "methods"), oscillator_steps().ordinary.size(),
                     oscillator_steps().special.size()));
    says(fmt::format("- A8.5: {} with and without roots; {} with a wrong power or a hidden "
                     "constant; {}\n",
                     right(right_units().size(), "formulas"), wrong_powers().size(),
                     wrong_thresholds().size()));
    says(fmt::format("how many of the {} ordinary and of the {} special wrong formulas",
                     line_collisions().ordinary.size(), line_collisions().special.size()));
}
