// SPDX-License-Identifier: MIT
#include "scene/trajectory/rigid_records.hpp"

#include "errors/quotes.hpp"

namespace rigor {

namespace {

void check_state(const RigidState& state, std::int64_t step, const std::string& body)
{
    const bool is_finite = state.position.allFinite() && std::isfinite(state.orientation.s) &&
                           state.orientation.v.allFinite() && state.velocity.allFinite() &&
                           state.angular_momentum.allFinite();
    if (is_finite) return; // the usual case: save the time for the text of an error
    const std::string where = fmt::format("step {}, body {}", step, in_quotes(body));
    check_finite(state.position, where, "position");
    check_finite(state.orientation.s, where, "orientation");
    check_finite(state.orientation.v, where, "orientation");
    check_finite(state.velocity, where, "velocity");
    check_finite(state.angular_momentum, where, "angular momentum");
}

} // namespace

RecordedBody read_recorded_body(ByteCursor& bytes, const BodyDescription& described)
{
    const std::string where = fmt::format("header, body {}", in_quotes(described.name));
    RecordedBody body;
    const std::uint8_t is_static = bytes.take<std::uint8_t>();
    if (is_static != (described.is_static ? 1 : 0))
        fail(where, described.is_static ? "a static body" : "a body that moves",
             fmt::format("mark {}", is_static));
    body.is_static = described.is_static;
    body.mass = bytes.take<double>();
    body.center_of_mass = bytes.take<Vector3d>();
    body.inertia = bytes.take<Matrix3d>();
    check_finite(body.mass, where, "mass");
    check_finite(body.center_of_mass, where, "center of mass");
    check_finite(body.inertia, where, "inertia");
    return body;
}

RigidState read_state(ByteCursor& bytes, std::int64_t step, const BodyDescription& body)
{
    RigidState state;
    state.position = bytes.take<Vector3d>();
    state.orientation.s = bytes.take<double>();
    state.orientation.v = bytes.take<Vector3d>();
    state.velocity = bytes.take<Vector3d>();
    state.angular_momentum = bytes.take<Vector3d>();
    check_state(state, step, body.name);
    return state;
}

ContactRecord read_contact(ByteCursor& bytes, std::int64_t step, std::int64_t bodies)
{
    const std::string where = fmt::format("step {}, a contact", step);
    ContactRecord contact;
    contact.body1 = bytes.take<std::int32_t>();
    contact.body2 = bytes.take<std::int32_t>();
    for (const int body : {contact.body1, contact.body2})
        if (body < 0 || body >= bodies)
            fail(where, fmt::format("a body from 0 to {}", bodies - 1), fmt::format("{}", body));
    contact.depth = bytes.take<double>();
    contact.point = bytes.take<Vector3d>();
    contact.normal = bytes.take<Vector3d>();
    contact.impulse = bytes.take<Vector3d>();
    check_finite(contact.depth, where, "depth");
    check_finite(contact.point, where, "point");
    check_finite(contact.normal, where, "normal");
    check_finite(contact.impulse, where, "impulse");
    return contact;
}

} // namespace rigor
