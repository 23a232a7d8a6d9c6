// SPDX-License-Identifier: MIT
// A scene as its file describes it: nothing computed yet, no formula called.
#pragma once

#include "deformable/solid/deformable.hpp"
#include "deformable/step/deformable_world.hpp"
#include "geometry/shapes/shape.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace rigor {

struct BodyDescription {
    std::string name;
    std::vector<Part> parts; // in the body's own frame, as written
    Material material;
    bool is_static = false;
    std::optional<double> mass; // given instead of densities [kg]
    // given with mass, about the center of mass, which is the frame's origin [kg m²]
    std::optional<Matrix3d> inertia;
    Vector3d position = Vector3d::Zero(); // where the frame's origin is [m]
    Quaternion orientation;
    Vector3d velocity = Vector3d::Zero();         // the center of mass's [m/s]
    Vector3d angular_velocity = Vector3d::Zero(); // world space [rad/s]
    std::optional<Vector3d> color;                // red, green, blue in 0 … 1
};

/// A solid that deforms.
struct SolidDescription {
    std::string name;
    std::shared_ptr<const TetrahedralMesh> mesh; // in the solid's own frame, as written
    SolidMaterial material;
    NodeIntegrator integrator = NodeIntegrator::implicit_step;
    FractureMethod fracture_method = FractureMethod::faces;
    Vector3d position = Vector3d::Zero(); // where the frame's origin is [m]
    Quaternion orientation;
    Vector3d velocity = Vector3d::Zero();         // the center of mass's [m/s]
    Vector3d angular_velocity = Vector3d::Zero(); // world space [rad/s]
    std::optional<Vector3d> color;                // red, green, blue in 0 … 1
    std::vector<Handle> handles;                  // in world space already
    std::vector<NodeLoad> loads;                  // in world space already
};

struct Camera {
    Vector3d position = Vector3d(4, 3, 6);
    Vector3d target = Vector3d::Zero();
    double field_of_view = 40; // vertical [degrees]
};

/// What the colors of deformable solids mean.
enum class SolidColors { color, stress, plastic_strain };

/// What to draw besides the bodies.
struct Overlays {
    bool axes = false, angular_velocity = false, angular_momentum = false, contacts = false,
         labels = false, grid = true;
    SolidColors solids = SolidColors::color;
    std::optional<std::array<double, 2>> solids_range; // what the colors span [Pa, or no unit]
};

struct Scene {
    std::string name;        // the file's, without its ending
    std::string description; // one sentence: what to see
    std::string text;        // the file itself
    std::vector<BodyDescription> bodies;
    std::vector<SolidDescription> solids;
    std::vector<Spring> springs;              // their points in the bodies' frames, as written
    std::vector<AppliedForce> forces;         // points as those of springs
    Vector3d gravity = Vector3d(0, -9.81, 0); // [m/s²]
    Integrator integrator = Integrator::runge_kutta;
    ContactMethod contact_method = ContactMethod::built_in;
    Skips skips;
    double time_step = 0.01; // [s]
    double end = 1;          // [s]
    double frames_per_second = 30;
    Camera camera;
    Overlays overlays;
};

/// How many time steps lead to the end of the scene.
std::int64_t step_count(const Scene& scene);

/// How many frames it has, with the first at time 0; and the step nearest to the time of a frame.
std::int64_t frame_count(const Scene& scene);
std::int64_t frame_step(const Scene& scene, std::int64_t frame);

} // namespace rigor
