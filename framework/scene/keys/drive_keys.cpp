// SPDX-License-Identifier: MIT
#include "scene/keys/drive_keys.hpp"

#include "scene/language/values.hpp"

#include <fmt/format.h>

#include <numbers>

namespace rigor {

namespace {

struct DriveDraft {
    Drive drive;
    const Value *amplitude = nullptr, *frequency = nullptr, *phase = nullptr, *end = nullptr;
};

constexpr Key<DriveDraft> drive_keys[] = {
    {"velocity", "in world space, default [0, 0, 0] [m/s]",
     [](DriveDraft& d, const Value& v) { d.drive.velocity = vector3(v); }},
    {"angular_velocity",
     "in world space, about the origin of the body's frame, default [0, 0, 0] [rad/s]",
     [](DriveDraft& d, const Value& v) { d.drive.angular_velocity = vector3(v); }},
    {"amplitude", "of an oscillation beside that, in world space, default none [m]",
     [](DriveDraft& d, const Value& v) {
         d.drive.amplitude = vector3(v);
         d.amplitude = &v;
     }},
    {"frequency", "with `amplitude`: needed, > 0 [Hz]",
     [](DriveDraft& d, const Value& v) {
         d.drive.frequency = positive(v, "a frequency");
         d.frequency = &v;
     }},
    {"phase_degrees", "with `amplitude`: of the sine at `start`, default 0 [degrees]",
     [](DriveDraft& d, const Value& v) {
         d.drive.phase = number(v, "a phase") * std::numbers::pi / 180;
         d.phase = &v;
     }},
    {"start", "≥ 0: when it begins to move, default 0 [s]",
     [](DriveDraft& d, const Value& v) { d.drive.start = not_negative(v, "a start"); }},
    {"end", "later than `start`: when it stops, default never [s]",
     [](DriveDraft& d, const Value& v) {
         d.drive.end = number(v, "an end");
         d.end = &v;
     }},
    {"belt", "true if only its surface moves, as on a conveyor, default false",
     [](DriveDraft& d, const Value& v) { d.drive.is_belt = boolean(v); }},
};

} // namespace

Drive read_drive(const Value& value)
{
    DriveDraft draft;
    read_object<DriveDraft>(value, "a motion {\"velocity\": […]}", drive_keys, draft);
    const Drive& drive = draft.drive;
    if (draft.amplitude && !draft.frequency)
        throw Mistake{draft.amplitude->line, "expected \"frequency\" beside \"amplitude\", found "
                                             "none"};
    for (const Value* needs : {draft.frequency, draft.phase})
        if (needs && !draft.amplitude)
            throw Mistake{needs->line, fmt::format("expected \"amplitude\" beside \"{}\", found "
                                                   "none",
                                                   needs->key)};
    if (drive.end <= drive.start) expected(fmt::format("an end > {}", drive.start), *draft.end);
    if (drive.velocity.isZero(0) && drive.angular_velocity.isZero(0) && drive.amplitude.isZero(0))
        expected("a velocity, an angular velocity or an amplitude that is not zero", value);
    return drive;
}

void drive_meanings(std::vector<KeyMeaning>& meanings)
{
    add_meanings<DriveDraft>("driven", drive_keys, meanings);
}

} // namespace rigor
