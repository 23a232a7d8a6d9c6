// SPDX-License-Identifier: MIT
#include "worker/proxy/scenes.hpp"

#include "rigid/bodies/non_finite.hpp"
#include "scene/keys/scene_keys.hpp"
#include "worker/protocol/wire.hpp"
#include "worker/proxy/own_time.hpp"
#include "worker/proxy/proxy.hpp"
#include "worker/scene_answers.hpp"

namespace rigor {

namespace {

// As long as this object lives, the engine's formulas take their answers from a run of the scene in
// the worker under test. Where the reference answers a formula, the worker is given that answer.
class Answered {
public:
    Answered(const Scene& scene, Bytes payload, Record record)
        : answers_(worker(), scene.name, std::move(payload), record == Record::every_step,
                   replaced_by_reference())
    {
        answer_from(&answers_);
    }
    ~Answered() { answer_from(nullptr); }
    Answered(const Answered&) = delete;
    Answered& operator=(const Answered&) = delete;

private:
    SceneAnswers answers_;
};

// The longest time that the engine of this process may take for a scene. With answers that make
// sense it takes a few seconds; senseless answers may give it meshes that grow without end.
constexpr double longest_run = 30 * sanitizer_factor; // time on a processor [s]

} // namespace

void run_scene_with_worker(const Scene& scene, Record record, const ByteSink& write)
{
    Bytes request;
    wire::encode(request, scene.text);
    wire::encode(request, scene.name);
    const Answered answered(scene, std::move(request), record);
    const OwnTimeLimit limit("scene " + scene.name, longest_run);
    try {
        // The scene is read again from its text, as the worker does, so that both engines start
        // from the same numbers.
        run_scene(parse_scene(scene.text, scene.name), record,
                  [&](std::span<const std::byte> bytes) {
                      limit.check();
                      write(bytes);
                  });
    } catch (const NonFiniteState& state) {
        throw NotFinite("scene " + scene.name, state.what());
    }
}

} // namespace rigor
