// SPDX-License-Identifier: MIT
#include "scene/keys.hpp"

#include "errors/nearest.hpp"
#include "errors/quotes.hpp"
#include "scene/grammar.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

namespace rigor {

namespace {

constexpr double largest = 1e12, smallest = 1e-12;

std::string list(std::span<const std::string_view> names)
{
    std::string text;
    for (const std::string_view name : names)
        text += fmt::format("{}\"{}\"", text.empty() ? "" : ", ", name);
    return text;
}

Quaternion plain(const Eigen::Quaterniond& q)
{
    const Eigen::Quaterniond unit = q.normalized();
    return {unit.w(), unit.vec()};
}

} // namespace

void unknown_key(const Value& value, std::span<const std::string_view> names)
{
    const std::string_view near = nearest(value.key, names);
    std::string hint = near.empty() ? fmt::format("expected one of {}", list(names))
                                    : fmt::format("did you mean \"{}\"?", near);
    if (names.empty()) hint = "expected no key here";
    throw Mistake{value.line, fmt::format("unknown key {}; {}", in_quotes(value.key), hint)};
}

const Value* find(const Value& object, std::string_view key)
{
    for (const Value& item : object.items)
        if (item.key == key) return &item;
    return nullptr;
}

double number(const Value& value, std::string_view what)
{
    if (value.kind != Value::Kind::number) expected(what, value);
    if (!(std::abs(value.number) <= largest))
        expected(fmt::format("{} of at most 1e12 in size", what), value);
    return value.number;
}

double positive(const Value& value, std::string_view what)
{
    const std::string wanted = fmt::format("{} > 0", what);
    const double x = number(value, wanted);
    if (!(x > 0)) expected(wanted, value);
    if (x < smallest) expected(fmt::format("{} of at least 1e-12", what), value);
    return x;
}

double not_negative(const Value& value, std::string_view what)
{
    const std::string wanted = fmt::format("{} ≥ 0", what);
    const double x = number(value, wanted);
    if (!(x >= 0)) expected(wanted, value);
    return x;
}

double in_range(const Value& value, std::string_view what, double low, double high)
{
    const std::string wanted = fmt::format("{} from {} to {}", what, low, high);
    const double x = number(value, wanted);
    if (!(x >= low && x <= high)) expected(wanted, value);
    return x;
}

std::int64_t integer(const Value& value, std::string_view what, std::int64_t low, std::int64_t high)
{
    const std::string wanted = fmt::format("{}, a whole number from {} to {}", what, low, high);
    const double x = number(value, wanted);
    if (x != std::floor(x) || x < static_cast<double>(low) || x > static_cast<double>(high))
        expected(wanted, value);
    return static_cast<std::int64_t>(x);
}

bool boolean(const Value& value)
{
    if (value.kind != Value::Kind::boolean) expected("true or false", value);
    return value.truth;
}

std::string line_of_text(const Value& value, std::string_view what)
{
    if (value.kind != Value::Kind::string || value.text.empty()) expected(what, value);
    for (const char c : value.text)
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F)
            expected(fmt::format("{} without control characters", what), value);
    return value.text;
}

const std::vector<Value>& array(const Value& value, std::string_view what)
{
    if (value.kind != Value::Kind::array) expected(what, value);
    return value.items;
}

Vector3d vector3(const Value& value, std::string_view what)
{
    if (array(value, what).size() != 3) expected(what, value);
    Vector3d v;
    for (int i = 0; i < 3; ++i)
        v[i] = number(value.items[i]);
    return v;
}

Vector3d positive3(const Value& value, std::string_view what)
{
    const std::string wanted = fmt::format("three of {} > 0", what);
    if (array(value, wanted).size() != 3) expected(wanted, value);
    Vector3d v;
    for (int i = 0; i < 3; ++i)
        v[i] = positive(value.items[i], what);
    return v;
}

Vector3d color(const Value& value)
{
    if (array(value, "a color [red, green, blue]").size() != 3)
        expected("a color [red, green, blue]", value);
    Vector3d v;
    for (int i = 0; i < 3; ++i)
        v[i] = in_range(value.items[i], "a part of a color", 0, 1);
    return v;
}

std::size_t one_of(const Value& value, std::span<const std::string_view> words)
{
    if (value.kind == Value::Kind::string) {
        const auto word = std::find(words.begin(), words.end(), value.text);
        if (word != words.end()) return static_cast<std::size_t>(word - words.begin());
        const std::string_view near = nearest(value.text, words);
        if (!near.empty())
            throw Mistake{value.line, fmt::format("expected one of {}, found {}; did you mean "
                                                  "\"{}\"?",
                                                  list(words), describe(value), near)};
    }
    expected(fmt::format("one of {}", list(words)), value);
}

namespace {

struct Turn {
    const Value *axis = nullptr, *degrees = nullptr, *quaternion = nullptr, *euler = nullptr;
};

constexpr Key<Turn> turn_keys[] = {
    {"axis", "with `degrees`: the axis to turn about, of any length > 0",
     [](Turn& turn, const Value& value) { turn.axis = &value; }},
    {"degrees", "with `axis`: the angle [degrees]",
     [](Turn& turn, const Value& value) { turn.degrees = &value; }},
    {"quaternion", "alone: a unit quaternion [s, x, y, z], scalar first",
     [](Turn& turn, const Value& value) { turn.quaternion = &value; }},
    {"euler_degrees", "alone: [roll about x, pitch about y, yaw about z], x turned first [degrees]",
     [](Turn& turn, const Value& value) { turn.euler = &value; }},
};

Eigen::AngleAxisd turned(double degrees, const Vector3d& axis)
{
    return Eigen::AngleAxisd(degrees * std::numbers::pi / 180, axis);
}

Quaternion quaternion(const Value& value)
{
    constexpr std::string_view what = "a unit quaternion [s, x, y, z]";
    if (array(value, what).size() != 4) expected(what, value);
    Eigen::Vector4d q;
    for (int i = 0; i < 4; ++i)
        q[i] = number(value.items[i]);
    if (std::abs(q.norm() - 1) > 1e-6)
        throw Mistake{value.line,
                      fmt::format("expected {}, found one of length {:.6g}", what, q.norm())};
    return plain({q[0], q[1], q[2], q[3]});
}

} // namespace

Quaternion orientation(const Value& value)
{
    Turn turn;
    read_object<Turn>(value, "an orientation {\"axis\": …, \"degrees\": …}", turn_keys, turn);
    const int ways =
        (turn.axis || turn.degrees) + (turn.quaternion != nullptr) + (turn.euler != nullptr);
    if (ways != 1 || !turn.axis != !turn.degrees)
        expected("an orientation by \"axis\" and \"degrees\", by \"quaternion\" or by "
                 "\"euler_degrees\"",
                 value);
    if (turn.quaternion) return quaternion(*turn.quaternion);
    if (turn.euler) {
        const Vector3d angles = vector3(*turn.euler, "three angles in degrees");
        return plain(turned(angles.z(), Vector3d::UnitZ()) * turned(angles.y(), Vector3d::UnitY()) *
                     turned(angles.x(), Vector3d::UnitX()));
    }
    const Vector3d axis = vector3(*turn.axis, "an axis [x, y, z]");
    if (!(axis.norm() >= smallest)) expected("an axis of length > 0", *turn.axis);
    return plain(Eigen::Quaterniond(turned(number(*turn.degrees, "an angle"), axis.normalized())));
}

void orientation_meanings(std::vector<KeyMeaning>& meanings)
{
    add_meanings<Turn>("orientation", turn_keys, meanings);
}

} // namespace rigor
