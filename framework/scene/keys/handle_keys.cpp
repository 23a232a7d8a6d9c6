// SPDX-License-Identifier: MIT
// Reads the handles, which prescribe the motion of nodes of a solid, and the loads, which are
// forces on nodes.
#include "scene/keys/handle_keys.hpp"
#include "errors/quotes.hpp"
#include "geometry/bounds/bounds.hpp"
#include "geometry/shapes/pose.hpp"
#include "scene/language/values.hpp"

#include <fmt/format.h>

#include <numbers>

namespace rigor {

namespace {

struct Region {
    Vector3d from = Vector3d::Zero(), to = Vector3d::Zero(); // [m]
};

constexpr Key<Region> region_keys[] = {
    {"from", "needed: the corner of a box with the least x, y and z, in the solid's frame [m]",
     [](Region& r, const Value& v) { r.from = vector3(v, "a corner [x, y, z]"); }},
    {"to", "needed: the opposite corner; what lies on the border is inside [m]",
     [](Region& r, const Value& v) { r.to = vector3(v, "a corner [x, y, z]"); }},
};

std::string text(const Vector3d& v)
{
    return fmt::format("({:.6g}, {:.6g}, {:.6g})", v.x(), v.y(), v.z());
}

// The nodes of a solid that lie in a region, which is a box.
std::vector<int> nodes_in(const Value& value, const SolidDescription& solid)
{
    Region region;
    read_object<Region>(value, "a region {\"from\": […], \"to\": […]}", region_keys, region);
    for (const std::string_view name : {"from", "to"})
        if (!find(value, name)) expected(fmt::format("a \"{}\" in the region", name), value);
    if (!(region.from.array() <= region.to.array()).all())
        throw Mistake{value.line, fmt::format("expected a region whose \"to\" is nowhere below its "
                                              "\"from\", found {} and {}",
                                              text(region.from), text(region.to))};
    Bounds bounds;
    for (const Vector3d& v : solid.mesh->vertices)
        bounds.include({v, v});
    // Nodes on the border of the region count as inside, despite the rounding of their positions.
    const double rounding = 1e-9 * (bounds.high - bounds.low).norm();
    std::vector<int> nodes;
    for (std::size_t i = 0; i < solid.mesh->vertices.size(); ++i) {
        const Vector3d& p = solid.mesh->vertices[i];
        if ((p.array() >= region.from.array() - rounding).all() &&
            (p.array() <= region.to.array() + rounding).all())
            nodes.push_back(static_cast<int>(i));
    }
    if (nodes.empty())
        throw Mistake{
            value.line,
            fmt::format("expected a region that holds a node of {} (from {} to {}), found "
                        "none in it",
                        in_quotes(solid.name), text(bounds.low), text(bounds.high))};
    return nodes;
}

struct MomentDraft {
    HandleMoment moment;
    const Value* time = nullptr;
};

struct Rotation {
    const Value *axis = nullptr, *degrees = nullptr;
};

constexpr Key<Rotation> rotation_keys[] = {
    {"axis", "needed: in world space, of any length > 0",
     [](Rotation& r, const Value& v) { r.axis = &v; }},
    {"degrees", "needed: the angle, of any size [degrees]",
     [](Rotation& r, const Value& v) { r.degrees = &v; }},
};

// A rotation vector: the axis times the angle [rad]. Unlike a quaternion, it can describe more than
// one full turn.
Vector3d rotation_vector(const Value& value)
{
    Rotation rotation;
    read_object<Rotation>(value, "a rotation {\"axis\": […], \"degrees\": …}", rotation_keys,
                          rotation);
    if (!rotation.axis || !rotation.degrees)
        expected("an \"axis\" and \"degrees\" in the rotation", value);
    const Vector3d axis = vector3(*rotation.axis, "an axis [x, y, z]");
    if (!(axis.norm() >= smallest_number)) expected("an axis of length > 0", *rotation.axis);
    return number(*rotation.degrees, "an angle") * std::numbers::pi / 180 * axis.normalized();
}

constexpr Key<MomentDraft> moment_keys[] = {
    {"time", "needed, > 0, later than the one before [s]",
     [](MomentDraft& d, const Value& v) {
         d.time = &v;
         d.moment.time = positive(v, "a time");
     }},
    {"displacement", "from where the nodes are at first, in world space, default [0, 0, 0] [m]",
     [](MomentDraft& d, const Value& v) { d.moment.displacement = vector3(v); }},
    {"rotation", "from how they are at first, about the pivot, default none",
     [](MomentDraft& d, const Value& v) { d.moment.rotation = rotation_vector(v); }},
};

// Reads the path of a handle. The path starts at time 0 without displacement and rotation.
std::vector<HandleMoment> read_path(const Value& value)
{
    std::vector<HandleMoment> path(1);
    for (const Value& item : array(value, "a list of moments")) {
        MomentDraft draft;
        read_object<MomentDraft>(item, "a moment {\"time\": …, \"displacement\": […]}", moment_keys,
                                 draft);
        if (!draft.time) expected("a \"time\" in the moment", item);
        if (!(draft.moment.time > path.back().time))
            expected(fmt::format("a time > {}", path.back().time), *draft.time);
        path.push_back(draft.moment);
    }
    if (path.size() == 1) expected("at least one moment", value);
    return path;
}

constexpr std::string_view axis_words[] = {"x", "y", "z"};

std::array<bool, 3> read_axes(const Value& value)
{
    std::array<bool, 3> axes = {false, false, false};
    for (const Value& item : array(value, "a list of axes [\"x\", \"y\"]"))
        axes[one_of(item, axis_words)] = true;
    if (value.items.empty()) expected("at least one axis", value);
    return axes;
}

struct HandleDraft {
    Handle handle;
    const Value *region = nullptr, *pivot = nullptr;
};

constexpr Key<HandleDraft> handle_keys[] = {
    {"region", "needed: its nodes are those in this box",
     [](HandleDraft& d, const Value& v) { d.region = &v; }},
    {"axes",
     "which of \"x\", \"y\" and \"z\" of world space it holds, a list, default all; the rest is "
     "free",
     [](HandleDraft& d, const Value& v) { d.handle.axes = read_axes(v); }},
    {"path", "a list of moments; from 0 s to the first and between two of them it moves evenly",
     [](HandleDraft& d, const Value& v) { d.handle.path = read_path(v); }},
    {"pivot", "what it rotates about, in the solid's frame, default the middle of its nodes [m]",
     [](HandleDraft& d, const Value& v) { d.pivot = &v; }},
    {"release", "> 0: when it lets go, default never [s]",
     [](HandleDraft& d, const Value& v) { d.handle.release = positive(v, "a time"); }},
};

struct LoadDraft {
    NodeLoad load;
    const Value *region = nullptr, *force = nullptr, *end = nullptr;
};

constexpr Key<LoadDraft> load_keys[] = {
    {"region", "needed: on the nodes in this box",
     [](LoadDraft& d, const Value& v) { d.region = &v; }},
    {"force", "needed: the sum over the nodes, which have equal shares of it, in world space [N]",
     [](LoadDraft& d, const Value& v) {
         d.force = &v;
         d.load.force = vector3(v);
     }},
    {"start", "≥ 0, default 0 [s]",
     [](LoadDraft& d, const Value& v) { d.load.start = not_negative(v, "a start"); }},
    {"end", "later than `start`, default never [s]",
     [](LoadDraft& d, const Value& v) {
         d.end = &v;
         d.load.end = number(v, "an end");
     }},
};

Vector3d middle_of(const std::vector<int>& nodes, const TetrahedralMesh& mesh)
{
    Bounds bounds;
    for (const int node : nodes)
        bounds.include({mesh.vertices[node], mesh.vertices[node]});
    return (bounds.low + bounds.high) / 2;
}

} // namespace

std::vector<Handle> read_handles(const Value& value, const SolidDescription& solid)
{
    std::vector<Handle> handles;
    for (const Value& item : array(value, "a list of handles")) {
        HandleDraft draft;
        read_object<HandleDraft>(item, "a handle {\"region\": …}", handle_keys, draft);
        if (!draft.region) expected("a \"region\" in the handle", item);
        draft.handle.nodes = nodes_in(*draft.region, solid);
        const Vector3d pivot = draft.pivot ? vector3(*draft.pivot, "a pivot [x, y, z]")
                                           : middle_of(draft.handle.nodes, *solid.mesh);
        draft.handle.pivot = rotation_matrix(solid.orientation) * pivot + solid.position;
        handles.push_back(std::move(draft.handle));
    }
    return handles;
}

std::vector<NodeLoad> read_loads(const Value& value, const SolidDescription& solid)
{
    std::vector<NodeLoad> loads;
    for (const Value& item : array(value, "a list of loads")) {
        LoadDraft draft;
        read_object<LoadDraft>(item, "a load {\"region\": …, \"force\": […]}", load_keys, draft);
        if (!draft.region) expected("a \"region\" in the load", item);
        if (!draft.force) expected("a \"force\" in the load", item);
        if (draft.load.end <= draft.load.start)
            expected(fmt::format("an end > {}", draft.load.start), *draft.end);
        draft.load.nodes = nodes_in(*draft.region, solid);
        loads.push_back(std::move(draft.load));
    }
    return loads;
}

void handle_meanings(std::vector<KeyMeaning>& meanings)
{
    add_meanings<HandleDraft>("handle", handle_keys, meanings);
    add_meanings<Region>("region", region_keys, meanings);
    add_meanings<MomentDraft>("moment", moment_keys, meanings);
    add_meanings<Rotation>("rotation", rotation_keys, meanings);
    add_meanings<LoadDraft>("load", load_keys, meanings);
}

} // namespace rigor
