// SPDX-License-Identifier: MIT
// The figures of assignment A7, about fracture: smoothed stress, the plane of a crack in a
// tetrahedron, and what each of the three fracture methods makes of a mesh.
#include "figures/fracture_figures.hpp"

#include "formulas/fracture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

namespace rigor::figures {

namespace {

const View view(28, 22);

// Draws the edges of a tetrahedron, scaled by `size` about its middle and moved by `shift`.
void draw_tetrahedron(Drawing& drawing, const std::array<Vector3d, 4>& x, const Vector3d& shift,
                      const std::string& style, double size = 1)
{
    const Vector3d middle = (x[0] + x[1] + x[2] + x[3]) / 4;
    const auto at = [&](int i) { return view(middle + size * (x[i] - middle) + shift); };
    for (int i = 0; i < 4; ++i)
        for (int j = i + 1; j < 4; ++j)
            drawing.line(at(i), at(j), style);
}

std::array<Vector3d, 4> corners(const TetrahedralMesh& mesh, std::size_t t)
{
    std::array<Vector3d, 4> x;
    for (std::size_t i = 0; i < 4; ++i)
        x[i] = mesh.vertices[mesh.tetrahedra[t][i]];
    return x;
}

// The polygon in which the plane n·x = height cuts a tetrahedron: its corners, in order around
// their middle.
Points section(const std::array<Vector3d, 4>& x, const Vector3d& n, double height)
{
    std::vector<Vector3d> crossings;
    for (std::size_t i = 0; i < 4; ++i) {
        const double hi = n.dot(x[i]) - height;
        if (hi == 0) crossings.push_back(x[i]);
        for (std::size_t j = i + 1; j < 4; ++j) {
            const double hj = n.dot(x[j]) - height;
            if (hi * hj < 0) crossings.emplace_back(x[i] + hi / (hi - hj) * (x[j] - x[i]));
        }
    }
    Vector3d middle = Vector3d::Zero();
    for (const Vector3d& p : crossings)
        middle += p / static_cast<double>(crossings.size());
    const Vector3d t = n.unitOrthogonal(), b = n.cross(t);
    const auto angle = [&](const Vector3d& p) {
        return std::atan2(b.dot(p - middle), t.dot(p - middle));
    };
    std::sort(crossings.begin(), crossings.end(),
              [&](const Vector3d& p, const Vector3d& q) { return angle(p) < angle(q); });
    Points corners;
    for (const Vector3d& p : crossings)
        corners.push_back(view(p));
    return corners;
}

// A bar of cubes along x, six tetrahedra in each.
TetrahedralMesh bar(int cubes)
{
    TetrahedralMesh mesh;
    for (int i = 0; i <= cubes; ++i)
        for (int j = 0; j < 2; ++j)
            for (int k = 0; k < 2; ++k)
                mesh.vertices.emplace_back(i, j, k);
    const auto vertex = [](int i, int j, int k) { return 4 * i + 2 * j + k; };
    for (int c = 0; c < cubes; ++c) {
        // six tetrahedra along a diagonal of the cube, one for each order of the axes
        for (const auto& [a, b, third] :
             {std::array{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}) {
            std::array<int, 3> step = {0, 0, 0};
            std::array<int, 4> t{};
            t[0] = vertex(c, 0, 0);
            step[static_cast<std::size_t>(a)] = 1;
            t[1] = vertex(c + step[0], step[1], step[2]);
            step[static_cast<std::size_t>(b)] = 1;
            t[2] = vertex(c + step[0], step[1], step[2]);
            step[static_cast<std::size_t>(third)] = 1;
            t[3] = vertex(c + step[0], step[1], step[2]);
            const auto& x = mesh.vertices;
            const double det = (x[t[1]] - x[t[0]]).cross(x[t[2]] - x[t[0]]).dot(x[t[3]] - x[t[0]]);
            if (det < 0) std::swap(t[2], t[3]);
            mesh.tetrahedra.push_back(t);
        }
    }
    return mesh;
}

Drawing smoothing()
{
    Drawing drawing(
        "The stress of a row of elements jumps; an average with the neighbours has lower peaks.",
        660, 320);
    const double pulls[] = {3, 4.5, 2.5, 4, 5.5, 9, 6, 4, 2.5, 4.5};
    std::vector<Matrix3d> stresses;
    std::vector<std::vector<int>> neighbours;
    std::vector<double> volumes(std::size(pulls), 1);
    const int count = static_cast<int>(std::size(pulls));
    for (int i = 0; i < count; ++i) {
        stresses.push_back(pulls[i] * Vector3d::UnitX() * Vector3d::UnitX().transpose());
        neighbours.emplace_back();
        for (const int j : {i - 1, i + 1})
            if (j >= 0 && j < count) neighbours.back().push_back(j);
    }
    const std::vector<Matrix3d> smooth = smooth_stress(stresses, neighbours, volumes);
    drawing.place({70, 270}, 1);
    const auto bars = [&](const std::vector<Matrix3d>& all, const std::string& style) {
        Points points;
        for (int i = 0; i < count; ++i)
            for (const int end : {i, i + 1})
                points.emplace_back(54.0 * end, 25 * principal_stress(all[i]).stress);
        drawing.curve(points, style);
    };
    drawing.arrow({0, 0}, {570, 0}, "ink thin");
    drawing.arrow({0, 0}, {0, 250}, "ink thin");
    drawing.label({0, 250}, "σ₁", Side::left);
    drawing.label({285, 0}, "element", Side::below);
    drawing.line({0, 25 * 7.0}, {560, 25 * 7.0}, "red dashed");
    drawing.label({110, 25 * 7.0}, "strength", Side::above, "red");
    bars(stresses, "grey");
    bars(smooth, "blue thick");
    drawing.label({330, 235}, "as computed", Side::right, "grey");
    drawing.label({165, 130}, "smoothed", Side::above, "blue");
    return drawing;
}

Drawing crack_plane_figure()
{
    Drawing drawing("The plane of a crack in a tetrahedron, and the face that is nearest to it.",
                    660, 380);
    const std::array<Vector3d, 4> x = {Vector3d(0, 0, 0), Vector3d(1, 0, 0), Vector3d(0, 1, 0),
                                       Vector3d(0, 0, 1)};
    Matrix3d stress = Vector3d(2, 0.3, 0.2).asDiagonal();
    stress(0, 1) = stress(1, 0) = 0.5;
    const Vector3d n = crack_plane(stress, 1).value();
    const int face = closest_face(x, n);
    drawing.place({250, 285}, 215);
    Points nearest;
    for (int i = 1; i <= 3; ++i)
        nearest.push_back(view(x[static_cast<std::size_t>((face + i) % 4)]));
    drawing.polygon(nearest, "green filled");
    draw_tetrahedron(drawing, x, Vector3d::Zero(), "ink");
    constexpr std::array sides = {Side::left, Side::right, Side::above, Side::left};
    for (std::size_t i = 0; i < 4; ++i)
        drawing.label(view(x[i]), std::to_string(i), sides[i]);
    const Vector3d middle = (x[0] + x[1] + x[2] + x[3]) / 4;
    drawing.polygon(section(x, n, n.dot(middle)), "orange filled");
    drawing.arrow(view(middle), view(middle + 0.45 * n), "orange thick");
    drawing.label(view(middle + 0.45 * n), "n", Side::right, "orange");
    drawing.place({0, 0}, 1);
    drawing.label({430, -80}, "plane of the crack", Side::right, "orange");
    drawing.label({430, -110}, "closest_face: " + std::to_string(face), Side::right, "green");
    drawing.label({430, -134}, fmt::format("(opposite corner {})", face), Side::right, "green");
    return drawing;
}

// Whether the middle of a tetrahedron lies to the right of the plane x = cut.
bool is_right(const std::array<Vector3d, 4>& x, double cut)
{
    return (x[0] + x[1] + x[2] + x[3]).x() / 4 > cut;
}

Drawing along_faces()
{
    Drawing drawing(
        "A bar before and after it is split along the faces between two cubes: no element "
        "has changed, and four vertices have become eight.",
        660, 360);
    const TetrahedralMesh mesh = bar(2);
    std::vector<MeshFace> faces;
    for (int t = 0; t < static_cast<int>(mesh.tetrahedra.size()); ++t)
        for (int f = 0; f < 4; ++f) {
            bool lies = true;
            for (int i = 1; i <= 3; ++i)
                lies &= mesh.vertices[mesh.tetrahedra[t][(f + i) % 4]].x() == 1;
            if (lies) faces.push_back({t, f});
        }
    const SplitMesh split = split_along_faces(mesh, faces);
    const auto draw = [&](const TetrahedralMesh& of, double apart) {
        for (std::size_t t = 0; t < of.tetrahedra.size(); ++t) {
            const bool right = is_right(corners(of, t), 1);
            draw_tetrahedron(drawing, corners(of, t), Vector3d(right ? apart : 0, 0, 0),
                             right ? "orange" : "blue");
        }
        drawing.label({1, -1.05}, std::to_string(of.vertices.size()) + " vertices", Side::below,
                      "grey");
    };
    drawing.place({75, 205}, 110);
    draw(mesh, 0);
    drawing.place({380, 205}, 110);
    draw(split.mesh, 0.3);
    return drawing;
}

Drawing through_elements()
{
    Drawing drawing(
        "A tetrahedron before and after it is cut by a plane through one of its vertices: "
        "each edge that crosses the plane is split there.",
        660, 360);
    TetrahedralMesh mesh;
    mesh.vertices = {Vector3d(0, 0, 0), Vector3d(1, 0, 0.2), Vector3d(0.2, 1, 0.1),
                     Vector3d(0.1, 0.15, 1)};
    mesh.tetrahedra = {{0, 1, 2, 3}};
    const Vector3d n = Vector3d(0.9, -0.5, -0.45).normalized();
    const SplitMesh split = split_element(mesh, 0, n);
    drawing.place({110, 270}, 200);
    draw_tetrahedron(drawing, corners(mesh, 0), Vector3d::Zero(), "ink");
    drawing.polygon(section(corners(mesh, 0), n, 0), "red filled");
    drawing.dot(view(mesh.vertices[0]), "red");
    drawing.place({390, 270}, 200);
    for (std::size_t t = 0; t < split.mesh.tetrahedra.size(); ++t) {
        const auto x = corners(split.mesh, t);
        const double height = n.dot((x[0] + x[1] + x[2] + x[3]) / 4);
        draw_tetrahedron(drawing, x, (height > 0 ? 0.14 : -0.14) * n,
                         height > 0 ? "orange" : "blue");
    }
    drawing.place({0, 0}, 1);
    drawing.label({25, -60}, "plane of the crack", Side::right, "red");
    drawing.label({520, -60}, std::to_string(split.mesh.tetrahedra.size()) + " tetrahedra",
                  Side::middle, "grey");
    return drawing;
}

Drawing with_virtual_nodes()
{
    Drawing drawing(
        "A tetrahedron with a crack inside it, and its two copies: each has the full size "
        "and carries the matter on one side.",
        660, 360);
    TetrahedralMesh mesh;
    mesh.vertices = {Vector3d(0, 0, 0), Vector3d(1, 0, 0.2), Vector3d(0.2, 1, 0.1),
                     Vector3d(0.1, 0.15, 1)};
    mesh.tetrahedra = {{0, 1, 2, 3}};
    const Vector3d n = Vector3d(0.2, 1, 0.1).normalized();
    const Vector3d on_crack(0, 0.4, 0);
    const EmbeddedMesh split = virtual_nodes(mesh, {{0, on_crack, n}});
    drawing.place({0, 0}, 1);
    drawing.dot({30, -40}, "ink");
    drawing.label({32, -40}, "real corner", Side::right);
    drawing.circle({30, -65}, 4.65, "ink");
    drawing.label({32, -65}, "virtual corner", Side::right);
    const Vector2d places[] = {{300, 265}, {525, 225}};
    drawing.place({65, 265}, 155);
    draw_tetrahedron(drawing, corners(mesh, 0), Vector3d::Zero(), "ink");
    drawing.polygon(section(corners(mesh, 0), n, n.dot(on_crack)), "red filled");
    drawing.label({0.1, -0.35}, "crack", Side::below, "red");
    for (std::size_t t = 0; t < split.mesh.tetrahedra.size(); ++t) {
        const std::string color = t == 0 ? "blue" : "orange";
        drawing.place(places[t], 155);
        const auto x = corners(split.mesh, t);
        draw_tetrahedron(drawing, x, Vector3d::Zero(), color + " dashed thin");
        for (std::size_t i = 0; i < 4; ++i) {
            if (split.real[t][i] == 1)
                drawing.dot(view(x[i]), color);
            else
                drawing.circle(view(x[i]), 0.03, color);
            // the material reaches along an edge from a real corner to the crack, or to the other
            // end
            for (std::size_t j = 0; j < 4; ++j) {
                if (i == j || split.real[t][i] == 0) continue;
                const double hi = n.dot(x[i] - on_crack), hj = n.dot(x[j] - on_crack);
                const double share = hi * hj < 0 ? hi / (hi - hj) : 1;
                drawing.line(view(x[i]), view(x[i] + share * (x[j] - x[i])), color + " thick");
            }
        }
        std::string text = fmt::format("{:.0f} % of the volume", 100 * split.fractions[t]);
        drawing.label({0.1, -0.35}, text, Side::below, color);
    }
    return drawing;
}

} // namespace

std::span<const Figure> fracture_figures()
{
    static constexpr Figure all[] = {{"a7-fracture", "smoothing", smoothing},
                                     {"a7-fracture", "crack_plane", crack_plane_figure},
                                     {"a7-fracture", "along_faces", along_faces},
                                     {"a7-fracture", "through_elements", through_elements},
                                     {"a7-fracture", "virtual_nodes", with_virtual_nodes}};
    return all;
}

} // namespace rigor::figures
