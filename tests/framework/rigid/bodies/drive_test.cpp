// SPDX-License-Identifier: MIT
#include "rigid/bodies/drive.hpp"

#include "framework/rigid/worlds.hpp"
#include "support/catch.hpp"

using namespace rigor;
using namespace rigor::testing;

namespace {

Drive some_drive()
{
    Drive drive;
    drive.velocity = {1, -2, 0.5};
    drive.angular_velocity = {0.3, 2, -1};
    drive.amplitude = {0.1, 0.4, -0.2};
    drive.frequency = 1.3;
    drive.phase = 0.7;
    drive.start = 0.4;
    drive.end = 2.3;
    drive.first_position = {3, 4, 5};
    drive.first_orientation = turn({1, 2, 3}, 0.6);
    return drive;
}

} // namespace

TEST_CASE("drive: a body rests before its start and after its end", "[rigid]")
{
    const Drive drive = some_drive();
    const RigidState first = driven_state(drive, 0.2), last = driven_state(drive, 9);
    CHECK(first.position == drive.first_position);
    CHECK(first.velocity == Vector3d(0, 0, 0));
    CHECK(last.position == driven_state(drive, 2.3).position);
    CHECK(last.velocity == Vector3d(0, 0, 0));
    CHECK(drive_velocity(drive, 0.2).angular == Vector3d(0, 0, 0));
    CHECK(drive_velocity(drive, 9).angular == Vector3d(0, 0, 0));
    CHECK(last.angular_momentum == Vector3d(0, 0, 0));
}

TEST_CASE("drive: its velocity is the derivative of its place", "[rigid]")
{
    const Drive drive = some_drive();
    for (const double t : {0.5, 1.1, 2.0}) {
        std::vector<double> errors;
        for (const double h : {0.02, 0.01, 0.005}) {
            const Vector3d ahead = driven_state(drive, t + h).position;
            const Vector3d behind = driven_state(drive, t - h).position;
            errors.push_back(((ahead - behind) / (2 * h) - drive_velocity(drive, t).linear).norm());
        }
        CAPTURE(t, errors);
        check_order(errors, 2);
    }
}

TEST_CASE("drive: with its mean velocity a body goes from place to place of any step", "[rigid]")
{
    const Drive drive = some_drive();
    for (const double t : {0., 0.3, 0.9, 2.2, 3.})
        for (const double h : {0.01, 0.3, 1.}) {
            CAPTURE(t, h);
            const DriveVelocity mean = mean_drive_velocity(drive, t, h);
            const RigidState from = driven_state(drive, t), to = driven_state(drive, t + h);
            CHECK_THAT(from.position + h * mean.linear, IsClose(to.position, Rounding(64, 10)));
            const Vector3d w = h * mean.angular;
            const Matrix3d R =
                rotation_matrix(turn(w.norm() > 0 ? w : Vector3d(1, 0, 0), w.norm()));
            CHECK_THAT(R * rotation_matrix(from.orientation),
                       IsClose(rotation_matrix(to.orientation), Rounding(64, 1)));
        }
    CHECK(mean_drive_velocity(drive, 1, 0).linear == drive_velocity(drive, 1).linear);
}

TEST_CASE("drive: a belt stays where it is and its surface moves", "[rigid]")
{
    Drive drive = some_drive();
    drive.is_belt = true;
    CHECK(driven_state(drive, 1).position == drive.first_position);
    CHECK(driven_state(drive, 1).orientation.v == drive.first_orientation.v);
    CHECK(drive_velocity(drive, 1).linear == drive_velocity(some_drive(), 1).linear);
}
