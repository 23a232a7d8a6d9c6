// SPDX-License-Identifier: MIT
#include "scene/keys/scene_keys.hpp"

#include "errors/input_error.hpp"
#include "errors/quotes.hpp"
#include "scene/keys/body_keys.hpp"
#include "scene/keys/force_keys.hpp"
#include "scene/keys/grid_keys.hpp"
#include "scene/keys/limits.hpp"
#include "scene/keys/picture_keys.hpp"
#include "scene/keys/solid_keys.hpp"
#include "scene/language/orientation.hpp"
#include "scene/language/values.hpp"
#include "scene/meshes/mesh_texts.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <set>

namespace rigor {

namespace {

// Files of more bytes and runs of more time steps are refused: the limits bound memory and run
// time.
constexpr std::uintmax_t most_bytes = 16'000'000;
constexpr double most_steps = 10'000'000;

struct SceneDraft {
    Scene scene;
    const Value *meshes = nullptr, *bodies = nullptr, *solids = nullptr, *springs = nullptr,
                *forces = nullptr, *pairs = nullptr, *time_step = nullptr, *end = nullptr,
                *frames_per_second = nullptr;
};

constexpr std::string_view integrators[] = {"matrix",      "linear",       "exponential",  "buss",
                                            "runge_kutta", "gram_schmidt", "euler_angles", "exact"};

constexpr std::string_view contact_methods[] = {"built_in", "one_at_a_time", "shock_propagation",
                                                "simultaneous"};

constexpr Key<Optimisations> optimisation_keys[] = {
    {"islands", "contacts solved group by group, default true",
     [](Optimisations& s, const Value& v) { s.islands = boolean(v); }},
    {"sleep", "bodies at rest left alone, default true",
     [](Optimisations& s, const Value& v) { s.sleep = boolean(v); }},
    {"warm_start", "impulses start from those of the step before, default true",
     [](Optimisations& s, const Value& v) { s.warm_start = boolean(v); }},
    {"early_exit", "sweeps end once nothing changes, default true",
     [](Optimisations& s, const Value& v) { s.early_exit = boolean(v); }},
    {"optimised_formulas",
     "the reference's formulas in a faster form of the same result, default true",
     [](Optimisations& s, const Value& v) { s.optimised_formulas = boolean(v); }},
    {"stress_bound",
     "the largest principal stress only where a bound on it exceeds the strength, default true",
     [](Optimisations& s, const Value& v) { s.stress_bound = boolean(v); }},
};

constexpr Key<SceneDraft> scene_keys[] = {
    {"description", "one sentence: what to see",
     [](SceneDraft& d, const Value& v) { d.scene.description = line_of_text(v, "a sentence"); }},
    {"gravity", "default [0, -9.81, 0] [m/s²]",
     [](SceneDraft& d, const Value& v) { d.scene.settings.gravity = vector3(v); }},
    {"time_step", "> 0, default 0.01 [s]", [](SceneDraft& d, const Value& v) { d.time_step = &v; }},
    {"end", "when the scene ends, at least one time step, default 1 [s]",
     [](SceneDraft& d, const Value& v) { d.end = &v; }},
    {"frames_per_second",
     "> 0, at most one a step, default 30 or one a step; a frame shows the nearest step",
     [](SceneDraft& d, const Value& v) { d.frames_per_second = &v; }},
    {"integrator",
     "of free flight: \"matrix\", \"linear\", \"exponential\", \"buss\", \"runge_kutta\", "
     "\"gram_schmidt\", \"euler_angles\" or \"exact\", default \"exact\"",
     [](SceneDraft& d, const Value& v) {
         d.scene.settings.integrator = enumerator<Integrator::exact>(v, integrators);
     }},
    {"contact",
     "how contacts hold: \"built_in\", \"one_at_a_time\", \"shock_propagation\" or "
     "\"simultaneous\", default the first",
     [](SceneDraft& d, const Value& v) {
         d.scene.settings.contact_method =
             enumerator<ContactMethod::simultaneous>(v, contact_methods);
     }},
    {"optimisations", "which optimisations are used",
     [](SceneDraft& d, const Value& v) {
         read_object<Optimisations>(v, "which optimisations to use {\"sleep\": false}",
                                    optimisation_keys, d.scene.settings.optimisations);
     }},
    {"meshes",
     "texts of meshes by file name; those of the files that the scene names are put here as it is "
     "loaded",
     [](SceneDraft& d, const Value& v) { d.meshes = &v; }},
    {"bodies", "a list of rigid bodies; at least one body or solid is needed",
     [](SceneDraft& d, const Value& v) { d.bodies = &v; }},
    {"solids", "a list of deformable solids", [](SceneDraft& d, const Value& v) { d.solids = &v; }},
    {"springs", "a list of springs", [](SceneDraft& d, const Value& v) { d.springs = &v; }},
    {"forces", "a list of forces", [](SceneDraft& d, const Value& v) { d.forces = &v; }},
    {"pairs", "a list of what holds for two bodies in particular",
     [](SceneDraft& d, const Value& v) { d.pairs = &v; }},
    {"camera", "where to look from",
     [](SceneDraft& d, const Value& v) { d.scene.camera = read_camera(v); }},
    {"draw", "what to draw besides the bodies",
     [](SceneDraft& d, const Value& v) { d.scene.overlays = read_overlays(v); }},
};

void read_times(SceneDraft& draft)
{
    Scene& scene = draft.scene;
    if (draft.time_step) scene.time_step = positive(*draft.time_step, "a time step");
    if (draft.end) scene.end = positive(*draft.end, "an end");
    const Value* blamed = draft.end ? draft.end : draft.time_step;
    if (scene.end < scene.time_step)
        throw Mistake{blamed->line,
                      fmt::format("expected an end of at least one time step ({} s), found {}",
                                  scene.time_step, scene.end)};
    if (scene.end / scene.time_step > most_steps)
        throw Mistake{blamed->line, fmt::format("expected at most {} steps, found {:.4g}",
                                                most_steps, scene.end / scene.time_step)};
    const double one_a_step = 1 / scene.time_step;
    scene.frames_per_second = std::min(scene.frames_per_second, one_a_step);
    if (!draft.frames_per_second) return;
    scene.frames_per_second = positive(*draft.frames_per_second, "a number of frames per second");
    constexpr double rounding = 1e-9; // relative tolerance, for the rounding of 1 / time step
    if (scene.frames_per_second > one_a_step * (1 + rounding))
        expected(fmt::format("at most one frame a step ({:.6g} per second)", one_a_step),
                 *draft.frames_per_second);
}

void read_bodies(const Value& value, MeshLibrary& meshes, std::vector<BodyDescription>& bodies)
{
    std::size_t shapes = 0, done = 0;
    for (const Value& item : array(value, "a list of bodies")) {
        read_body(item, meshes, bodies);
        for (; done < bodies.size(); ++done)
            shapes += bodies[done].parts.size();
        if (bodies.size() > most_bodies || shapes > most_shapes)
            throw Mistake{item.line, fmt::format("expected at most {} bodies and {} shapes in "
                                                 "all, found {} and {}",
                                                 most_bodies, most_shapes, bodies.size(), shapes)};
    }
}

void read_solids(const Value& value, MeshLibrary& meshes, std::vector<SolidDescription>& solids)
{
    std::size_t tetrahedra = 0;
    for (const Value& item : array(value, "a list of solids")) {
        read_solid(item, meshes, solids);
        tetrahedra += solids.back().mesh->tetrahedra.size();
        if (tetrahedra > most_scene_tetrahedra)
            throw Mistake{item.line, fmt::format("expected solids of at most {} tetrahedra, found "
                                                 "{}",
                                                 most_scene_tetrahedra, tetrahedra)};
    }
}

// Refuses a name that two bodies, two solids, or a body and a solid have.
void check_names(const SceneDraft& draft)
{
    std::set<std::string_view> names;
    const auto check = [&](const std::string& name, const Value& list) {
        if (names.insert(name).second) return;
        const Value* second = &list.items.back();
        for (const Value& item : list.items)
            if (find(item, "name")->text == name) second = &item;
        throw Mistake{find(*second, "name")->line,
                      fmt::format("expected a name of its own for each {}, found {} twice",
                                  draft.solids ? "body and solid" : "body", in_quotes(name))};
    };
    for (const BodyDescription& body : draft.scene.bodies)
        check(body.name, *draft.bodies);
    for (const SolidDescription& solid : draft.scene.solids)
        check(solid.name, *draft.solids);
}

void read_matter(SceneDraft& draft, const Value& root)
{
    if (!draft.bodies && !draft.solids)
        throw Mistake{root.line, "expected \"bodies\" or \"solids\" in the scene, found none"};
    MeshLibrary meshes;
    if (draft.meshes) meshes.read_texts(*draft.meshes);
    if (draft.bodies) read_bodies(*draft.bodies, meshes, draft.scene.bodies);
    if (draft.solids) read_solids(*draft.solids, meshes, draft.scene.solids);
    if (draft.scene.bodies.empty() && draft.scene.solids.empty())
        expected("at least one body or solid", draft.bodies ? *draft.bodies : *draft.solids);
    check_names(draft);
}

Scene read_scene(const std::string& text)
{
    const Value root = parse_json(text);
    SceneDraft draft;
    read_object<SceneDraft>(root, "a scene {\"bodies\": […], …}", scene_keys, draft);
    read_times(draft);
    read_matter(draft, root);
    if (draft.springs) draft.scene.springs = read_springs(*draft.springs, draft.scene.bodies);
    if (draft.forces) {
        ForcesRead read = read_forces(*draft.forces, draft.scene.bodies);
        draft.scene.forces = std::move(read.forces);
        draft.scene.world_forces = std::move(read.in_world);
    }
    if (draft.pairs) draft.scene.pairs = read_pairs(*draft.pairs, draft.scene.bodies);
    return std::move(draft.scene);
}

} // namespace

Scene parse_scene(const std::string& text, const std::string& file_name)
{
    if (text.size() > most_bytes)
        throw InputError(fmt::format("{}: expected a scene of at most {} bytes, found {}",
                                     file_name, most_bytes, text.size()));
    try {
        Scene scene = read_scene(text);
        scene.name = std::filesystem::path(file_name).filename().string();
        if (scene.name.ends_with(".json")) scene.name.resize(scene.name.size() - 5);
        scene.text = text;
        return scene;
    } catch (const Mistake& mistake) {
        throw InputError(fmt::format("{}:{}: {}", file_name, mistake.line, mistake.message));
    }
}

Scene load_scene(const std::filesystem::path& file)
{
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(file, error);
    if (!std::filesystem::is_regular_file(status))
        throw InputError(
            fmt::format("{}: expected a scene file, found {}", file.string(),
                        std::filesystem::exists(status) ? "something else" : "nothing"));
    if (const std::uintmax_t size = std::filesystem::file_size(file, error);
        !error && size > most_bytes)
        throw InputError(fmt::format("{}: expected a scene of at most {} bytes, found {}",
                                     file.string(), most_bytes, size));
    std::ifstream stream(file, std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(stream), {}};
    if (!stream)
        throw InputError(
            fmt::format("{}: expected a readable file, found it unreadable", file.string()));
    try {
        text = with_mesh_texts(text, file);
    } catch (const Mistake& mistake) {
        throw InputError(fmt::format("{}:{}: {}", file.string(), mistake.line, mistake.message));
    }
    return parse_scene(text, file.string());
}

std::vector<KeyMeaning> scene_language()
{
    std::vector<KeyMeaning> meanings;
    add_meanings<SceneDraft>("scene", scene_keys, meanings);
    body_meanings(meanings);
    orientation_meanings(meanings);
    grid_meanings(meanings);
    solid_meanings(meanings);
    force_meanings(meanings);
    add_meanings<Optimisations>("optimisations", optimisation_keys, meanings);
    picture_meanings(meanings);
    return meanings;
}

} // namespace rigor
