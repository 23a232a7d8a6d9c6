// SPDX-License-Identifier: MIT
// Sums energy, momentum and penetration over a recorded frame: first over the rigid bodies, then
// over the deformable solids, the springs and the contacts.
#include "scene/trajectory/statistics.hpp"

#include "deformable/elasticity/totals.hpp"
#include "geometry/shapes/pose.hpp"

#include <algorithm>

namespace rigor {

namespace {

// The inverse of an inertia tensor. The inverse of a principal moment that is 0 is set to 0: a thin
// rod has no angular velocity about its own axis.
Matrix3d pseudo_inverse(const Matrix3d& I)
{
    const Eigen::SelfAdjointEigenSolver<Matrix3d> eigen(0.5 * (I + I.transpose()));
    // A moment up to this fraction of the largest one counts as 0, as in formula `invert_moments`.
    constexpr double zero_moment = 1e-12;
    const double rounding = zero_moment * eigen.eigenvalues().cwiseAbs().maxCoeff();
    Vector3d inverse = Vector3d::Zero();
    for (int i = 0; i < 3; ++i)
        if (eigen.eigenvalues()[i] > rounding) inverse[i] = 1 / eigen.eigenvalues()[i];
    return eigen.eigenvectors() * inverse.asDiagonal() * eigen.eigenvectors().transpose();
}

double largest(const std::vector<float>& numbers)
{
    return numbers.empty() ? 0.0 : *std::max_element(numbers.begin(), numbers.end());
}

} // namespace

SolidStatistics statistics_of(const SolidFrame& solid)
{
    return {solid.totals, solid.topology->pieces, solid.topology->elements.size(),
            largest(solid.stresses), largest(solid.plastic_strains)};
}

Statistics::Statistics(const Scene& scene, const std::vector<RecordedBody>& bodies)
    : scene_(scene), bodies_(bodies)
{
    for (const RecordedBody& body : bodies_)
        inverse_inertia_.push_back(body.is_static ? Matrix3d::Zero()
                                                  : pseudo_inverse(body.inertia));
}

Vector3d Statistics::angular_velocity(std::size_t body, const RigidState& state) const
{
    const Matrix3d R = rotation_matrix(state.orientation);
    return R * (inverse_inertia_[body] * (R.transpose() * state.angular_momentum));
}

FrameStatistics Statistics::of(const Frame& frame) const
{
    FrameStatistics sums;
    sums.time = frame.time;
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        if (bodies_[i].is_static) continue;
        const RigidState& state = frame.bodies[i];
        const double M = bodies_[i].mass;
        const Vector3d &X = state.position, &V = state.velocity, &L = state.angular_momentum;
        sums.kinetic_energy += 0.5 * M * V.squaredNorm() + 0.5 * L.dot(angular_velocity(i, state));
        sums.potential_energy -= M * scene_.settings.gravity.dot(X);
        sums.momentum += M * V;
        sums.angular_momentum += X.cross(M * V) + L;
    }
    for (const SolidFrame& solid : frame.solids) {
        const DeformableTotals& totals = solid.totals;
        sums.kinetic_energy += totals.kinetic_energy;
        sums.potential_energy += totals.elastic_energy -
                                 totals.mass * scene_.settings.gravity.dot(totals.center_of_mass);
        sums.momentum += totals.momentum;
        sums.angular_momentum += totals.angular_momentum;
        sums.solids.push_back(statistics_of(solid));
    }
    const auto world_point = [&](int body, const Vector3d& point) -> Vector3d {
        if (body < 0) return point;
        const RigidState& state = frame.bodies[static_cast<std::size_t>(body)];
        return rotation_matrix(state.orientation) *
                   (point - bodies_[static_cast<std::size_t>(body)].center_of_mass) +
               state.position;
    };
    for (const Spring& spring : scene_.springs) {
        const Vector3d between =
            world_point(spring.body1, spring.point1) - world_point(spring.body2, spring.point2);
        const double stretch = between.norm() - spring.rest_length;
        if (spring.only_pulls && stretch < 0) continue; // a slack spring stores no energy
        sums.potential_energy += 0.5 * spring.stiffness * stretch * stretch;
    }
    for (const ContactRecord& contact : frame.contacts)
        sums.deepest_penetration = std::max(sums.deepest_penetration, contact.depth);
    return sums;
}

} // namespace rigor
