// SPDX-License-Identifier: MIT
// The meshes of deformable solids, with one reader for each kind.
#include "scene/keys/tetrahedra_keys.hpp"
#include "geometry/tetrahedra/tetrahedra_generators.hpp"
#include "scene/keys/kind.hpp"
#include "scene/keys/limits.hpp"
#include "scene/language/values.hpp"

namespace rigor {

namespace {

using SharedTetrahedra = std::shared_ptr<const TetrahedralMesh>;

// The values of the keys of a mesh that consists of equal boxes, the `cells`. Only a notched plate
// uses `notch`.
struct BlockDraft {
    Vector3d size = Vector3d::Zero();
    std::array<int, 3> cells = {1, 1, 1};
    std::array<int, 2> notch = {1, 1};
};

template <std::size_t n>
std::array<int, n> whole_numbers(const Value& value, std::string_view what, int most)
{
    if (array(value, what).size() != n) expected(what, value);
    std::array<int, n> numbers{};
    for (std::size_t i = 0; i < n; ++i)
        numbers[i] = static_cast<int>(integer(value.items[i], "a number of cells", 1, most));
    return numbers;
}

constexpr int most_cells = 1000; // along each axis; the limit bounds run time and memory

constexpr Key<BlockDraft> size_key = {
    "size", "full extent along x, y, z, each > 0 [m]",
    [](BlockDraft& b, const Value& v) { b.size = positive3(v, "an extent"); }};
constexpr Key<BlockDraft> block_cells_key = {
    "cells", "of five tetrahedra each, along x, y, z", [](BlockDraft& b, const Value& v) {
        b.cells = whole_numbers<3>(v, "three numbers of cells", most_cells);
    }};

constexpr Key<BlockDraft> block_keys[] = {size_key, block_cells_key};

constexpr Key<BlockDraft> notched_keys[] = {
    size_key,
    block_cells_key,
    {"notch", "how many cells are missing: along x, and from the top down along y",
     [](BlockDraft& b, const Value& v) {
         b.notch = whole_numbers<2>(v, "two numbers of cells", most_cells);
     }},
};

struct BallDraft {
    double radius = 0;
    int layers = 0;
};

constexpr Key<BallDraft> ball_keys[] = {
    {"radius", "> 0 [m]", [](BallDraft& b, const Value& v) { b.radius = positive(v, "a radius"); }},
    {"layers", "from the middle out, from 1 to 29: n make 8 n³ tetrahedra",
     [](BallDraft& b, const Value& v) {
         b.layers = static_cast<int>(integer(v, "a number of layers", 1, 29));
     }},
};

SharedTetrahedra shared(TetrahedralMesh mesh)
{
    return std::make_shared<TetrahedralMesh>(std::move(mesh));
}

void check_cells(const BlockDraft& block, const Value& value)
{
    const double tetrahedra =
        5.0 * block.cells[0] * block.cells[1] * static_cast<double>(block.cells[2]);
    if (tetrahedra > static_cast<double>(most_scene_tetrahedra))
        throw Mistake{find(value, "cells")->line,
                      fmt::format("expected cells of at most {} tetrahedra, found {}",
                                  most_scene_tetrahedra, tetrahedra)};
}

SharedTetrahedra read_block(const Value& value)
{
    const BlockDraft block = read_kind<BlockDraft>(value, block_keys, {"size", "cells"});
    check_cells(block, value);
    return shared(block_tetrahedra(block.size, block.cells));
}

SharedTetrahedra read_notched(const Value& value)
{
    const BlockDraft block = read_kind<BlockDraft>(value, notched_keys, {"size", "cells", "notch"});
    check_cells(block, value);
    for (int i = 0; i < 2; ++i)
        if (block.notch[i] >= block.cells[i])
            throw Mistake{find(value, "notch")->line,
                          fmt::format("expected a notch of fewer cells than {} along {}, found {}",
                                      block.cells[i], "xy"[i], block.notch[i])};
    return shared(notched_tetrahedra(block.size, block.cells, block.notch));
}

SharedTetrahedra read_ball(const Value& value)
{
    const BallDraft ball = read_kind<BallDraft>(value, ball_keys, {"radius", "layers"});
    return shared(ball_tetrahedra(ball.radius, ball.layers));
}

struct TetrahedraDraft {
    SharedTetrahedra mesh;
    const Value *file = nullptr, *scale = nullptr;
};

constexpr Key<TetrahedraDraft> tetrahedra_keys[] = {
    {"bar", "a long block about the origin: {\"size\": [4, 1, 1], \"cells\": [8, 2, 2]}",
     [](TetrahedraDraft& t, const Value& v) { t.mesh = read_block(v); }},
    {"plate", "a flat block about the origin",
     [](TetrahedraDraft& t, const Value& v) { t.mesh = read_block(v); }},
    {"notched_plate", "a block with a notch in the middle of its upper side, all along z",
     [](TetrahedraDraft& t, const Value& v) { t.mesh = read_notched(v); }},
    {"ball", "a ball about the origin: {\"radius\": 0.5, \"layers\": 4}",
     [](TetrahedraDraft& t, const Value& v) { t.mesh = read_ball(v); }},
    {"file", "a file of tetrahedra, its path from the scene's",
     [](TetrahedraDraft& t, const Value& v) {
         line_of_text(v, "the name of a mesh file");
         t.file = &v;
     }},
    {"scale",
     "with `file`: > 0, or three of them for x, y, z, default 1: what the coordinates are "
     "multiplied by",
     [](TetrahedraDraft& t, const Value& v) { t.scale = &v; }},
};

} // namespace

SharedTetrahedra read_solid_mesh(const Value& value, MeshLibrary& meshes)
{
    constexpr std::string_view what = "a mesh {\"bar\": …}, {\"ball\": …} or {\"file\": \"x.msh\"}";
    TetrahedraDraft draft;
    read_object<TetrahedraDraft>(value, what, tetrahedra_keys, draft);
    if (draft.scale && !draft.file) expected("\"file\" beside \"scale\"", value);
    if (value.items.size() != (draft.scale ? 2U : 1U)) expected(what, value);
    if (draft.mesh) return draft.mesh;
    return meshes.tetrahedra(*draft.file,
                             draft.scale ? scale3(*draft.scale, "a scale") : Vector3d(1, 1, 1));
}

void tetrahedra_meanings(std::vector<KeyMeaning>& meanings)
{
    add_meanings<TetrahedraDraft>("tetrahedra", tetrahedra_keys, meanings);
    add_meanings<BlockDraft>("bar and plate", block_keys, meanings);
    add_meanings<BlockDraft>("notched_plate", notched_keys, meanings);
    add_meanings<BallDraft>("ball", ball_keys, meanings);
}

} // namespace rigor
