// SPDX-License-Identifier: MIT
// Accuracy of contact: sticking and slipping, creep, bounces, heavy bodies on light ones, stacks.
// Bullet and ODE run the same scenes with their default settings.
#include "parts.hpp"

#include <algorithm>

using namespace rigor;

int main(int argc, char** argv)
{
    Bench bench("contact");
    std::vector<Contestant> all = contact_contestants();
    std::erase_if(all, [](const Contestant& c) {
        return c.is_ours() && c.method != "built_in" && c.method != "simultaneous";
    });
    measure_stick_or_slip(bench, all);
    measure_creep(bench, all);
    measure_bounces(bench, all);
    measure_elastic_bounces(bench, all);
    measure_heavy_on_light(bench, all);
    measure_stacks(bench, all);
    bench.note(
        "Steps of 1/60 s for 10 s unless a row says otherwise; no body sleeps; one thread. Unit "
        "cubes of 1 kg.");
    note_missing_engines(bench, all);
    return bench.finish(wants_json(argc, argv));
}
