// SPDX-License-Identifier: MIT
#include "formulas/table.hpp"
#include "framework/worker/attack.hpp"
#include "framework/worker/echo/echo.hpp"
#include "support/catch.hpp"
#include "worker/protocol/finite.hpp"
#include "worker/proxy/answer_sizes.hpp"
#include "worker/proxy/proxy.hpp"

#include <stdexcept>
#include <tuple>

namespace rigor {

namespace {

template <class Result, class... Argument>
void check_round_trip(FormulaIndex formula, Result (*function)(Argument...), SplitMix& random)
{
    std::tuple<std::remove_cvref_t<Argument>...> arguments;
    std::apply([&](auto&... argument) { (fill(argument, random), ...); }, arguments);
    wire::Bytes sent, received, expected;
    std::apply([&](const auto&... argument) { (wire::encode(sent, argument), ...); }, arguments);

    try {
        wire::encode(received, std::apply(function, arguments));
    } catch (const std::out_of_range&) {
        // The proxy refuses lists that do not fit the arguments; here they only have to arrive.
        received = worker().call(formula, sent, wire::encoded_size<Result>().most);
    }
    wire::encode(expected, echo_of<Result>(static_cast<unsigned>(formula), sent));
    INFO(subject_of(formula));
    REQUIRE(received == expected);
}

} // namespace

TEST_CASE("worker: every bit of the arguments and of the result of every formula arrives")
{
    use_worker(RIGOR_BINARY_DIR "/bin/worker_echo");
    SplitMix random{1};
    for (int repeat = 0; repeat < 20; ++repeat) {
#define RIGOR_ROW(tag, topic, f, ...) check_round_trip(FormulaIndex::f, &f, random);
        RIGOR_FORMULAS(RIGOR_ROW)
#undef RIGOR_ROW
    }
}

TEST_CASE("worker: a request holds megabytes and refuses more than it can hold")
{
    use_worker(RIGOR_BINARY_DIR "/bin/worker_echo");
    LevelSet grid;
    grid.size = {128, 128, 128};
    grid.distances.assign(std::size_t{128} * 128 * 128, 0.5);
    wire::Bytes sent;
    wire::encode(sent, grid);
    wire::encode(sent, Vector3d(1, 2, 3));
    const auto index = static_cast<unsigned>(FormulaIndex::sample_level_set);
    REQUIRE(sample_level_set(grid, Vector3d(1, 2, 3)) == echo_of<double>(index, sent));

    grid.distances.resize(Channel::capacity / sizeof(double));
    REQUIRE_THROWS_AS(sample_level_set(grid, Vector3d(1, 2, 3)), std::length_error);
}

TEST_CASE("worker: the longest step of a rotation may be infinite and nothing else may")
{
    REQUIRE(find_non_finite(1.0).empty());
    use_worker(RIGOR_BINARY_DIR "/bin/worker_reference");
    REQUIRE(max_time_step(Vector3d::Zero()) == std::numeric_limits<double>::infinity());
    const double huge = std::numeric_limits<double>::max();
    REQUIRE_THROWS_AS(solid_sphere(huge, huge), NotFinite);
}

TEST_CASE("worker: by_reference asks the oracle and only for the time being")
{
    use_worker(RIGOR_BINARY_DIR "/bin/worker_echo", RIGOR_BINARY_DIR "/bin/worker_reference");
    const auto reference = [] { return kinetic_energy(2, {1, 0, 0}, Matrix3d::Zero(), {0, 0, 0}); };
    REQUIRE(by_reference(reference) == 1.0);
    REQUIRE(reference() != 1.0);
}

TEST_CASE("worker: what keeps the test busy is no failure of the reference")
{
    use_worker(RIGOR_BINARY_DIR "/bin/worker_echo", RIGOR_BINARY_DIR "/bin/worker_reference");
    const auto is_late = [](WorkerFailure::Cause cause) {
        try {
            return by_reference([&]() -> bool { throw WorkerFailure(cause, "f", "failed"); });
        } catch (const OracleFailure& failure) {
            return failure.is_late;
        }
    };
    CHECK(is_late(WorkerFailure::timed_out));
    CHECK_FALSE(is_late(WorkerFailure::crashed));
    REQUIRE_THROWS_AS(by_reference([]() -> bool { throw OwnTimeOver("the test", "is long"); }),
                      OwnTimeOver);
}

TEST_CASE("worker: the reference is not to blame for arguments that answers led to")
{
    use_worker(RIGOR_BINARY_DIR "/bin/worker_echo", RIGOR_BINARY_DIR "/bin/worker_reference");
    const auto energy = [](double speed) {
        return by_reference([&] {
            return kinetic_energy(1, {speed, 0, 0}, Matrix3d::Zero(), {0, 0, 0});
        });
    };
    REQUIRE(energy(1e100) == 5e199); // a large number is no failure
    REQUIRE_THROWS_AS(energy(1e198), BeyondReference);
    REQUIRE_THROWS_WITH(energy(1e198),
                        "A0.1 kinetic_energy: the answers so far lead to an argument without an "
                        "answer: its component x is 1e+198, beyond 1e+30");
    REQUIRE(energy(2) == 2);
}

TEST_CASE("worker: levels that no stack has stay in the proxy")
{
    const std::vector<int> possible[] = {{}, {0}, {1}, {0, 1, 2}, {3, 3, 3}};
    for (const std::vector<int>& levels : possible)
        REQUIRE_NOTHROW(require_levels(levels));
    REQUIRE_THROWS_WITH(require_levels({0, -1}),
                        "contact_levels returned the level -1 for body 1 where 0 to 2, the number "
                        "of bodies, was expected");
    const std::vector<int> wild[] = {{2}, {1 << 30, 0}, {0, -2147483647 - 1}, {4, 0, 0}};
    for (const std::vector<int>& levels : wild)
        REQUIRE_THROWS_AS(require_levels(levels), std::out_of_range);
}

TEST_CASE("worker: a longest step below 0 stays in the proxy")
{
    const Vector3d omega(0, 1, 0);
    using F = FormulaIndex;
    REQUIRE_NOTHROW(check_sizes<F::max_time_step>(1.5, omega));
    REQUIRE_THROWS_WITH(check_sizes<F::max_time_step>(-1.0, omega),
                        "max_time_step returned -1 where a time above 0 was expected");
}

TEST_CASE("worker: lists that do not fit the arguments stay in the proxy")
{
    use_worker(attack("wrong_lists"), {}, tight());
    const std::vector<Body> bodies(2);
    const std::vector<BodyContact> contacts(1);
    const TetrahedralMesh mesh = {std::vector<Vector3d>(4, Vector3d::Zero()), {{0, 1, 2, 3}}};
    REQUIRE_THROWS_WITH(resolve_contacts(bodies, contacts, 1),
                        "resolve_contacts returned 0 bodies where 2 were expected");
    REQUIRE_THROWS_AS(shock_propagation(bodies, contacts, {0, 1}, 1), std::out_of_range);
    REQUIRE_THROWS_AS(resolve_simultaneously(bodies, contacts, 1), std::out_of_range);
    REQUIRE_THROWS_AS(contact_levels({{}, {0}}, {true, false}), std::out_of_range);
    REQUIRE_THROWS_AS(deepest_approaching_point({{}}), std::out_of_range);
    REQUIRE_THROWS_AS(smooth_stress({Matrix3d::Zero()}, {{}}, {1}), std::out_of_range);
    REQUIRE_THROWS_AS(closest_face({}, Vector3d(0, 1, 0)), std::out_of_range);
    REQUIRE_THROWS_AS(split_along_faces(mesh, {}), std::out_of_range);
    REQUIRE_THROWS_AS(split_element(mesh, 0, Vector3d(0, 1, 0)), std::out_of_range);
    REQUIRE_THROWS_AS(virtual_nodes(mesh, {}), std::out_of_range);
    REQUIRE(next_call_is_answered());
}

} // namespace rigor
