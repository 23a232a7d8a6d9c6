// SPDX-License-Identifier: MIT
#include "deformable/elasticity/element.hpp"

#include "deformable/elasticity/elements.hpp"
#include "deformable/elasticity/polar_decomposition.hpp"
#include "support/close.hpp"

#include "support/deformables.hpp"
#include <numbers>

using namespace rigor;
using namespace rigor::testing;

namespace {

Matrix3d random_matrix(Random& random)
{
    Matrix3d A;
    A << random.vector(), random.vector(), random.vector();
    return A;
}

std::vector<Vector3d> forces_of(const Deformable& solid)
{
    std::vector<Vector3d> forces(solid.positions.size(), Vector3d::Zero());
    Elements(solid).add_forces(solid.positions, solid.velocities, forces);
    return forces;
}

double largest(const std::vector<Vector3d>& vectors)
{
    double size = 0;
    for (const Vector3d& v : vectors)
        size = std::max(size, v.norm());
    return size;
}

// The slope of the energy for each component of each position [N], by central differences. The
// error is about 1e-9 of the largest slope.
std::vector<Vector3d> energy_slopes(Deformable solid, double step)
{
    std::vector<Vector3d> slopes(solid.positions.size());
    for (std::size_t i = 0; i < slopes.size(); ++i)
        for (int axis = 0; axis < 3; ++axis) {
            double& x = solid.positions[i][axis];
            const double x0 = x;
            x = x0 + step;
            const double high = totals(solid).elastic_energy;
            x = x0 - step;
            const double low = totals(solid).elastic_energy;
            x = x0;
            slopes[i][axis] = (high - low) / (2 * step);
        }
    return slopes;
}

} // namespace

TEST_CASE("polar: any matrix is a rotation times a symmetric one", "[deformable]")
{
    Random random(1);
    for (int k = 0; k < 2000; ++k) {
        CAPTURE(k);
        Matrix3d F = random_matrix(random);
        if (k % 4 == 1) F.col(2) = 1e-7 * F.col(2) + F.col(0); // almost flat
        if (k % 4 == 2) F = random.rotation() * 1e6;
        if (k % 4 == 3) F = F.col(0) * F.col(1).transpose(); // a line
        const auto [R, S] = polar_decomposition(F);
        REQUIRE_THAT(R, IsRotation());
        REQUIRE_THAT((R * S).eval(), IsClose(F, Rounding(200)));
        // R is the closest rotation: by the singular values, no other has a larger Tr(Rᵀ F).
        const Eigen::JacobiSVD<Matrix3d> svd(F);
        const Vector3d s = svd.singularValues();
        const double best = s[0] + s[1] + (F.determinant() < 0 ? -s[2] : s[2]);
        REQUIRE_THAT(S.trace(), IsClose(best, Rounding(200, s[0])));
    }
    CHECK(polar_decomposition(Matrix3d::Zero()).R.allFinite());
}

TEST_CASE("element: a motion without deformation costs no force", "[deformable]")
{
    for (unsigned seed = 0; seed < 30; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        Deformable solid = solid_of(random_mesh(random), soft_material());
        solid.material.damping = 0.01;
        Matrix3d R = random.rotation();
        if (seed % 3 == 0)
            R = Eigen::AngleAxisd(std::numbers::pi, random.unit_vector()); // half a turn
        const Vector3d V = random.vector(), w = random.vector();
        for (std::size_t i = 0; i < solid.positions.size(); ++i) {
            solid.positions[i] = R * solid.rest.vertices[i] + 5 * V;
            solid.velocities[i] = V + w.cross(solid.positions[i]);
        }
        // E times the area of a node is 1e5 N.
        REQUIRE_THAT(largest(forces_of(solid)), IsClose(0.0, Rounding(200, 1e5)));
    }
}

TEST_CASE("element: patch test: an affine deformation has one stress and no inner force",
          "[deformable]")
{
    for (unsigned seed = 0; seed < 30; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        Deformable solid = solid_of(random_mesh(random), soft_material());
        const Matrix3d R = random.rotation();
        const Matrix3d F = R * (Matrix3d::Identity() + 0.2 * random_matrix(random));
        for (std::size_t i = 0; i < solid.positions.size(); ++i)
            solid.positions[i] = F * solid.rest.vertices[i] + Vector3d(1, 2, 3);
        const Matrix3d S = polar_decomposition(F).S;
        const Matrix3d strain = S - Matrix3d::Identity();
        const SolidMaterial& m = solid.material;
        const Matrix3d expected = m.lame_lambda() * strain.trace() * Matrix3d::Identity() +
                                  2 * m.shear_modulus() * strain;
        for (const Matrix3d& stress : element_stresses(solid))
            REQUIRE_THAT(stress, IsClose(expected, Rounding(200, 1e5)));

        std::vector<char> is_outside(solid.positions.size(), 0);
        for (const auto& triangle : boundary(solid.rest).triangles)
            for (const int v : triangle)
                is_outside[v] = 1;
        const auto forces = forces_of(solid);
        int inside = 0;
        for (std::size_t i = 0; i < forces.size(); ++i)
            if (!is_outside[i]) {
                ++inside;
                REQUIRE_THAT(forces[i].norm(), IsClose(0.0, Rounding(500, 1e5)));
            }
        REQUIRE(inside == 2);
    }
}

TEST_CASE("element: forces are the slope of the energy, whatever has flowed", "[deformable]")
{
    for (unsigned seed = 0; seed < 6; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        Deformable solid = solid_of(random_mesh(random), soft_material());
        for (Vector3d& x : solid.positions)
            x += 0.1 * random.vector();
        if (seed % 2)
            for (Matrix3d& strain : solid.plastic_strains) {
                const Matrix3d A = random_matrix(random);
                strain = 0.1 * (A + A.transpose());
            }
        const auto forces = forces_of(solid);
        const auto slopes = energy_slopes(solid, 1e-5);
        Vector3d sum = Vector3d::Zero(), torque = Vector3d::Zero();
        for (std::size_t i = 0; i < forces.size(); ++i) {
            // Central differences have an error of step² and of rounding divided by the step.
            REQUIRE_THAT(forces[i], IsClose((-slopes[i]).eval(), Order(1e-7 * largest(forces))));
            sum += forces[i];
            torque += solid.positions[i].cross(forces[i]);
        }
        REQUIRE_THAT(sum, IsClose(Vector3d::Zero().eval(), Rounding(200, 1e5)));
        REQUIRE_THAT(torque, IsClose(Vector3d::Zero().eval(), Rounding(500, 1e5)));
    }
}

TEST_CASE("element: damping takes energy and leaves both momenta", "[deformable]")
{
    for (unsigned seed = 0; seed < 20; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        Deformable solid = solid_of(random_mesh(random), soft_material());
        for (std::size_t i = 0; i < solid.positions.size(); ++i) {
            solid.positions[i] += 0.1 * random.vector();
            solid.velocities[i] = random.vector();
        }
        const auto without = forces_of(solid);
        solid.material.damping = 1;
        const auto with = forces_of(solid);
        double power = 0;
        Vector3d sum = Vector3d::Zero(), torque = Vector3d::Zero();
        for (std::size_t i = 0; i < with.size(); ++i) {
            const Vector3d f = with[i] - without[i];
            power += f.dot(solid.velocities[i]);
            sum += f;
            torque += solid.positions[i].cross(f);
        }
        check_at_most(power, 0, "power");
        REQUIRE_THAT(sum, IsClose(Vector3d::Zero().eval(), Rounding(500, 1e5)));
        REQUIRE_THAT(torque, IsClose(Vector3d::Zero().eval(), Rounding(1000, 1e5)));
    }
}
