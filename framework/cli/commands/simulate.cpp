// SPDX-License-Identifier: MIT
#include "cli/commands/simulate.hpp"

#include "cli/options.hpp"
#include "cli/prepare.hpp"
#include "cli/progress.hpp"
#include "cli/scene_run.hpp"
#include "cli/states_table.hpp"
#include "errors/input_error.hpp"
#include "scene/keys/scene_keys.hpp"
#include "scene/run/run_scene.hpp"
#include "scene/trajectory/motion_hash.hpp"
#include "scene/trajectory/statistics.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fstream>
#include <nlohmann/json.hpp>

namespace rigor {

namespace {

struct SimulateOptions {
    std::string scene, with = "student", out, states;
    std::uint32_t threads = 1;
    bool stats = false, json = false, every_step = false;
};

// The largest values that a deformable solid reached during a run.
struct SolidExtremes {
    double stress = 0, plastic_strain = 0;   // stress [Pa]; the strain has no unit
    double mass_drift = 0, volume_drift = 0; // largest change, as a fraction of the first value

    void take(const SolidStatistics& now, const SolidStatistics& first)
    {
        stress = std::max(stress, now.largest_stress);
        plastic_strain = std::max(plastic_strain, now.largest_plastic_strain);
        mass_drift = std::max(mass_drift, std::abs(now.totals.mass / first.totals.mass - 1));
        volume_drift =
            std::max(volume_drift, std::abs(now.totals.volume / first.totals.volume - 1));
    }
};

// The numbers that --stats and --json print, collected frame by frame.
struct Summary {
    FrameStatistics first, last;
    double largest_energy = 0, deepest = 0; // total energy [J], penetration [m]
    std::int64_t frames = 0;
    Counters counters;
    MotionHash hash;
    std::vector<std::string> solids; // the names of the deformable solids
    std::vector<SolidExtremes> extremes;

    void take(const FrameStatistics& now)
    {
        if (frames++ == 0) {
            first = now;
            largest_energy = now.total_energy();
            extremes.resize(now.solids.size());
        }
        last = now;
        largest_energy = std::max(largest_energy, now.total_energy());
        deepest = std::max(deepest, now.deepest_penetration);
        for (std::size_t i = 0; i < now.solids.size(); ++i)
            extremes[i].take(now.solids[i], first.solids[i]);
    }
};

nlohmann::ordered_json numbers(const Vector3d& v)
{
    return {v.x(), v.y(), v.z()};
}

nlohmann::ordered_json solids_json(const Summary& summary)
{
    const auto moment = [](const SolidStatistics& s) -> nlohmann::ordered_json {
        return {{"mass", s.totals.mass},
                {"volume", s.totals.volume},
                {"kinetic_energy", s.totals.kinetic_energy},
                {"elastic_energy", s.totals.elastic_energy},
                {"momentum", numbers(s.totals.momentum)},
                {"angular_momentum", numbers(s.totals.angular_momentum)},
                {"center_of_mass", numbers(s.totals.center_of_mass)},
                {"elements", s.elements},
                {"pieces", s.pieces},
                {"largest_stress", s.largest_stress},
                {"largest_plastic_strain", s.largest_plastic_strain}};
    };
    nlohmann::ordered_json solids = nlohmann::ordered_json::array();
    for (std::size_t i = 0; i < summary.solids.size() && i < summary.extremes.size(); ++i) {
        const SolidExtremes& extremes = summary.extremes[i];
        solids.push_back({{"name", summary.solids[i]},
                          {"first", moment(summary.first.solids[i])},
                          {"last", moment(summary.last.solids[i])},
                          {"largest_stress", extremes.stress},
                          {"largest_plastic_strain", extremes.plastic_strain},
                          {"mass_drift", extremes.mass_drift},
                          {"volume_drift", extremes.volume_drift}});
    }
    return solids;
}

void print_json(const std::string& scene, const SimulateOptions& options, const Summary& summary,
                double seconds)
{
    const auto moment = [](const FrameStatistics& s) -> nlohmann::ordered_json {
        return {{"time", s.time},
                {"kinetic_energy", s.kinetic_energy},
                {"potential_energy", s.potential_energy},
                {"momentum", numbers(s.momentum)},
                {"angular_momentum", numbers(s.angular_momentum)}};
    };
    nlohmann::ordered_json counters;
    for (const auto& [name, member] : counter_fields) {
        std::string key(name);
        std::replace(key.begin(), key.end(), ' ', '_');
        counters[key] = summary.counters.*member;
    }
    nlohmann::ordered_json value = {
        {"scene", scene},
        {"with", options.with},
        {"frames", summary.frames},
        {"first", moment(summary.first)},
        {"last", moment(summary.last)},
        {"largest_energy", summary.largest_energy},
        {"deepest_penetration", summary.deepest},
        {"hash", summary.hash.text()},
        {"seconds", seconds},
        {"steps_per_second", static_cast<double>(summary.counters.steps) / seconds},
        {"counters", counters}};
    if (!summary.solids.empty()) value["solids"] = solids_json(summary);
    fmt::print("{}\n", value.dump(2));
}

std::string vector_text(const Vector3d& v)
{
    return fmt::format("({:.6g}, {:.6g}, {:.6g})", v.x(), v.y(), v.z());
}

void line(const char* what, const std::string& start, const std::string& end)
{
    fmt::print("  {:<32} {:<22} {}\n", what, start, end);
}

std::string number(double x)
{
    return fmt::format("{:.11g}", x);
}

void print_solid(const std::string& name, const SolidStatistics& first, const SolidStatistics& last,
                 const SolidExtremes& extremes)
{
    fmt::print("  solid \"{}\"\n", name);
    line("  mass [kg]", number(first.totals.mass), number(last.totals.mass));
    line("  volume [m³]", number(first.totals.volume), number(last.totals.volume));
    line("  kinetic energy [J]", number(first.totals.kinetic_energy),
         number(last.totals.kinetic_energy));
    line("  elastic energy [J]", number(first.totals.elastic_energy),
         number(last.totals.elastic_energy));
    fmt::print("  {:<32} {}\n  {:<32} {}\n", "  momentum [kg m/s]",
               vector_text(first.totals.momentum), "", vector_text(last.totals.momentum));
    line("  elements", std::to_string(first.elements), std::to_string(last.elements));
    line("  pieces", std::to_string(first.pieces), std::to_string(last.pieces));
    line("  largest stress [Pa]", number(first.largest_stress), number(last.largest_stress));
    line("  largest plastic strain", number(first.largest_plastic_strain),
         number(last.largest_plastic_strain));
    fmt::print("  {:<32} {:.8g}\n", "  largest stress of all [Pa]", extremes.stress);
    fmt::print("  {:<32} {:.3g}\n", "  drift of the mass, relative", extremes.mass_drift);
}

void print_stats(const Summary& summary, double seconds)
{
    line("", "at the start", "at the end");
    fmt::print("  {:<32} {}\n", "hash of the motion", summary.hash.text());
    line("time [s]", number(summary.first.time), number(summary.last.time));
    line("kinetic energy [J]", number(summary.first.kinetic_energy),
         number(summary.last.kinetic_energy));
    line("potential energy [J]", number(summary.first.potential_energy),
         number(summary.last.potential_energy));
    line("total energy [J]", number(summary.first.total_energy()),
         number(summary.last.total_energy()));
    fmt::print("  {:<32} {}\n  {:<32} {}\n", "momentum [kg m/s]",
               vector_text(summary.first.momentum), "", vector_text(summary.last.momentum));
    fmt::print("  {:<32} {}\n  {:<32} {}\n", "angular momentum [kg m²/s]",
               vector_text(summary.first.angular_momentum), "",
               vector_text(summary.last.angular_momentum));
    fmt::print("  {:<32} {:.8g}\n", "largest total energy [J]", summary.largest_energy);
    fmt::print("  {:<32} {:.3g}\n", "deepest penetration [m]", summary.deepest);
    fmt::print("  {:<32} {:.4g}\n", "steps a second",
               static_cast<double>(summary.counters.steps) / seconds);
    for (const auto& [name, member] : counter_fields)
        fmt::print("  {:<32} {}\n", name, summary.counters.*member);
    for (std::size_t i = 0; i < summary.extremes.size(); ++i)
        print_solid(summary.solids[i], summary.first.solids[i], summary.last.solids[i],
                    summary.extremes[i]);
}

// A file that is written while the scene runs, if it was asked for.
class OutputFile {
public:
    explicit OutputFile(const std::string& path) : path_(path)
    {
        if (path.empty()) return;
        file_.open(path, std::ios::binary);
        if (!file_) throw InputError(path + ": cannot be written");
    }
    bool is_wanted() const { return !path_.empty(); }
    void write(std::string_view bytes)
    {
        if (is_wanted()) file_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    }
    void close()
    {
        if (!is_wanted()) return;
        file_.close();
        if (!file_) throw InputError(path_ + ": cannot be written whole");
    }

private:
    std::string path_;
    std::ofstream file_;
};

int simulate(const SimulateOptions& options)
{
    if (options.threads < 1 || options.threads > 64)
        throw InputError(fmt::format("--threads: expected 1 to 64, found {}", options.threads));
    const Scene scene = load_scene(find_scene(options.scene));
    const Implementation implementation = working_implementation(options.with);
    OutputFile trajectory(options.out), states(options.states);
    states.write(states_header());
    Summary summary;
    std::optional<Statistics> statistics;
    Progress progress(scene.name);
    SceneRun run;
    run.threads = static_cast<int>(options.threads);
    run.record = options.every_step ? Record::every_step : Record::frames;
    run.on_bytes = [&](std::span<const std::byte> bytes) {
        trajectory.write({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    };
    run.on_start = [&](const Scene& started, const std::vector<RecordedBody>& bodies) {
        statistics.emplace(started, bodies);
        summary.hash.take(bodies);
        for (const SolidDescription& solid : started.solids)
            summary.solids.push_back(solid.name);
    };
    run.on_frame = [&](const Frame& frame) {
        summary.take(statistics->of(frame));
        summary.hash.take(frame);
        if (states.is_wanted()) states.write(states_lines(scene, *statistics, frame));
        progress.update(frame.time / scene.end,
                        fmt::format("{:.2f} s of {:g} s", frame.time, scene.end));
    };
    run.on_end = [&](const Counters& counters) { summary.counters = counters; };
    const RunOutcome outcome = run_in_worker(implementation, scene, run);
    progress.clear();
    trajectory.close();
    states.close();

    if (options.json)
        print_json(scene.name, options, summary, outcome.seconds);
    else if (summary.frames > 0) {
        fmt::print("{}: {} frames to t = {:g} s in {:.2f} s{}{}\n", scene.name, summary.frames,
                   summary.last.time, outcome.seconds,
                   options.out.empty() ? "" : ", stored in " + options.out,
                   options.states.empty() ? "" : ", states in " + options.states);
        if (options.stats) print_stats(summary, outcome.seconds);
    }
    return report_outcome(outcome, implementation);
}

} // namespace

Action declare_simulate(Options& options)
{
    const auto chosen = std::make_shared<SimulateOptions>();
    options.word("SCENE", chosen->scene,
                 "A scene file, or the name of one that ships: a4-collision/hundred_boxes");
    options.option("--with", "WHO", chosen->with, "student (the default), reference, or a folder");
    options.option("--out", "FILE", chosen->out, "Store the trajectory");
    options.option("--states", "FILE", chosen->states,
                   "Store the state of each body at each frame as a table (CSV)");
    options.option("--threads", "N", chosen->threads,
                   "Threads for the reference (1); the result is the same bits. Student code runs "
                   "on one");
    options.flag("--every-step", chosen->every_step, "Record every step, not only the frames");
    options.flag("--stats", chosen->stats,
                 "Print energy, momentum, penetration, steps a second, what was skipped, and "
                 "a hash of the motion");
    options.flag("--json", chosen->json, "Print those figures as JSON");
    options.examples({"simulate spinning_box --stats",
                      "simulate hundred_boxes --with reference --out boxes.trajectory",
                      "simulate pendulum.json --states pendulum.csv --every-step"});
    return [chosen] { return simulate(*chosen); };
}

} // namespace rigor
