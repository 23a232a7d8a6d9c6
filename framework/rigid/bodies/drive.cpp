// SPDX-License-Identifier: MIT
// Poses and velocities of driven bodies, in closed form: a steady motion, an oscillation along a
// line, and a steady rotation. Each pose follows from the time alone and not from the pose one step
// before, so errors do not add up.
#include "rigid/bodies/drive.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigor {

namespace {

double elapsed(const Drive& drive, double time)
{
    return std::clamp(time, drive.start, drive.end) - drive.start;
}

// The phase of the oscillation when the body has been moving for s seconds [rad].
double phase_at(const Drive& drive, double s)
{
    return 2 * std::numbers::pi * drive.frequency * s + drive.phase;
}

Vector3d position_at(const Drive& drive, double time)
{
    const double s = elapsed(drive, time);
    const double swing = std::sin(phase_at(drive, s)) - std::sin(drive.phase);
    return drive.first_position + s * drive.velocity + swing * drive.amplitude;
}

// exp(v) q: the orientation q turned by the rotation vector v in world space.
Quaternion turned_by(const Quaternion& q, const Vector3d& v)
{
    const double angle = v.norm();
    if (!(angle > 0)) return q;
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(angle, v / angle));
    const Eigen::Quaterniond turned = turn * Eigen::Quaterniond(q.s, q.v.x(), q.v.y(), q.v.z());
    return {turned.w(), turned.vec()};
}

} // namespace

DriveVelocity drive_velocity(const Drive& drive, double time)
{
    if (time < drive.start || time >= drive.end) return {};
    const double s = elapsed(drive, time), w = 2 * std::numbers::pi * drive.frequency;
    return {drive.velocity + w * std::cos(phase_at(drive, s)) * drive.amplitude,
            drive.angular_velocity};
}

DriveVelocity mean_drive_velocity(const Drive& drive, double time, double time_step)
{
    if (!(time_step > 0)) return drive_velocity(drive, time);
    // The displacement is not computed as the difference of two positions, which would lose digits
    // in a short step. The body moves only in that part of the step that lies between `start` and
    // `end`. The change of the sine is a product: sin b - sin a = 2 cos((a + b)/2) sin((b - a)/2).
    const double waits = std::max(0.0, drive.start - time);
    const double rests = std::max(0.0, time + time_step - drive.end);
    const double moves = std::max(0.0, time_step - waits - rests);
    const double turn = std::numbers::pi * drive.frequency * moves; // half the change of the phase
    const double middle = phase_at(drive, elapsed(drive, time)) + turn;
    const double swing = 2 * std::cos(middle) * std::sin(turn);
    return {(moves * drive.velocity + swing * drive.amplitude) / time_step,
            moves / time_step * drive.angular_velocity};
}

RigidState driven_state(const Drive& drive, double time)
{
    RigidState state;
    state.position = drive.first_position;
    state.orientation = drive.first_orientation;
    if (drive.is_belt) return state;
    state.position = position_at(drive, time);
    state.orientation =
        turned_by(drive.first_orientation, elapsed(drive, time) * drive.angular_velocity);
    state.velocity = drive_velocity(drive, time).linear;
    return state;
}

} // namespace rigor
