// SPDX-License-Identifier: MIT
#include "cli/commands/render.hpp"

#include "cli/draw.hpp"
#include "cli/options.hpp"
#include "cli/prepare.hpp"
#include "cli/scene_run.hpp"
#include "errors/input_error.hpp"
#include "scene/keys/scene_keys.hpp"
#include "scene/trajectory/trajectory_file.hpp"

#include <array>
#include <fstream>
#include <optional>

namespace rigor {

namespace {

struct RenderOptions {
    std::string scene, with = "student", out;
    DrawOptions draw;
};

bool is_trajectory(const std::string& file)
{
    std::ifstream stream(file, std::ios::binary);
    std::array<char, 8> magic = {};
    stream.read(magic.data(), magic.size());
    return stream && std::string_view(magic.data(), magic.size()) == "RIGORTRJ";
}

int render_trajectory(const RenderOptions& options)
{
    const Trajectory trajectory = load_trajectory(options.scene);
    Film film(options.out, trajectory.scene, options.draw);
    film.start(trajectory.scene, trajectory.bodies);
    FramePicker picker(trajectory.scene);
    for (const Frame& frame : trajectory.frames)
        if (picker.picks(frame.step)) film.add(frame);
    film.finish();
    if (!trajectory.complete)
        std::fprintf(stderr, "rigor: %s holds only a part of the run\n", options.scene.c_str());
    return exit_done;
}

int render(const RenderOptions& options)
{
    if (options.out.empty())
        throw InputError("--out: expected a folder for the frames, found none");
    check_drawing(options.draw);
    if (is_trajectory(options.scene)) return render_trajectory(options);
    const Scene scene = load_scene(find_scene(options.scene));
    const Implementation implementation = working_implementation(options.with);
    return render_scene(scene, implementation, options.out, options.draw);
}

} // namespace

int render_scene(const Scene& scene, const Implementation& implementation,
                 const std::string& folder, const DrawOptions& options)
{
    Film film(folder, scene, options);
    SceneRun run;
    run.on_start = [&](const Scene& started, const std::vector<RecordedBody>& bodies) {
        film.start(started, bodies);
    };
    run.on_frame = [&](const Frame& frame) { film.add(frame); };
    const RunOutcome outcome = run_in_worker(implementation, scene, run);
    film.finish(); // also after a failure, so that the frames before it are kept
    return report_outcome(outcome, implementation);
}

Action declare_render(Options& options)
{
    const auto chosen = std::make_shared<RenderOptions>();
    options.word("SCENE", chosen->scene,
                 "A scene file, the name of one that ships, or a trajectory that simulate stored");
    options.option("--with", "WHO", chosen->with, "student (the default), reference, or a folder");
    options.option("--out", "DIR", chosen->out, "Folder for frame_00000.png and so on");
    declare_drawing(options, chosen->draw);
    options.examples({"render spinning_box --out frames --axes --omega",
                      "render hundred_boxes --with reference --out frames --video"});
    return [chosen] { return render(*chosen); };
}

} // namespace rigor
