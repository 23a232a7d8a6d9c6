// SPDX-License-Identifier: MIT
#include "scene/keys/shape_keys.hpp"

#include "scene/keys/kind.hpp"
#include "scene/keys/mesh_keys.hpp"
#include "scene/language/values.hpp"

namespace rigor {

namespace {

constexpr std::string_view shape_words = "a shape {\"sphere\": …}, {\"box\": …} or {\"plane\": {}}";

constexpr Key<Sphere> sphere_keys[] = {
    {"radius", "> 0 [m]", [](Sphere& s, const Value& v) { s.radius = positive(v, "a radius"); }},
};

constexpr Key<Capsule> capsule_keys[] = {
    {"radius", "> 0 [m]", [](Capsule& c, const Value& v) { c.radius = positive(v, "a radius"); }},
    {"height", "of the cylinder between the half balls, > 0 [m]",
     [](Capsule& c, const Value& v) { c.height = positive(v, "a height"); }},
};

constexpr Key<Torus> torus_keys[] = {
    {"radius", "from the axis to the middle of the tube, > 0 [m]",
     [](Torus& t, const Value& v) { t.radius = positive(v, "a radius"); }},
    {"tube", "radius of the tube, > 0, less than `radius` [m]",
     [](Torus& t, const Value& v) { t.tube = positive(v, "a tube"); }},
};

constexpr Key<Box> box_keys[] = {
    {"size", "full edge lengths along x, y, z, each > 0 [m]",
     [](Box& b, const Value& v) { b.size = positive3(v, "an edge length"); }},
};

constexpr Key<Cylinder> cylinder_keys[] = {
    {"radius", "> 0 [m]", [](Cylinder& c, const Value& v) { c.radius = positive(v, "a radius"); }},
    {"height", "> 0 [m]", [](Cylinder& c, const Value& v) { c.height = positive(v, "a height"); }},
};

constexpr Key<Cone> cone_keys[] = {
    {"radius", "of the base, > 0 [m]",
     [](Cone& c, const Value& v) { c.radius = positive(v, "a radius"); }},
    {"height", "> 0 [m]", [](Cone& c, const Value& v) { c.height = positive(v, "a height"); }},
};

constexpr Key<Ellipsoid> ellipsoid_keys[] = {
    {"radii", "semi-axes along x, y, z, each > 0 [m]",
     [](Ellipsoid& e, const Value& v) { e.radii = positive3(v, "a radius"); }},
};

void read_torus(ShapeDraft& draft, const Value& value)
{
    const Torus torus = read_kind<Torus>(value, torus_keys, {"radius", "tube"});
    less(value, "tube", torus.radius);
    draft.shape = torus;
}

constexpr Key<ShapeDraft> shape_keys[] = {
    {"sphere", "a solid ball about the origin: {\"radius\": 0.5}",
     [](ShapeDraft& s, const Value& v) {
         s.shape = read_kind<Sphere>(v, sphere_keys, {"radius"});
     }},
    {"box", "a solid box about the origin: {\"size\": [1, 2, 3]}",
     [](ShapeDraft& s, const Value& v) { s.shape = read_kind<Box>(v, box_keys, {"size"}); }},
    {"cylinder", "a solid cylinder about the origin, its axis along y",
     [](ShapeDraft& s, const Value& v) {
         s.shape = read_kind<Cylinder>(v, cylinder_keys, {"radius", "height"});
     }},
    {"cone", "a solid cone about its center of mass: the base at -height/4, the tip at 3/4 height",
     [](ShapeDraft& s, const Value& v) {
         s.shape = read_kind<Cone>(v, cone_keys, {"radius", "height"});
     }},
    {"capsule", "a cylinder along y between two half balls, about the origin",
     [](ShapeDraft& s, const Value& v) {
         s.shape = read_kind<Capsule>(v, capsule_keys, {"radius", "height"});
     }},
    {"ellipsoid", "a solid ellipsoid about the origin: {\"radii\": [1, 2, 3]}",
     [](ShapeDraft& s, const Value& v) {
         s.shape = read_kind<Ellipsoid>(v, ellipsoid_keys, {"radii"});
     }},
    {"torus", "a ring about y of circular section", read_torus},
    {"ring", "a ring about y of rectangular section, as a mesh", read_ring},
    {"cross", "three square bars along x, y and z, as a mesh", read_cross},
    {"bowl", "the lower half of a hollow ball, its rim at y = 0, as a mesh", read_bowl},
    {"gear", "a gear wheel about y, as a mesh", read_gear},
    {"angle", "an L in the plane of x and y about the middle of its bounds, as a mesh", read_angle},
    {"voussoir",
     "the top stone of a round arch about z, as a mesh; turned about z the others follow",
     read_voussoir},
    {"mesh", "the solid that a closed triangle mesh encloses: {\"file\": \"ring.obj\"}", read_mesh},
    {"plane", "the half-space y ≤ 0, static bodies only: {}",
     [](ShapeDraft& s, const Value& v) {
         if (v.kind != Value::Kind::object || !v.items.empty()) expected("{}", v);
         s.shape = Plane{};
     }},
};

} // namespace

Shape read_shape(const Value& value, MeshLibrary& meshes)
{
    ShapeDraft draft{meshes, {}};
    read_object<ShapeDraft>(value, shape_words, shape_keys, draft);
    if (value.items.size() != 1) expected(shape_words, value);
    return *draft.shape;
}

void shape_meanings(std::vector<KeyMeaning>& meanings)
{
    add_meanings<ShapeDraft>("shape", shape_keys, meanings);
    add_meanings<Sphere>("sphere", sphere_keys, meanings);
    add_meanings<Box>("box", box_keys, meanings);
    add_meanings<Cylinder>("cylinder", cylinder_keys, meanings);
    add_meanings<Cone>("cone", cone_keys, meanings);
    add_meanings<Capsule>("capsule", capsule_keys, meanings);
    add_meanings<Ellipsoid>("ellipsoid", ellipsoid_keys, meanings);
    add_meanings<Torus>("torus", torus_keys, meanings);
    mesh_meanings(meanings);
}

} // namespace rigor
