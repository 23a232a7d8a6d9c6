// SPDX-License-Identifier: MIT
// The plain data that formulas take and return: numbers, fixed-size Eigen types and vectors of
// them. All of it can be sent to another process.
//
// Conventions for every topic:
//   * SI units. World space is right-handed, y points up.
//   * X, V, L are the position of the center of mass, its velocity and the angular momentum about
//     it, in world space. In A1.7 and A1.13, X may be any point that moves with the body, and in
//     A1.8 any point.
//   * R and the unit quaternion q rotate object space into world space: x = R p + X.
//   * Bodies 1 and 2: the unit normal n points from 2 to 1, v = v1 - v2, body 1 receives +j and
//     body 2 receives -j. The bodies approach where v·n < 0. The normal part of v is vₙ = v·n, its
//     tangential part v_T = v - vₙ n; jₙ and j_T are those of j.
//   * δ is the identity matrix, and w* the cross-product matrix of w: w* x = w × x.
//   * A static body is one whose velocity nothing changes. It has inverse mass 0 and inverse
//     inertia 0, and no formula divides by its mass.
//   * Every formula is total: the result is finite for finite arguments, as long as a double holds
//     the terms that the formula adds up, and their squares, in topic `collision` also products of
//     three of them. The exceptions are A3.13 (for ω = 0) and A6.7 (for G = 0), which are then
//     infinite. A number so small that its square is no double may count as 0. A formula remembers
//     no earlier call, and for a zero of either sign it has the same result (-0 or 0: they are
//     equal).
#pragma once

#include <Eigen/Dense>

#include <array>
#include <optional>
#include <vector>

namespace rigor {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Matrix36d = Eigen::Matrix<double, 3, 6>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

/// A quaternion s + v.x i + v.y j + v.z k, scalar first. It has no operators, because its algebra
/// is an assignment.
struct Quaternion {
    double s = 1;
    Vector3d v = Vector3d::Zero();
};

/// A point mass.
struct Particle {
    double mass = 0;                      // [kg]
    Vector3d position = Vector3d::Zero(); // [m]
};

/// A force and the world-space point it acts at.
struct PointForce {
    Vector3d force = Vector3d::Zero(); // [N]
    Vector3d point = Vector3d::Zero(); // [m]
};

/// Net force and net torque. The torque is about the center of mass, but in A1.8 and A1.13 it is
/// about the argument X.
struct Wrench {
    Vector3d force = Vector3d::Zero();  // [N]
    Vector3d torque = Vector3d::Zero(); // [N m]
};

/// Mass, center of mass and inertia of a body.
struct MassProperties {
    double mass = 0;                            // [kg]
    Vector3d center_of_mass = Vector3d::Zero(); // [m]
    Matrix3d inertia = Matrix3d::Zero();        // about the center of mass [kg m²]
};

/// The principal frame of an inertia tensor, I = Q diag(moments) Qᵀ.
struct PrincipalAxes {
    Matrix3d rotation = Matrix3d::Identity(); // Q, determinant +1; its columns are the axes
    Vector3d moments = Vector3d::Zero();      // ascending [kg m²]
};

/// Density at a point of object space.
struct DensitySample {
    Vector3d position = Vector3d::Zero(); // [m]
    double density = 0;                   // [kg/m³]
};

/// A surface of triangles, counter-clockwise seen from outside.
struct TriangleMesh {
    std::vector<Vector3d> vertices;            // [m]
    std::vector<std::array<int, 3>> triangles; // indices into vertices
};

/// The state of a rigid body with its orientation as a rotation matrix (lecture "Rigid bodies").
struct MatrixState {
    Vector3d position = Vector3d::Zero();         // X [m]
    Matrix3d rotation = Matrix3d::Identity();     // R
    Vector3d velocity = Vector3d::Zero();         // V [m/s]
    Vector3d angular_momentum = Vector3d::Zero(); // L [kg m²/s]
};

/// The time derivative of a MatrixState.
struct MatrixStateRate {
    Vector3d position_rate = Vector3d::Zero();         // Ẋ [m/s]
    Matrix3d rotation_rate = Matrix3d::Zero();         // Ṙ [1/s]
    Vector3d velocity_rate = Vector3d::Zero();         // V̇ [m/s²]
    Vector3d angular_momentum_rate = Vector3d::Zero(); // L̇ [N m]
};

/// The state of a rigid body with its orientation as a unit quaternion.
struct RigidState {
    Vector3d position = Vector3d::Zero();         // X [m]
    Quaternion orientation;                       // q, unit
    Vector3d velocity = Vector3d::Zero();         // V [m/s]
    Vector3d angular_momentum = Vector3d::Zero(); // L [kg m²/s]
};

/// The inverse mass and the inverse inertia of a body, as its equations of motion use them. If the
/// inverse inertia is 0 but the inverse mass is not, the body is a point mass, which never turns.
struct BodyInertia {
    double inverse_mass = 0;                     // 1/M [1/kg], 0 if static
    Matrix3d inverse_inertia = Matrix3d::Zero(); // I_body⁻¹, object space [1/(kg m²)], 0 if static
};

/// A rigid body at the moment of a collision. All its quantities are in world space.
struct Body {
    double inverse_mass = 0;                     // 1/M [1/kg], 0 if static
    Matrix3d inverse_inertia = Matrix3d::Zero(); // I(t)⁻¹ = R I_body⁻¹ Rᵀ [1/(kg m²)], 0 if static
    Vector3d position = Vector3d::Zero();         // X [m]
    Vector3d velocity = Vector3d::Zero();         // V [m/s]
    Vector3d angular_velocity = Vector3d::Zero(); // ω [rad/s]
    Vector3d angular_momentum = Vector3d::Zero(); // L [kg m²/s]

    bool is_static() const { return inverse_mass == 0; }
};

/// A point where body 1 touches or penetrates body 2, or is about to touch it.
struct ContactPoint {
    Vector3d point = Vector3d::Zero();             // x, world space [m]
    Vector3d normal = Vector3d::UnitY();           // n, unit, from body 2 to body 1
    double depth = 0;                              // penetration depth, negative for a gap [m]
    Vector3d relative_velocity = Vector3d::Zero(); // v = v1 - v2 at x [m/s]
};

/// A point where two of several bodies touch or are about to touch.
struct BodyContact {
    int body1 = 0, body2 = 0;            // indices of the bodies
    Vector3d point = Vector3d::Zero();   // x, world space [m]
    Vector3d normal = Vector3d::UnitY(); // n, unit, from body 2 to body 1
    double depth = 0;                    // penetration depth, negative for a gap [m]
    double friction = 0;                 // μ
    double separation_speed = 0;         // s [m/s], the smallest v·n allowed after the contact is
                                         // resolved; if the bodies may still close a gap in the
                                         // time step h, s is -gap/h
    Vector3d impulse = Vector3d::Zero(); // on body 1, an initial guess of the result [N s]
};

/// Bodies after their contacts were resolved.
struct ContactResult {
    std::vector<Body> bodies;
    std::vector<Vector3d> impulses; // one for each contact, on body 1 [N s]
};

/// Signed distance to a surface, negative inside, sampled at the nodes of a grid.
/// Node (i, j, k) lies at origin + cell_size (i, j, k). Its value is
/// distances[i + size[0] (j + size[1] k)].
struct LevelSet {
    Vector3d origin = Vector3d::Zero();  // position of node (0, 0, 0) [m]
    double cell_size = 1;                // [m]
    std::array<int, 3> size = {0, 0, 0}; // nodes along x, y, z; at least 2 each
    std::vector<double> distances;       // [m]
};

/// A solid made of tetrahedra. Each tetrahedron has a positive volume:
/// det(x₁ - x₀, x₂ - x₀, x₃ - x₀) > 0. Its face f is the one opposite its vertex f.
struct TetrahedralMesh {
    std::vector<Vector3d> vertices;             // [m]
    std::vector<std::array<int, 4>> tetrahedra; // indices into vertices
};

/// A face of a tetrahedral mesh, given by either of the tetrahedra that share it.
struct MeshFace {
    int tetrahedron = 0;
    int face = 0; // index of the face, 0 … 3: that of the opposite vertex
};

/// The largest eigenvalue of a stress, and the direction of its eigenvector.
struct PrincipalStress {
    double stress = 0;                      // σ₁ [Pa]
    Vector3d direction = Vector3d::UnitX(); // unit, of either sign
};

/// The origin of a vertex of a changed mesh: it is (1 - t) x_first + t x_second of the mesh before
/// the change. Quantities stored at vertices (position, velocity) are interpolated the same way.
struct VertexOrigin {
    int first = 0, second = 0;
    double fraction = 0; // t, 0 … 1; 0 where first = second
};

/// A mesh that was split.
struct SplitMesh {
    TetrahedralMesh mesh;
    std::vector<VertexOrigin> origins; // one for each vertex
    std::vector<int> parents;          // for each tetrahedron, the old one that it is a part of
};

/// A plane that cracks one tetrahedron.
struct ElementCrack {
    int tetrahedron = 0;
    Vector3d point = Vector3d::Zero();   // on the plane [m]
    Vector3d normal = Vector3d::UnitY(); // unit, of either sign
};

/// A mesh in which some tetrahedra are duplicated. Each copy holds a part of the material.
struct EmbeddedMesh {
    TetrahedralMesh mesh;
    std::vector<int> vertex_parents;      // for each vertex, the vertex that it is a copy of
    std::vector<int> parents;             // for each tetrahedron, the one that it is a copy of
    std::vector<std::array<int, 4>> real; // for each tetrahedron and corner: 1 if the corner
                                          // belongs to the copy's part of the material, 0 if
                                          // the corner is virtual
    std::vector<double> fractions;        // for each tetrahedron, its share of the parent's
                                          // volume, 0 … 1
};

} // namespace rigor
