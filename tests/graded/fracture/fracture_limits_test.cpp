// SPDX-License-Identifier: MIT
// A7: flat and tiny tetrahedra, tetrahedra that lie on the plane of a crack, stresses that hardly
// pull, parts without matter.
#include "fracture_laws.hpp"
#include "support/seeds.hpp"
#include "virtual_nodes_laws.hpp"

namespace rigor::testing {

namespace {

// A flat tetrahedron on the plane z = 0 whose vertex 3 is 0.02 above it. Below its face 0 1 2 is a
// tetrahedron down to vertex 4. With `above` there are three more on its upper faces, up to vertex
// 5.
TetrahedralMesh flat_tetrahedron(bool above)
{
    TetrahedralMesh mesh = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.4, 0.4, 0.02}, {0.3, 0.3, -1}},
                            {{0, 1, 2, 3}, {0, 2, 1, 4}}};
    if (above) {
        mesh.vertices.push_back({0.3, 0.3, 1});
        for (const auto& [a, b] : {std::pair(0, 1), std::pair(1, 2), std::pair(2, 0)})
            mesh.tetrahedra.push_back({a, b, 3, 5});
    }
    return mesh;
}

} // namespace

TEST_CASE("fracture: a tetrahedron that lies on the plane is on the side of its center",
          "[A7.6][fracture]")
{
    const TetrahedralMesh mesh = flat_tetrahedron(true);
    for (const double sign : {1.0, -1.0}) {
        CAPTURE(sign);
        const SplitMesh result = split_element(mesh, 0, sign * Vector3d::UnitZ());
        check_split(mesh, result);
        INFO("the flat tetrahedron stays with those above it, and the lower one comes off");
        check_count(tetrahedron_count(result.mesh), tetrahedron_count(mesh), "tetrahedra");
        check_count(vertex_count(result.mesh), vertex_count(mesh) + 3, "vertices");
        const double lower = volume(mesh, 1);
        check_piece_volumes(result.mesh, std::vector{lower, volume(mesh) - lower}, Rounding(64, 1));
    }
}

TEST_CASE("fracture: where no vertex is above the plane nothing splits", "[A7.6][fracture]")
{
    const TetrahedralMesh mesh = flat_tetrahedron(false);
    for (const double sign : {1.0, -1.0}) { // turned round, no vertex is below
        CAPTURE(sign);
        const SplitMesh result = split_element(mesh, 0, sign * Vector3d::UnitZ());
        check_split(mesh, result);
        check_count(vertex_count(result.mesh), vertex_count(mesh), "vertices");
        check_count(tetrahedron_count(result.mesh), tetrahedron_count(mesh), "tetrahedra");
    }
}

TEST_CASE("fracture: the nearest face of flat and of tiny tetrahedra", "[A7.4][fracture]")
{
    for (Random random : seeds(50)) {
        const Matrix3d R = random.rotation();
        for (const double size : {1e-6, 1.0, 1e6})
            for (const double height : {1e-3, 1e-6, 1e-9}) {
                CAPTURE(size, height);
                // faces 1, 2 and 3 are perpendicular to x, y and z; face 0 is nearly parallel to x
                const std::array<Vector3d, 4> flat = {
                    size * R * Vector3d(0, 0, 0), size * R * Vector3d(1, 0, 0),
                    size * R * Vector3d(0, height, 0), size * R * Vector3d(0, 0, height)};
                REQUIRE_THAT(closest_face(flat, R * Vector3d(1, 0.1, 0).normalized()),
                             IsExactly(1));
                REQUIRE_THAT(closest_face(flat, R * Vector3d(0.1, 1, 0).normalized()),
                             IsExactly(2));
                REQUIRE_THAT(closest_face(flat, R * Vector3d(0.1, 0, -1).normalized()),
                             IsExactly(3));
            }
    }
}

TEST_CASE("fracture: a face as thin as a hair has a normal", "[A7.4][fracture]")
{
    for (int power = 0; power <= 46; power += 2)
        for (int apex = 0; apex < 4; ++apex) { // the face opposite to it is thin, with the normal z
            CAPTURE(power, apex);
            std::array<Vector3d, 4> x;
            x[apex] = {0.5, 0, -1};
            x[(apex + 1) % 4] = {0, 0, 0};
            x[(apex + 2) % 4] = {1, 0, 0};
            x[(apex + 3) % 4] = {0.5, std::ldexp(1, -power), 0};
            REQUIRE_THAT(closest_face(x, {0, 0, 1}), IsExactly(apex));
        }
}

TEST_CASE("fracture: the foot of a needle is a face like any other", "[A7.4][fracture]")
{
    // The normal of the foot is z. Of the long faces, two have the normals x and y.
    for (Random random : seeds(10)) {
        const Matrix3d R = random.rotation();
        for (const double width : {1e-3, 1e-5, 1e-7, 1e-9})
            for (int tip = 0; tip < 4; ++tip) {
                CAPTURE(width, tip);
                std::array<Vector3d, 4> needle;
                const int a = (tip + 1) % 4, b = (tip + 2) % 4, c = (tip + 3) % 4;
                needle[tip] = R * Vector3d(0, 0, 1);
                needle[a] = Vector3d(0, 0, 0);
                needle[b] = R * Vector3d(0, width, 0);
                needle[c] = R * Vector3d(width, 0, 0);
                const auto nearest = [&](const Vector3d& n) {
                    return closest_face(needle, R * n.normalized());
                };
                const double more = 1 + 1e-13 / width; // the corners are rounded at 1e-16
                REQUIRE_THAT(nearest({1, 0, more}), IsExactly(tip));
                REQUIRE_THAT(nearest({more, 0, 1}), IsExactly(c));
                REQUIRE_THAT(nearest({0.1, 0.1, 1}), IsExactly(tip));
                REQUIRE_THAT(nearest({0.7, 0, 0.75}), IsExactly(tip));
                REQUIRE_THAT(nearest({0, 0.7, -0.75}), IsExactly(tip));
                REQUIRE_THAT(nearest({0.75, 0, 0.7}), IsExactly(c));
                REQUIRE_THAT(nearest({0, 0.75, 0.7}), IsExactly(b));
            }
    }
}

TEST_CASE("fracture: a crack across all faces of a flat tetrahedron", "[A7.4][fracture]")
{
    // The normals of all faces are nearly z, and that of the crack is x or y. The tip is h above
    // the foot, so |n_f · n| is at most 4 h: along y for the face with the edge y = 0, and along x
    // for that with the edge x = 0.
    for (int power = 2; power <= 44; power += 3)
        for (int first = 0; first < 4; ++first) {
            CAPTURE(power, first);
            std::array<Vector3d, 4> x;
            x[first] = {0, 0, 0};
            x[(first + 1) % 4] = {2, 0, 0};
            x[(first + 2) % 4] = {0, 2, 0};
            x[(first + 3) % 4] = {0.5, 0.25, std::ldexp(1, -power)};
            REQUIRE_THAT(closest_face(x, {0, 1, 0}), IsExactly((first + 2) % 4));
            REQUIRE_THAT(closest_face(x, {1, 0, 0}), IsExactly((first + 1) % 4));
        }
}

TEST_CASE("fracture: any tension above the threshold opens a crack", "[A7.3][fracture]")
{
    for (Random random : seeds(50)) {
        const Matrix3d R = random.rotation();
        const double low = -random.mass();
        for (const double sigma : {1e-3, 1e-6, 1e-9}) {
            CAPTURE(sigma);
            const Matrix3d stress = R * Vector3d(low, 2 * low, sigma).asDiagonal() * R.transpose();
            const Matrix3d symmetric = (stress + stress.transpose()) / 2;
            for (const double threshold : {0.0, -1.0, 0.9 * sigma}) {
                CAPTURE(threshold);
                const auto normal = crack_plane(symmetric, threshold);
                check_that(normal.has_value(),
                           "a crack, where the pull sigma exceeds the strength");
                REQUIRE_THAT(std::abs(normal->dot(R.col(2))), IsClose(1.0, Rounding(1 << 10, 1)));
            }
            REQUIRE_THAT(crack_plane(symmetric, 1.1 * sigma), IsExactly(std::optional<Vector3d>()));
        }
    }
}

namespace {

// The gradient of the barycentric coordinate of a corner of the unit tetrahedron.
Vector3d towards(int corner)
{
    if (corner == 0) return {-1, -1, -1};
    return Vector3d::Unit(corner - 1);
}

} // namespace

TEST_CASE("fracture: cracks also divide a part without matter", "[A7.7][fracture]")
{
    // Some corners lie on the plane of the first crack, on the side of its normal, so their part
    // has no share. Each later crack takes one of them away from the others.
    const TetrahedralMesh unit = unit_tetrahedron();
    const std::vector<int> some[] = {{0, 1}, {0, 2},    {0, 3},    {1, 2},    {1, 3},
                                     {2, 3}, {0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}};
    for (const std::vector<int>& on_plane : some)
        for (std::size_t later = 0; later < on_plane.size(); ++later)
            for (const double sign : {1.0, -1.0}) {
                CAPTURE(on_plane, later, sign);
                Tetrahedron rest = {0, 0, 0, 0}, others = {1, 1, 1, 1};
                for (int c : on_plane)
                    rest[c] = 1, others[c] = 0;
                Vector3d n = Vector3d::Zero();
                for (int c = 0; c < 4; ++c)
                    if (others[c] == 1) n -= towards(c);
                Cracks cracks = {{0, unit.vertices[on_plane[0]], n.normalized()}};
                std::vector<Tetrahedron> real = {others};
                for (std::size_t i = 0; i < later; ++i) {
                    const int c = on_plane[i];
                    const Vector3d middle(c < 2 ? 0.5 : 0, c == 2 ? 0.5 : 0, c == 3 ? 0.5 : 0);
                    cracks.push_back({0, middle, sign * towards(c).normalized()});
                    rest[c] = 0;
                    Tetrahedron alone = {0, 0, 0, 0};
                    alone[c] = 1;
                    real.push_back(alone);
                }
                real.push_back(rest);
                std::sort(real.rbegin(), real.rend()); // by their first real corners
                std::vector<double> shares;
                for (const Tetrahedron& part : real)
                    shares.push_back(part == others ? 1 : 0);
                const EmbeddedMesh result = embedded(unit, cracks);
                REQUIRE_THAT(result.real, IsExactly(real));
                check_shares(result, shares, Rounding(16, 1));
            }
}

TEST_CASE("fracture: an element without volume takes the stress of its neighbours",
          "[A7.1][fracture]")
{
    const Matrix3d one = Matrix3d::Identity(), two = 2 * one, five = 5 * one;
    const std::vector<Matrix3d> smooth =
        smooth_stress({one, two, five}, {{1}, {0}, {}}, {0, 3e-18, 0});
    REQUIRE_THAT(smooth, IsClose(std::vector<Matrix3d>{two, two, five}, Rounding(8)));
}

} // namespace rigor::testing
