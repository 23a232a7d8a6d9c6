// SPDX-License-Identifier: MIT
#include "scene/language/orientation.hpp"

#include "scene/language/keys.hpp"
#include "scene/language/values.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace rigor {

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

Quaternion plain(const Eigen::Quaterniond& q)
{
    const Eigen::Quaterniond unit = q.normalized();
    return {unit.w(), unit.vec()};
}

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
    constexpr double rounding = 1e-6; // enough for numbers with seven digits in the file
    if (std::abs(q.norm() - 1) > rounding)
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
    if (!(axis.norm() >= smallest_number)) expected("an axis of length > 0", *turn.axis);
    return plain(Eigen::Quaterniond(turned(number(*turn.degrees, "an angle"), axis.normalized())));
}

void orientation_meanings(std::vector<KeyMeaning>& meanings)
{
    add_meanings<Turn>("orientation", turn_keys, meanings);
}

} // namespace rigor
