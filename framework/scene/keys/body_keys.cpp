// SPDX-License-Identifier: MIT
#include "scene/keys/body_keys.hpp"

#include "errors/quotes.hpp"
#include "scene/keys/drive_keys.hpp"
#include "scene/keys/grid_keys.hpp"
#include "scene/keys/shape_keys.hpp"
#include "scene/language/inertia.hpp"
#include "scene/language/orientation.hpp"
#include "scene/language/values.hpp"

#include <fmt/format.h>

namespace rigor {

namespace {

struct PartDraft {
    MeshLibrary& meshes;
    std::optional<Shape> shape;
    Part part;
    bool has_density = false;
};

constexpr Key<PartDraft> part_keys[] = {
    {"shape", "needed: one shape",
     [](PartDraft& p, const Value& v) { p.shape = read_shape(v, p.meshes); }},
    {"position", "of the shape's origin in the body's frame, default [0, 0, 0] [m]",
     [](PartDraft& p, const Value& v) { p.part.position = vector3(v); }},
    {"orientation", "of the shape in the body's frame, default none",
     [](PartDraft& p, const Value& v) { p.part.orientation = orientation(v); }},
    {"density", "> 0, default the body's [kg/m³]",
     [](PartDraft& p, const Value& v) {
         p.part.density = positive(v, "a density");
         p.has_density = true;
     }},
};

constexpr Key<Drag> drag_keys[] = {
    {"linear", "c ≥ 0 of the force -c V, default 0 [kg/s]",
     [](Drag& d, const Value& v) { d.linear = not_negative(v, "a drag"); }},
    {"quadratic", "k ≥ 0 of the force -k v V, v the speed, default 0 [kg/m]",
     [](Drag& d, const Value& v) { d.quadratic = not_negative(v, "a drag"); }},
    {"turning", "d ≥ 0 of the torque -d ω, default 0 [N m s]",
     [](Drag& d, const Value& v) { d.turning = not_negative(v, "a drag"); }},
};

Drag read_drag(const Value& value)
{
    Drag drag;
    read_object<Drag>(value, "a drag {\"linear\": …}", drag_keys, drag);
    if (!drag.acts()) expected("a \"linear\", \"quadratic\" or \"turning\" drag > 0", value);
    return drag;
}

constexpr std::string_view mass_methods[] = {"exact",   "particles",    "grid",
                                             "samples", "bounding_box", "thin_rod"};

struct FilmDraft {
    LaterOrientation later;
    const Value *after = nullptr, *orientation = nullptr;
};

constexpr Key<FilmDraft> film_keys[] = {
    {"after", "needed: how long after the start, > 0 [s]",
     [](FilmDraft& f, const Value& v) {
         f.later.after = positive(v, "a time");
         f.after = &v;
     }},
    {"orientation", "needed: of the frame at that time",
     [](FilmDraft& f, const Value& v) {
         f.later.orientation = orientation(v);
         f.orientation = &v;
     }},
};

LaterOrientation read_film(const Value& value)
{
    FilmDraft draft;
    read_object<FilmDraft>(value, "a film {\"after\": …, \"orientation\": …}", film_keys, draft);
    if (!draft.after) expected("\"after\" in the film", value);
    if (!draft.orientation) expected("an \"orientation\" in the film", value);
    return draft.later;
}

// A body, and the values whose meaning depends on other keys.
struct BodyDraft {
    BodyDescription body;
    const Value *shape = nullptr, *parts = nullptr, *density = nullptr, *mass = nullptr,
                *inertia = nullptr, *motion = nullptr, *grid = nullptr, *spin = nullptr,
                *film = nullptr, *method = nullptr, *samples = nullptr, *drive = nullptr,
                *drag = nullptr, *turns = nullptr, *axis = nullptr;
    const Value* part_density = nullptr; // the first density that a part gives
};

constexpr Key<BodyDraft> body_keys[] = {
    {"name", "needed, unique: springs, forces and messages call the body by it",
     [](BodyDraft& d, const Value& v) { d.body.name = line_of_text(v, "a name"); }},
    {"shape", "one shape about the frame's origin; or `parts`",
     [](BodyDraft& d, const Value& v) { d.shape = &v; }},
    {"parts", "the shapes of a compound body, a list; parts that overlap count twice",
     [](BodyDraft& d, const Value& v) { d.parts = &v; }},
    {"density", "> 0, default 1000 [kg/m³]", [](BodyDraft& d, const Value& v) { d.density = &v; }},
    {"mass", "> 0, instead of densities; without `inertia` the matter is spread evenly [kg]",
     [](BodyDraft& d, const Value& v) { d.mass = &v; }},
    {"inertia",
     "with `mass`: three moments, or three rows of a symmetric matrix, about the frame's origin, "
     "which is then the center of mass [kg m²]",
     [](BodyDraft& d, const Value& v) { d.inertia = &v; }},
    {"mass_by",
     "how they are found from the shapes: \"exact\", \"particles\", \"grid\", \"samples\", "
     "\"bounding_box\" or, for a cylinder, \"thin_rod\", default the first",
     [](BodyDraft& d, const Value& v) {
         d.method = &v;
         d.body.mass_method = enumerator<MassMethod::thin_rod>(v, mass_methods);
     }},
    {"mass_samples",
     "with `mass_by`: cells along the longest edge, from 1 to 100, default 20; of \"samples\" the "
     "number of points, up to 1 000 000, default 10 000",
     [](BodyDraft& d, const Value& v) { d.samples = &v; }},
    {"position", "of the frame's origin, default [0, 0, 0] [m]",
     [](BodyDraft& d, const Value& v) { d.body.position = vector3(v); }},
    {"orientation", "of the frame, default none",
     [](BodyDraft& d, const Value& v) { d.body.orientation = orientation(v); }},
    {"velocity", "of the center of mass, default [0, 0, 0] [m/s]",
     [](BodyDraft& d, const Value& v) {
         d.body.velocity = vector3(v);
         d.motion = &v;
     }},
    {"angular_velocity", "in world space, default [0, 0, 0] [rad/s]",
     [](BodyDraft& d, const Value& v) {
         d.body.angular_velocity = vector3(v);
         d.motion = d.spin = &v;
     }},
    {"filmed", "instead of `angular_velocity`: the orientation a moment after the start",
     [](BodyDraft& d, const Value& v) {
         d.body.later = read_film(v);
         d.film = &v;
     }},
    {"restitution", "ε from 0 to 1, default 0.5; of a pair the smaller counts",
     [](BodyDraft& d, const Value& v) {
         d.body.material.restitution = in_range(v, "a restitution", 0, 1);
     }},
    {"friction", "μ ≥ 0, default 0.5; of a pair the geometric mean counts",
     [](BodyDraft& d, const Value& v) {
         d.body.material.friction = not_negative(v, "a friction");
     }},
    {"drag", "resistance of air or water, default none",
     [](BodyDraft& d, const Value& v) {
         d.body.drag = read_drag(v);
         d.drag = &v;
     }},
    {"turns", "false for a body that never turns, default true",
     [](BodyDraft& d, const Value& v) {
         if (!boolean(v)) d.turns = &v;
     }},
    {"turns_about", "the only axis that the body turns about, in world space, of any length > 0",
     [](BodyDraft& d, const Value& v) { d.axis = &v; }},
    {"group", "bodies of one group pass through each other: its name, default none",
     [](BodyDraft& d, const Value& v) { d.body.group = line_of_text(v, "the name of a group"); }},
    {"static", "true for a body that never moves, default false",
     [](BodyDraft& d, const Value& v) { d.body.is_static = boolean(v); }},
    {"driven", "instead of `static`: a motion that nothing can change, of a body without mass",
     [](BodyDraft& d, const Value& v) {
         d.body.drive = read_drive(v);
         d.drive = &v;
     }},
    {"color", "[red, green, blue], each from 0 to 1, default one of a palette",
     [](BodyDraft& d, const Value& v) { d.body.color = color(v); }},
    {"grid", "makes many of this body, named \"name 1\", \"name 2\" and so on",
     [](BodyDraft& d, const Value& v) { d.grid = &v; }},
};

void read_parts(BodyDraft& draft, const Value& value, MeshLibrary& meshes)
{
    if (!draft.shape == !draft.parts)
        throw Mistake{value.line,
                      fmt::format("expected {} in the body {}",
                                  draft.shape ? "either \"shape\" or \"parts\", not both,"
                                              : "a \"shape\" or \"parts\"",
                                  in_quotes(draft.body.name))};
    const double density = draft.density ? positive(*draft.density, "a density") : Part{}.density;
    std::vector<Part>& parts = draft.body.parts;
    if (draft.shape) {
        parts.push_back({read_shape(*draft.shape, meshes), Vector3d::Zero(), {}, density});
        return;
    }
    for (const Value& item : array(*draft.parts, "a list of parts")) {
        PartDraft part{meshes, {}, {}};
        part.part.density = density;
        read_object<PartDraft>(item, "a part {\"shape\": …}", part_keys, part);
        if (!part.shape) expected("a \"shape\" in the part", item);
        if (part.has_density && !draft.part_density) draft.part_density = find(item, "density");
        part.part.shape = *part.shape;
        parts.push_back(part.part);
    }
    if (parts.empty()) expected("at least one part", *draft.parts);
}

// Reads the mass of a body. Without an inertia, the mass is distributed evenly over the volume.
void read_mass(BodyDraft& draft)
{
    if (draft.inertia && !draft.mass)
        throw Mistake{draft.inertia->line, "expected \"mass\" beside \"inertia\", found none"};
    if (!draft.mass) return;
    const Value* density = draft.density ? draft.density : draft.part_density;
    if (density)
        throw Mistake{density->line, "expected either \"mass\" or \"density\", found both"};
    const double mass = positive(*draft.mass, "a mass");
    if (draft.inertia) {
        draft.body.mass = mass;
        draft.body.inertia = inertia(*draft.inertia);
        return;
    }
    double total = 0;
    for (const Part& part : draft.body.parts)
        total += volume(part.shape);
    for (Part& part : draft.body.parts)
        part.density = total > 0 ? mass / total : part.density;
}

// Reads the number of samples. Refuses it beside a method that uses no samples.
void read_mass_samples(BodyDraft& draft)
{
    if (!draft.samples) return;
    const MassMethod method = draft.body.mass_method;
    const bool is_random = method == MassMethod::samples;
    if (!is_random && method != MassMethod::grid && method != MassMethod::particles)
        throw Mistake{draft.samples->line,
                      "expected \"mass_by\" with \"particles\", \"grid\" or \"samples\" beside "
                      "\"mass_samples\", found none of these"};
    draft.body.mass_samples = static_cast<int>(
        integer(*draft.samples, "a number of samples", 1, is_random ? 1'000'000 : 100));
}

// Refuses the key "mass_by" where its method cannot compute the mass, and where no mass is to be
// computed: beside "inertia", and for a body that is static or driven.
void check_mass_method(const BodyDraft& draft)
{
    const BodyDescription& body = draft.body;
    if (body.mass_method == MassMethod::exact) return;
    const auto refuse = [&](std::string_view message) {
        throw Mistake{draft.method->line, std::string(message)};
    };
    if (body.mass) refuse("expected either \"inertia\" or \"mass_by\", found both");
    if (body.is_static) refuse("expected no \"mass_by\" of a static body, found one");
    for (const Part& part : body.parts)
        if (std::holds_alternative<Mesh>(part.shape))
            refuse("expected \"mass_by\" only for shapes that are no mesh, found a mesh");
    const bool is_cylinder =
        draft.shape && std::holds_alternative<Cylinder>(body.parts.front().shape);
    if (body.mass_method == MassMethod::thin_rod && !is_cylinder)
        refuse("expected one cylinder for \"thin_rod\", found another shape");
}

void check_film(const BodyDraft& draft)
{
    if (!draft.film) return;
    if (draft.spin)
        throw Mistake{draft.film->line,
                      "expected either \"angular_velocity\" or \"filmed\", found both"};
    if (draft.body.is_static)
        throw Mistake{draft.film->line, "expected no \"filmed\" of a static body, found one"};
}

// Checks that a driven body is not static, has no other motion and no mass, and is no plane. Then
// marks it as static, since only its drive moves it.
void read_driven(BodyDraft& draft)
{
    if (!draft.drive) return;
    BodyDescription& body = draft.body;
    if (body.is_static)
        throw Mistake{draft.drive->line, "expected either \"static\" or \"driven\", found both"};
    if (draft.motion)
        throw Mistake{draft.motion->line, "expected the motion of a driven body in \"driven\" "
                                          "alone, found it in the body too"};
    for (const Part& part : body.parts)
        if (std::holds_alternative<Plane>(part.shape))
            throw Mistake{draft.drive->line,
                          fmt::format("expected a shape of finite size for the driven body {}, "
                                      "found a plane",
                                      in_quotes(body.name))};
    for (const Value* value : {draft.mass, draft.density, draft.part_density, draft.inertia})
        if (value)
            throw Mistake{value->line,
                          fmt::format("expected no \"{}\" of the driven body {}, whose motion is "
                                      "given, found one",
                                      value->key, in_quotes(body.name))};
    body.is_static = true;
}

// Reads the keys "turns_about" and "turns": the only axis about which the body can turn, or the
// zero vector if it never turns. Refuses "filmed" beside them, and an initial angular velocity
// about an axis that differs by more than rounding (the relative tolerance is 1e-9).
void read_turning(BodyDraft& draft)
{
    const Value* value = draft.axis ? draft.axis : draft.turns;
    if (!value) return;
    if (draft.axis && draft.turns)
        throw Mistake{draft.axis->line, "expected either \"turns\": false or \"turns_about\", "
                                        "found both"};
    const Vector3d a = draft.axis ? vector3(*draft.axis) : Vector3d(0, 0, 0);
    if (draft.axis && a.isZero(0)) expected("an axis that is not zero", *value);
    if (draft.film)
        throw Mistake{draft.film->line,
                      fmt::format("expected no \"filmed\" beside \"{}\", found one", value->key)};
    const Vector3d& w = draft.body.angular_velocity;
    if (a.cross(w).norm() > 1e-9 * a.norm() * w.norm() || (a.isZero(0) && !w.isZero(0)))
        throw Mistake{draft.spin->line,
                      draft.axis ? "expected an angular velocity about \"turns_about\", found "
                                   "another axis"
                                 : "expected no angular velocity of a body that never turns, found "
                                   "one"};
    draft.body.only_axis = a;
}

// Refuses "drag", "turns" and "turns_about" of a body that is static or driven.
void check_moving(const BodyDraft& draft)
{
    for (const Value* value : {draft.drag, draft.turns, draft.axis})
        if (value && draft.body.is_static)
            throw Mistake{value->line,
                          fmt::format("expected no \"{}\" of a body that is static or driven, "
                                      "found one",
                                      value->key)};
}

void check_static(const BodyDraft& draft, const Value& value)
{
    const BodyDescription& body = draft.body;
    for (const Part& part : body.parts)
        if (std::holds_alternative<Plane>(part.shape) && !body.is_static)
            throw Mistake{value.line, fmt::format("expected \"static\": true for the plane {}, "
                                                  "found a body that moves",
                                                  in_quotes(body.name))};
    if (body.is_static && (!body.velocity.isZero(0) || !body.angular_velocity.isZero(0)))
        expected("no velocity of a static body", *draft.motion);
}

} // namespace

void read_body(const Value& value, MeshLibrary& meshes, std::vector<BodyDescription>& bodies)
{
    BodyDraft draft;
    read_object<BodyDraft>(value, "a body {\"name\": …, \"shape\": …}", body_keys, draft);
    if (draft.body.name.empty())
        throw Mistake{value.line, "expected a \"name\" in the body, found none"};
    read_parts(draft, value, meshes);
    read_driven(draft);
    read_mass(draft);
    read_mass_samples(draft);
    check_mass_method(draft);
    check_film(draft);
    check_static(draft, value);
    read_turning(draft);
    check_moving(draft);
    if (draft.grid)
        read_grid(*draft.grid, draft.body, bodies);
    else
        bodies.push_back(std::move(draft.body));
}

void body_meanings(std::vector<KeyMeaning>& meanings)
{
    add_meanings<BodyDraft>("body", body_keys, meanings);
    add_meanings<PartDraft>("part", part_keys, meanings);
    add_meanings<FilmDraft>("filmed", film_keys, meanings);
    add_meanings<Drag>("drag", drag_keys, meanings);
    drive_meanings(meanings);
    shape_meanings(meanings);
}

} // namespace rigor
