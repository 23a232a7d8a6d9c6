// SPDX-License-Identifier: MIT
#include "scene/keys/mesh_keys.hpp"

#include "geometry/meshes/generators.hpp"
#include "scene/keys/kind.hpp"
#include "scene/language/values.hpp"

#include <numbers>

namespace rigor {

namespace {

int whole(const Value& value, std::string_view what, int low, int high)
{
    return static_cast<int>(integer(value, what, low, high));
}

// The values of the keys of a mesh. Each kind of mesh uses only some of these values.
struct MeshDraft {
    const Value* file = nullptr;
    Vector3d scale = Vector3d::Ones();
    double depth = 0;
    int cells = 0, sides = 48, teeth = 0;
    double radius = 0, inner_radius = 0, outer_radius = 0, height = 0, length = 0, width = 0,
           thickness = 0, bore = 0, degrees = 0;
    Vector3d size = Vector3d::Zero();
};

using MeshKey = Key<MeshDraft>;

constexpr MeshKey cells_key = {
    "cells",
    "of the level set along the longest side, from 8 to 128, default 32 to 64 by the walls",
    [](MeshDraft& m, const Value& v) {
        m.cells = whole(v, "a number of cells", SolidMesh::least_cells, SolidMesh::most_cells);
    }};
constexpr MeshKey sides_key = {
    "sides", "of the polygon that stands for the circle, from 3 to 360, default 48",
    [](MeshDraft& m, const Value& v) { m.sides = whole(v, "a number of sides", 3, 360); }};

constexpr MeshKey mesh_keys[] = {
    {"file", "needed: an OBJ, OFF or STL file, its path from the scene's",
     [](MeshDraft& m, const Value& v) {
         line_of_text(v, "the name of a mesh file");
         m.file = &v;
     }},
    {"scale",
     "> 0, or three of them for x, y, z, default 1: what the coordinates are multiplied by",
     [](MeshDraft& m, const Value& v) { m.scale = scale3(v, "a scale"); }},
    {"depth",
     "of an open mesh, a terrain: how far the ground reaches below its lowest point, along -y, "
     "> 0 [m]",
     [](MeshDraft& m, const Value& v) { m.depth = positive(v, "a depth"); }},
    cells_key,
};

constexpr MeshKey ring_keys[] = {
    {"inner_radius", "> 0 [m]",
     [](MeshDraft& m, const Value& v) { m.inner_radius = positive(v, "a radius"); }},
    {"outer_radius", "more than `inner_radius` [m]",
     [](MeshDraft& m, const Value& v) { m.outer_radius = positive(v, "a radius"); }},
    {"height", "> 0 [m]", [](MeshDraft& m, const Value& v) { m.height = positive(v, "a height"); }},
    sides_key,
    cells_key,
};

constexpr MeshKey cross_keys[] = {
    {"length", "of each bar, > 0 [m]",
     [](MeshDraft& m, const Value& v) { m.length = positive(v, "a length"); }},
    {"width", "of each bar, > 0, less than `length` [m]",
     [](MeshDraft& m, const Value& v) { m.width = positive(v, "a width"); }},
    cells_key,
};

constexpr MeshKey bowl_keys[] = {
    {"radius", "outer, > 0 [m]",
     [](MeshDraft& m, const Value& v) { m.radius = positive(v, "a radius"); }},
    {"thickness", "> 0, less than `radius` [m]",
     [](MeshDraft& m, const Value& v) { m.thickness = positive(v, "a thickness"); }},
    sides_key,
    cells_key,
};

constexpr MeshKey gear_keys[] = {
    {"teeth", "from 4 to 200",
     [](MeshDraft& m, const Value& v) { m.teeth = whole(v, "a number of teeth", 4, 200); }},
    {"radius", "of the pitch circle, > 0: gears of the same radius per tooth mesh [m]",
     [](MeshDraft& m, const Value& v) { m.radius = positive(v, "a radius"); }},
    {"thickness", "> 0 [m]",
     [](MeshDraft& m, const Value& v) { m.thickness = positive(v, "a thickness"); }},
    {"bore", "radius of the hole, default 0: none [m]",
     [](MeshDraft& m, const Value& v) { m.bore = not_negative(v, "a bore"); }},
    cells_key,
};

constexpr MeshKey angle_keys[] = {
    {"size", "full extent along x, y, z, each > 0 [m]",
     [](MeshDraft& m, const Value& v) { m.size = positive3(v, "an extent"); }},
    {"width", "of foot and post, > 0, less than the extents along x and y [m]",
     [](MeshDraft& m, const Value& v) { m.width = positive(v, "a width"); }},
    cells_key,
};

constexpr MeshKey voussoir_keys[] = {
    {"inner_radius", "of the arch, > 0 [m]",
     [](MeshDraft& m, const Value& v) { m.inner_radius = positive(v, "a radius"); }},
    {"outer_radius", "more than `inner_radius` [m]",
     [](MeshDraft& m, const Value& v) { m.outer_radius = positive(v, "a radius"); }},
    {"degrees", "that the stone takes of the arch, from 1 to 90 [degrees]",
     [](MeshDraft& m, const Value& v) { m.degrees = in_range(v, "an angle", 1, 90); }},
    {"thickness", "along z, > 0 [m]",
     [](MeshDraft& m, const Value& v) { m.thickness = positive(v, "a thickness"); }},
    cells_key,
};

// Sets the shape to a generated mesh. The mesh library identifies a mesh by the values of all
// its keys.
void set_mesh(ShapeDraft& draft, const Value& value, const MeshDraft& m,
              const std::function<TriangleMesh()>& make)
{
    std::string key = value.key;
    for (const double x : {m.radius, m.inner_radius, m.outer_radius, m.height, m.length, m.width,
                           m.thickness, m.bore, m.degrees, m.size.x(), m.size.y(), m.size.z()})
        key += fmt::format(" {}", x);
    key += fmt::format(" {} {}", m.sides, m.teeth);
    draft.shape = Mesh{draft.meshes.generated(key, value, m.cells, make)};
}

} // namespace

void read_mesh(ShapeDraft& draft, const Value& value)
{
    const MeshDraft mesh = read_kind<MeshDraft>(value, mesh_keys, {"file"});
    draft.shape = Mesh{draft.meshes.from_file(*mesh.file, mesh.scale, mesh.depth, mesh.cells)};
}

void read_ring(ShapeDraft& draft, const Value& value)
{
    const MeshDraft m =
        read_kind<MeshDraft>(value, ring_keys, {"inner_radius", "outer_radius", "height"});
    less(value, "inner_radius", m.outer_radius);
    set_mesh(draft, value, m,
             [&] { return ring_mesh(m.inner_radius, m.outer_radius, m.height, m.sides); });
}

void read_cross(ShapeDraft& draft, const Value& value)
{
    const MeshDraft m = read_kind<MeshDraft>(value, cross_keys, {"length", "width"});
    less(value, "width", m.length);
    set_mesh(draft, value, m, [&] { return cross_mesh(m.length, m.width); });
}

void read_bowl(ShapeDraft& draft, const Value& value)
{
    const MeshDraft m = read_kind<MeshDraft>(value, bowl_keys, {"radius", "thickness"});
    less(value, "thickness", m.radius);
    set_mesh(draft, value, m, [&] { return bowl_mesh(m.radius, m.thickness, m.sides); });
}

void read_gear(ShapeDraft& draft, const Value& value)
{
    const MeshDraft m = read_kind<MeshDraft>(value, gear_keys, {"teeth", "radius", "thickness"});
    const double root = m.radius * (1 - 0.6 * std::numbers::pi / m.teeth);
    if (m.bore > 0) less(value, "bore", root);
    set_mesh(draft, value, m, [&] { return gear_mesh(m.teeth, m.radius, m.bore, m.thickness); });
}

void read_angle(ShapeDraft& draft, const Value& value)
{
    const MeshDraft m = read_kind<MeshDraft>(value, angle_keys, {"size", "width"});
    less(value, "width", std::min(m.size.x(), m.size.y()));
    set_mesh(draft, value, m, [&] { return angle_mesh(m.size, m.width); });
}

void read_voussoir(ShapeDraft& draft, const Value& value)
{
    const MeshDraft m = read_kind<MeshDraft>(
        value, voussoir_keys, {"inner_radius", "outer_radius", "degrees", "thickness"});
    less(value, "inner_radius", m.outer_radius);
    set_mesh(draft, value, m,
             [&] { return voussoir_mesh(m.inner_radius, m.outer_radius, m.degrees, m.thickness); });
}

void mesh_meanings(std::vector<KeyMeaning>& meanings)
{
    add_meanings<MeshDraft>("ring", ring_keys, meanings);
    add_meanings<MeshDraft>("cross", cross_keys, meanings);
    add_meanings<MeshDraft>("bowl", bowl_keys, meanings);
    add_meanings<MeshDraft>("gear", gear_keys, meanings);
    add_meanings<MeshDraft>("angle", angle_keys, meanings);
    add_meanings<MeshDraft>("voussoir", voussoir_keys, meanings);
    add_meanings<MeshDraft>("mesh", mesh_keys, meanings);
}

} // namespace rigor
