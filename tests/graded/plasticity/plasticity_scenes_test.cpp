// SPDX-License-Identifier: MIT
// A6.9: solids that are stretched, sheared, bent and dented keep the deformation that the formulas
// predict, and no more.
#include "support/in_words.hpp"
#include "support/scene_run.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace rigor;
using namespace rigor::testing;

namespace {

using std::numbers::pi;

// Young's modulus [Pa], yield stress [Pa], yield strain and length [m] of the bars that are
// stretched.
constexpr double E = 1e7, sigma_Y = 2e5, e_Y = sigma_Y / E, length = 2;

const SolidFrame& solid(const Frame& frame, std::size_t i = 0)
{
    return frame.solids.at(i);
}

// The extent of a solid along an axis [m].
double extent(const SolidFrame& solid, int axis)
{
    double low = solid.positions.at(0)[axis], high = low;
    for (const Vector3d& x : solid.positions) {
        low = std::min(low, x[axis]);
        high = std::max(high, x[axis]);
    }
    return high - low;
}

double least(const std::vector<float>& values)
{
    return *std::min_element(values.begin(), values.end());
}
double largest(const std::vector<float>& values)
{
    return *std::max_element(values.begin(), values.end());
}

const Frame& frame_at(const Trajectory& run, double time)
{
    const auto found = std::find_if(run.frames.begin(), run.frames.end(), [&](const Frame& frame) {
        return frame.time > time - run.scene.time_step / 2;
    });
    check_that(found != run.frames.end(), "the scene has a frame at that time");
    return *found;
}

// Stress and plastic strain of a bar with free sides that is stretched to and fro.
struct Bar {
    double plastic_strain = 0, stress = 0;
    void stretch(double e)
    {
        stress = std::clamp(E * (e - plastic_strain), -sigma_Y, sigma_Y);
        plastic_strain = e - stress / E;
    }
};

double stretch_of(const Frame& frame)
{
    return extent(solid(frame), 0) / length - 1;
}

// Mean position in `frame` of the nodes whose first position satisfies `where`.
template <class Where> Vector3d mean_place(const Trajectory& run, const Frame& frame, Where where)
{
    const auto& first = solid(run.frames.front()).positions;
    Vector3d sum = Vector3d::Zero();
    int count = 0;
    for (std::size_t i = 0; i < first.size(); ++i)
        if (where(first[i])) {
            sum += solid(frame).positions[i];
            ++count;
        }
    check_that(count > 0, "the solid has nodes at that place");
    return sum / count;
}

double degrees(double radians)
{
    return radians * 180 / pi;
}

} // namespace

TEST_CASE("plasticity: a stretched bar flows from its yield stress on", "[A6.9][plasticity]")
{
    const Trajectory run = run_scene("a6-plasticity/stretched_bar");
    for (const Frame& frame : run.frames) {
        if (frame.time > 1.005) break; // from then on it is held
        CAPTURE(frame.time);
        const double e = stretch_of(frame);
        // class B: the bar begins to flow between 0.95 and 1.1 of the yield strain
        if (e < 0.95 * e_Y)
            check_that(largest(solid(frame).plastic_strains) == 0,
                       "no plastic strain, up to a strain of 0.95 σ_Y/E");
        if (e < 1.1 * e_Y) continue;
        check_that(least(solid(frame).plastic_strains) > 0,
                   "plastic strain everywhere, from a strain of 1.1 σ_Y/E on");
        INFO("the stress of a bar that flows is σ_Y");
        REQUIRE_THAT(double{least(solid(frame).stresses)}, IsClose(sigma_Y, Order(1e-3 * sigma_Y)));
        REQUIRE_THAT(double{largest(solid(frame).stresses)},
                     IsClose(sigma_Y, Order(1e-3 * sigma_Y)));
    }
}

TEST_CASE("plasticity: a stretched bar that is let go stays longer by what it has flowed",
          "[A6.9][plasticity]")
{
    const Trajectory run = run_scene("a6-plasticity/stretched_bar");
    const SolidFrame& end = solid(run.frames.back());
    const double kept = 0.1 - e_Y; // stretched by 10 %, it springs back by σ_Y/E

    REQUIRE_THAT(extent(end, 0), IsClose(length * (1 + kept), Order(2e-5)));
    INFO("its width gives up half as much, so that the volume stays, to first order");
    REQUIRE_THAT(extent(end, 1), IsClose(0.4 * (1 - kept / 2), Order(5e-4)));
    REQUIRE_THAT(double{least(end.plastic_strains)}, IsClose(kept, Order(2e-3)));
    REQUIRE_THAT(double{largest(end.plastic_strains)}, IsClose(kept, Order(2e-3)));
    INFO("no stress is left");
    REQUIRE_THAT(double{largest(end.stresses)}, IsClose(0.0, Order(1e-3 * sigma_Y)));
    INFO("and no motion");
    REQUIRE_THAT(end.totals.kinetic_energy, IsClose(0.0, Order(1e-9)));
}

TEST_CASE("plasticity: cyclic load goes round one loop and heats by its area", "[A6.9][plasticity]")
{
    const Trajectory run = run_scene("a6-plasticity/cyclic_load");
    Bar bar;
    double heat = 0, last_stress = 0, last_e = 0;
    for (const Frame& frame : run.frames) {
        CAPTURE(frame.time);
        const double e = stretch_of(frame);
        bar.stretch(e);
        const double low = least(solid(frame).stresses), high = largest(solid(frame).stresses);
        INFO("a step of the handle, E h v, and the wave that it sends off");
        REQUIRE_THAT(low, IsClose(std::abs(bar.stress), Order(0.08 * sigma_Y)));
        REQUIRE_THAT(high, IsClose(std::abs(bar.stress), Order(0.08 * sigma_Y)));

        const double stress = std::copysign((low + high) / 2, bar.stress);
        if (frame.time > 2.505 && frame.time < 4.505)
            heat += (stress + last_stress) / 2 * (e - last_e);
        last_stress = stress;
        last_e = e;
    }
    INFO("one round, 4 σ_Y (e - σ_Y/E)");
    const double area = 4 * sigma_Y * (0.05 - e_Y);
    REQUIRE_THAT(heat, IsClose(area, Order(0.02 * area)));
}

TEST_CASE("plasticity: a twisted bar turns back by what its yield stress can turn it",
          "[A6.9][plasticity]")
{
    const Trajectory run = run_scene("a6-plasticity/twisted_bar", 0.02);
    const auto edge = [](int sign) {
        return [sign](const Vector3d& p) {
            return p.x() > 1.19 && p.y() > 0.14 && sign * p.z() > 0.14;
        };
    };
    const Vector3d d = mean_place(run, run.frames.back(), edge(1)) -
                       mean_place(run, run.frames.back(), edge(-1)); // along z at first
    const double back = -std::atan2(-d.y(), d.z()); // springback after a whole turn [rad]

    // The torque τ_Y a³/3 of a fully plastic square section, divided by its stiffness 0.140577 G
    // a⁴/l.
    constexpr double yield_stress = 3e5, G = E / 2.6, a = 0.3, l = 2.4;
    const double exact =
        yield_stress / std::sqrt(3) * a * a * a / 3 / (0.140577 * G * a * a * a * a) * l;
    INFO("a mesh of three cells across is stiffer than the bar");
    REQUIRE_THAT(degrees(back), IsClose(degrees(exact), Order(0.25 * degrees(exact))));
}

TEST_CASE("plasticity: a wire springs back as a whole or by what its yield stress can bend it",
          "[A6.9][plasticity]")
{
    const Trajectory run = run_scene("a6-plasticity/paper_clip");
    check_that(largest(solid(frame_at(run, 1)).plastic_strains) == 0,
               "no plastic strain in a wire that is bent by 5 degrees");

    const auto at = [&](double x) {
        return mean_place(run, run.frames.back(),
                          [x](const Vector3d& p) { return std::abs(p.x() - x) < 1e-3; });
    };
    const Vector3d end = at(3) - at(2);
    const double back = 150 - degrees(std::atan2(end.y(), end.x()));

    // The moment σ_Y b h²/4 of a fully plastic section, over the stiffness E b h³/12, for 1 m of
    // wire.
    const double exact = degrees(3 * 4e5 / (2e7 * 0.15));
    INFO("a mesh of two cells across is stiffer than the wire");
    REQUIRE_THAT(back, IsClose(exact, Order(0.3 * exact)));
}

TEST_CASE("plasticity: a ball falls as a point does until it touches the floor",
          "[A6.9][plasticity]")
{
    const Trajectory run = run_scene("a6-plasticity/dent", {}, R"({"end": 0.25})");
    for (const Frame& frame : run.frames) {
        CAPTURE(frame.time);
        const double t = frame.time, n = steps_of(frame);
        const double y = 1.6 - 3 * t - 9.81 / 2 * t * t;
        for (std::size_t ball : {0, 1})
            REQUIRE_THAT(solid(frame, ball).totals.center_of_mass.y(),
                         IsClose(y, Rounding(64 + 16 * n, 3)));
    }
}

TEST_CASE("plasticity: a metal ball keeps a dent and a rubber one bounces", "[A6.9][plasticity]")
{
    const Trajectory run = run_scene("a6-plasticity/dent", {}, R"({"end": 1.2})");
    double metal_top = 0, rubber_top = 0;
    for (const Frame& frame : run.frames) {
        CAPTURE(frame.time);
        const SolidFrame &metal = solid(frame, 0), &rubber = solid(frame, 1);
        check_that(largest(rubber.plastic_strains) == 0, "no plastic strain in rubber");
        INFO("no mass is lost");
        REQUIRE_THAT(metal.totals.mass, IsExactly(solid(run.frames.front(), 0).totals.mass));
        if (frame.time < 0.35) continue; // the balls fall or hit the floor
        metal_top = std::max(metal_top, metal.totals.center_of_mass.y());
        rubber_top = std::max(rubber_top, rubber.totals.center_of_mass.y());
    }
    check_at_most(metal_top, 0.4, "the height of the metal ball's center after its fall");
    check_at_least(rubber_top, 0.8, "the height that rubber reaches [m]");
    INFO("in flight rubber is round again");
    REQUIRE_THAT(extent(solid(frame_at(run, 0.65), 1), 1), IsClose(0.8, Order(1e-4)));
    INFO("the metal ball has lost a tenth of its height and has become wider");
    const SolidFrame& end = solid(run.frames.back());
    check_at_most(extent(end, 1), 0.9 * 0.8, "its height");
    check_at_most(1.02 * 0.8, extent(end, 0), "what its width must reach");
    check_that(largest(end.plastic_strains) > 0.1F, "a plastic strain above 0.1 in the metal");
}
