// SPDX-License-Identifier: MIT
#include "scene/keys/solid_keys.hpp"

#include "errors/quotes.hpp"
#include "scene/keys/handle_keys.hpp"
#include "scene/keys/tetrahedra_keys.hpp"
#include "scene/language/orientation.hpp"
#include "scene/language/values.hpp"

#include <fmt/format.h>

namespace rigor {

namespace {

constexpr std::string_view node_integrators[] = {"explicit", "implicit", "velocity_modes",
                                                 "matrix"};
constexpr std::string_view yield_tests[] = {"strain", "yield_strain", "deviator", "frobenius",
                                            "principal"};
constexpr std::string_view flow_times[] = {"in_step", "after_step"};
constexpr std::string_view fracture_methods[] = {"faces", "elements", "virtual_nodes"};

// A solid, and the values whose meaning depends on other keys.
struct SolidDraft {
    SolidDescription solid;
    const Value *mesh = nullptr, *handles = nullptr, *loads = nullptr, *limit = nullptr;

    SolidMaterial& material() { return solid.material; }
};

double poisson_ratio(const Value& value)
{
    constexpr std::string_view what = "a Poisson's ratio between -1 and 0.5, both excluded";
    const double ratio = number(value, what);
    if (!(ratio > -1 && ratio < 0.5)) expected(what, value);
    return ratio;
}

constexpr Key<SolidDraft> solid_keys[] = {
    {"name", "needed, unique among bodies and solids",
     [](SolidDraft& d, const Value& v) { d.solid.name = line_of_text(v, "a name"); }},
    {"mesh", "needed: tetrahedra, of a kind with its sizes or of a file",
     [](SolidDraft& d, const Value& v) { d.mesh = &v; }},
    {"density", "ρ > 0, default 1000 [kg/m³]",
     [](SolidDraft& d, const Value& v) { d.material().density = positive(v, "a density"); }},
    {"youngs_modulus", "E > 0, default 1e6 [Pa]",
     [](SolidDraft& d, const Value& v) {
         d.material().youngs_modulus = positive(v, "a Young's modulus");
     }},
    {"poisson_ratio", "ν between -1 and 0.5, both excluded, default 0.3",
     [](SolidDraft& d, const Value& v) { d.material().poisson_ratio = poisson_ratio(v); }},
    {"damping", "β ≥ 0 of strain, the force -β K v, default 0 [s]",
     [](SolidDraft& d, const Value& v) { d.material().damping = not_negative(v, "a damping"); }},
    {"drag", "α ≥ 0 of motion, the force -α m v, default 0 [1/s]",
     [](SolidDraft& d, const Value& v) { d.material().drag = not_negative(v, "a drag"); }},
    {"yield_stress", "σ_Y > 0: the von Mises stress it flows at, default never [Pa]",
     [](SolidDraft& d, const Value& v) {
         d.material().yield_stress = positive(v, "a yield stress");
         d.limit = &v;
     }},
    {"yield_by",
     "the formula that finds out whether an element flows: \"strain\", \"yield_strain\", "
     "\"deviator\", \"frobenius\" or \"principal\", default the first",
     [](SolidDraft& d, const Value& v) {
         d.solid.yield_test = enumerator<YieldTest::principal>(v, yield_tests);
     }},
    {"flow", "when elements flow: \"in_step\" or once \"after_step\", default the first",
     [](SolidDraft& d, const Value& v) {
         d.solid.flow_time = enumerator<FlowTime::after_step>(v, flow_times);
     }},
    {"strength", "> 0: the largest principal stress it bears, it cracks beyond, default any [Pa]",
     [](SolidDraft& d, const Value& v) {
         d.material().strength = positive(v, "a strength");
         d.limit = &v;
     }},
    {"restitution", "ε from 0 to 1, default 0.5; of a pair the smaller counts",
     [](SolidDraft& d, const Value& v) {
         d.material().surface.restitution = in_range(v, "a restitution", 0, 1);
     }},
    {"friction", "μ ≥ 0, default 0.5; of a pair the geometric mean counts",
     [](SolidDraft& d, const Value& v) {
         d.material().surface.friction = not_negative(v, "a friction");
     }},
    {"integrator",
     "of its nodes: \"explicit\", in substeps as short as the mesh needs, \"implicit\", one linear "
     "system a step, or as one rigid body \"velocity_modes\" or \"matrix\"; default the second",
     [](SolidDraft& d, const Value& v) {
         d.solid.integrator = enumerator<NodeIntegrator::matrix>(v, node_integrators);
     }},
    {"fracture",
     "how a crack changes the mesh: \"faces\", \"elements\" or \"virtual_nodes\", default the "
     "first",
     [](SolidDraft& d, const Value& v) {
         d.solid.fracture_method = enumerator<FractureMethod::virtual_nodes>(v, fracture_methods);
     }},
    {"position", "of the frame's origin, default [0, 0, 0] [m]",
     [](SolidDraft& d, const Value& v) { d.solid.position = vector3(v); }},
    {"orientation", "of the frame, default none",
     [](SolidDraft& d, const Value& v) { d.solid.orientation = orientation(v); }},
    {"velocity", "of the center of mass, default [0, 0, 0] [m/s]",
     [](SolidDraft& d, const Value& v) { d.solid.velocity = vector3(v); }},
    {"angular_velocity",
     "of all of it about the center of mass, in world space, default [0, 0, 0] [rad/s]",
     [](SolidDraft& d, const Value& v) { d.solid.angular_velocity = vector3(v); }},
    {"color", "[red, green, blue], each from 0 to 1, default one of a palette",
     [](SolidDraft& d, const Value& v) { d.solid.color = color(v); }},
    {"handles", "nodes that are held or moved, a list",
     [](SolidDraft& d, const Value& v) { d.handles = &v; }},
    {"loads", "forces on nodes, a list", [](SolidDraft& d, const Value& v) { d.loads = &v; }},
};

// Refuses handles, a yield stress and a strength of a solid that moves as one rigid body.
void check_rigid(const SolidDraft& draft)
{
    const NodeIntegrator integrator = draft.solid.integrator;
    if (integrator != NodeIntegrator::velocity_modes && integrator != NodeIntegrator::matrix)
        return;
    const Value* refused = draft.handles ? draft.handles : draft.limit;
    if (refused)
        throw Mistake{
            refused->line,
            fmt::format("expected no {} of the solid {} that moves as a rigid body, found one",
                        draft.handles ? "\"handles\"" : "\"yield_stress\" or \"strength\"",
                        in_quotes(draft.solid.name))};
}

} // namespace

void read_solid(const Value& value, MeshLibrary& meshes, std::vector<SolidDescription>& solids)
{
    SolidDraft draft;
    read_object<SolidDraft>(value, "a solid {\"name\": …, \"mesh\": …}", solid_keys, draft);
    SolidDescription& solid = draft.solid;
    if (solid.name.empty())
        throw Mistake{value.line, "expected a \"name\" in the solid, found none"};
    if (!draft.mesh)
        throw Mistake{value.line, fmt::format("expected a \"mesh\" in the solid {}, found none",
                                              in_quotes(solid.name))};
    check_rigid(draft);
    solid.mesh = read_solid_mesh(*draft.mesh, meshes);
    if (draft.handles) solid.handles = read_handles(*draft.handles, solid);
    if (draft.loads) solid.loads = read_loads(*draft.loads, solid);
    solids.push_back(std::move(solid));
}

void solid_meanings(std::vector<KeyMeaning>& meanings)
{
    add_meanings<SolidDraft>("solid", solid_keys, meanings);
    tetrahedra_meanings(meanings);
    handle_meanings(meanings);
}

} // namespace rigor
