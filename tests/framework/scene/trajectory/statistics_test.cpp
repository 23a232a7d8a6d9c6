// SPDX-License-Identifier: MIT
#include "scene/keys/scene_keys.hpp"
#include "scene/trajectory/statistics.hpp"
#include "support/close.hpp"
#include "support/random.hpp"

using namespace rigor;
using namespace rigor::testing;

namespace {

Scene spring_scene()
{
    return parse_scene(R"({"gravity": [0, -10, 0], "bodies": [
        {"name": "bob", "shape": {"sphere": {"radius": 1}}},
        {"name": "floor", "shape": {"plane": {}}, "static": true}],
        "springs": [{"body1": "bob", "point1": [1, 2, 4], "point2": [3, 0, 0], "stiffness": 8,
                     "rest_length": 1}]})",
                       "spring");
}

} // namespace

TEST_CASE("statistics: energy and momentum by hand")
{
    const Scene scene = spring_scene();
    // The spring is attached at (1, 2, 4) of the frame, which is (0, 0, 1) of object space.
    const std::vector<RecordedBody> bodies = {
        {false, 2, Vector3d(1, 2, 3), Vector3d(1, 2, 4).asDiagonal()}, {true}};
    const Statistics statistics(scene, bodies);
    Frame frame;
    frame.time = 0.5;
    // A quarter turn about z: object x is world y, object y is world -x.
    const double c = std::sqrt(0.5);
    frame.bodies = {{Vector3d(0, 3, 0), {c, {0, 0, c}}, Vector3d(1, 0, 2), Vector3d(2, 3, 4)}, {}};
    frame.contacts = {{0, 1, {}, {}, 0.01, {}}, {0, 1, {}, {}, 0.03, {}}, {0, 1, {}, {}, 0.02, {}}};

    // I(t) = diag(2, 1, 4), ω = (1, 3, 1)
    CHECK_THAT(statistics.angular_velocity(0, frame.bodies[0]),
               IsClose(Vector3d(1, 3, 1), Rounding(16)));
    CHECK(statistics.angular_velocity(1, frame.bodies[1]).isZero(0));
    const FrameStatistics sums = statistics.of(frame);
    CHECK(sums.time == 0.5);
    // ½ 2 (1 + 4) + ½ (2 + 9 + 4)
    CHECK_THAT(sums.kinetic_energy, IsClose(12.5, Rounding(16)));
    // M g h = 60; the spring from (0, 3, 1) to (3, 0, 0) is √19 long
    const double stretch = std::sqrt(19.0) - 1;
    CHECK_THAT(sums.potential_energy, IsClose(60 + 4 * stretch * stretch, Rounding(16)));
    CHECK(sums.total_energy() == sums.kinetic_energy + sums.potential_energy);
    CHECK_THAT(sums.momentum, IsExactly(Vector3d(2, 0, 4)));
    // X × M V + L = (0, 3, 0) × (2, 0, 4) + (2, 3, 4)
    CHECK_THAT(sums.angular_momentum, IsExactly(Vector3d(14, 3, -2)));
    CHECK(sums.deepest_penetration == 0.03);
}

TEST_CASE("statistics: a slack rope has no energy, a taut one that of a spring")
{
    for (const bool only_pulls : {false, true})
        for (const double rest_length : {1., 10.}) {
            CAPTURE(only_pulls, rest_length);
            Scene scene = spring_scene();
            scene.springs[0].only_pulls = only_pulls;
            scene.springs[0].rest_length = rest_length;
            const Statistics statistics(
                scene, {{false, 2, Vector3d(1, 2, 3), Matrix3d::Identity()}, {true}});
            Frame frame;
            frame.bodies = {{Vector3d(0, 0, 0), {}, Vector3d(0, 0, 0), Vector3d(0, 0, 0)}, {}};
            const double stretch = std::sqrt(10.0) - rest_length; // from (0, 0, 1) to (3, 0, 0)
            const bool is_slack = only_pulls && stretch < 0;
            CHECK_THAT(statistics.of(frame).potential_energy,
                       IsClose(is_slack ? 0 : 4 * stretch * stretch, Rounding(16)));
        }
}

TEST_CASE("statistics: matter without a moment about an axis has no energy from it")
{
    const Scene scene = spring_scene();
    Frame frame;
    frame.bodies = {{Vector3d::Zero(), {}, Vector3d::Zero(), Vector3d(1, 5, 0)}, {}};
    const auto energy_and_spin = [&](const Matrix3d& inertia) {
        const Statistics statistics(scene, {{false, 1, Vector3d::Zero(), inertia}, {true}});
        return std::pair(statistics.of(frame).kinetic_energy,
                         statistics.angular_velocity(0, frame.bodies[0]));
    };
    const auto [rod_energy, rod_spin] = energy_and_spin(Vector3d(2, 0, 2).asDiagonal());
    CHECK_THAT(rod_energy, IsClose(0.25, Rounding(16)));
    CHECK_THAT(rod_spin, IsClose(Vector3d(0.5, 0, 0), Rounding(16, 1)));
    const auto [point_energy, point_spin] = energy_and_spin(Matrix3d::Zero());
    CHECK(point_energy == 0);
    CHECK(point_spin.isZero(0));
}

TEST_CASE("statistics: angular velocity inverts the inertia of any body")
{
    const Scene scene = spring_scene();
    for (unsigned seed = 0; seed < 100; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const Matrix3d I = random.inertia();
        const Eigen::Quaterniond q = random.eigen_quaternion();
        const Matrix3d R = q.toRotationMatrix();
        const Vector3d w = random.vector();
        const Vector3d L = R * I * R.transpose() * w;
        const Statistics statistics(scene, {{false, 1, Vector3d::Zero(), I}, {true}});
        const double condition = I.norm() * I.inverse().norm();
        REQUIRE_THAT(statistics.angular_velocity(
                         0, {Vector3d::Zero(), {q.w(), q.vec()}, Vector3d::Zero(), L}),
                     IsClose(w, Rounding(64 * condition, 1)));
    }
}
