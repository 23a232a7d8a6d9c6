// SPDX-License-Identifier: MIT
// Makes the copies of a body in a grid: first along x, then along z, then along y. Each copy is
// shifted and rotated by random amounts, which the seed determines.
#include "scene/keys/grid_keys.hpp"

#include "scene/keys/limits.hpp"
#include "scene/language/values.hpp"

#include <fmt/format.h>

#include <numbers>

namespace rigor {

namespace {

// Random numbers with the same bits on every platform, by SplitMix64 (Steele, Lea and Flood 2014,
// "Fast splittable pseudorandom number generators").
class Jitter {
public:
    explicit Jitter(std::int64_t seed) : state_(static_cast<std::uint64_t>(seed)) {}

    double symmetric() // -1 … 1
    {
        state_ += 0x9E3779B97F4A7C15u;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
        z ^= z >> 31;
        return static_cast<double>(z >> 11) * 0x1p-52 - 1;
    }

    Vector3d vector()
    {
        const double x = symmetric(), y = symmetric(), z = symmetric();
        return {x, y, z};
    }

private:
    std::uint64_t state_;
};

struct Grid {
    std::array<int, 3> count = {1, 1, 1};
    Vector3d spacing = Vector3d::Zero();
    double jitter = 0, jitter_degrees = 0;
    std::int64_t seed = 1;
    std::vector<Vector3d> colors;
    const Value *count_value = nullptr, *spacing_value = nullptr;
};

constexpr Key<Grid> grid_keys[] = {
    {"count", "needed: how many along x, y, z, each from 1; x runs first, then z, then y",
     [](Grid& g, const Value& v) {
         g.count_value = &v;
         if (array(v, "three counts").size() != 3) expected("three counts", v);
         for (std::size_t i = 0; i < 3; ++i)
             g.count[i] = static_cast<int>(integer(v.items[i], "a count", 1, most_bodies));
     }},
    {"spacing",
     "needed: from one to the next along x, y, z; the first is at the body's position [m]",
     [](Grid& g, const Value& v) {
         g.spacing_value = &v;
         g.spacing = vector3(v);
     }},
    {"jitter", "random shift of each, up to this along each axis, default 0 [m]",
     [](Grid& g, const Value& v) { g.jitter = not_negative(v, "a jitter"); }},
    {"jitter_degrees", "random turn of each, up to about this, from 0 to 180, default 0 [degrees]",
     [](Grid& g, const Value& v) { g.jitter_degrees = in_range(v, "a turn", 0, 180); }},
    {"seed", "of the random numbers, default 1: the same seed gives the same scene",
     [](Grid& g, const Value& v) { g.seed = integer(v, "a seed", 0, 1'000'000'000); }},
    {"colors", "a list of colors that the bodies take in turn",
     [](Grid& g, const Value& v) {
         for (const Value& item : array(v, "a list of colors"))
             g.colors.push_back(color(item));
         if (g.colors.empty()) expected("at least one color", v);
     }},
};

Quaternion turned(const Quaternion& q, const Vector3d& rotation)
{
    const double angle = rotation.norm();
    if (angle == 0) return q;
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(angle, rotation / angle));
    const Eigen::Quaterniond p =
        (turn * Eigen::Quaterniond(q.s, q.v.x(), q.v.y(), q.v.z())).normalized();
    return {p.w(), p.vec()};
}

} // namespace

void read_grid(const Value& value, const BodyDescription& body,
               std::vector<BodyDescription>& bodies)
{
    Grid grid;
    read_object<Grid>(value, "a grid {\"count\": …, \"spacing\": …}", grid_keys, grid);
    if (!grid.count_value) expected("a \"count\" in the grid", value);
    if (!grid.spacing_value) expected("a \"spacing\" in the grid", value);
    const double total = 1.0 * grid.count[0] * grid.count[1] * grid.count[2];
    if (total > most_bodies)
        throw Mistake{grid.count_value->line,
                      fmt::format("expected at most {} bodies, found {}", most_bodies, total)};
    if (total * static_cast<double>(body.parts.size()) > most_shapes)
        throw Mistake{grid.count_value->line,
                      fmt::format("expected at most {} shapes, found {}", most_shapes,
                                  total * static_cast<double>(body.parts.size()))};
    Jitter random(grid.seed);
    std::size_t number = 0;
    for (int y = 0; y < grid.count[1]; ++y)
        for (int z = 0; z < grid.count[2]; ++z)
            for (int x = 0; x < grid.count[0]; ++x) {
                BodyDescription copy = body;
                copy.position +=
                    Vector3d(x, y, z).cwiseProduct(grid.spacing) + grid.jitter * random.vector();
                copy.orientation = turned(body.orientation, grid.jitter_degrees * std::numbers::pi /
                                                                180 * random.vector());
                if (!grid.colors.empty()) copy.color = grid.colors[number % grid.colors.size()];
                copy.name = fmt::format("{} {}", body.name, ++number);
                bodies.push_back(std::move(copy));
            }
}

void grid_meanings(std::vector<KeyMeaning>& meanings)
{
    add_meanings<Grid>("grid", grid_keys, meanings);
}

} // namespace rigor
