// SPDX-License-Identifier: MIT
// Scenes that our engine, Bullet and ODE can all run, and a common interface to run them. The
// benchmarks `accuracy` and `contact` use it.
#pragma once

#include "geometry/shapes/shape.hpp"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace rigor {

/// A body that moves. SI units, world space, y up.
struct TrialBody {
    Shape shape;      // collision shape, a sphere or a box
    double mass = 1;  // [kg]
    Vector3d inertia; // principal moments, along the axes of object space [kg m²]
    Vector3d position = Vector3d::Zero();
    Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
    Vector3d velocity = Vector3d::Zero();
    Vector3d angular_velocity = Vector3d::Zero();
};

TrialBody solid_ball(double radius, double mass);
TrialBody solid_cuboid(const Vector3d& size, double mass);

/// A scene. Its ground is the half-space y ≤ 0, turned about the origin.
struct Trial {
    std::vector<TrialBody> bodies;
    bool has_ground = false;
    Eigen::Quaterniond ground = Eigen::Quaterniond::Identity();
    double friction = 0, restitution = 0; // the same for every pair
    Vector3d gravity = Vector3d::Zero();  // [m/s²]
    /// A couple on the first body: the force f at `arm` and -f at the origin of the body. It
    /// replaces a pin at the origin; the inertia must then be that about the pin.
    Vector3d couple = Vector3d::Zero(); // f [N]
    Vector3d arm = Vector3d::Zero();    // object space [m]
};

struct TrialMotion {
    Vector3d position = Vector3d::Zero();
    Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
    Vector3d velocity = Vector3d::Zero();
};

/// A running trial. It uses one thread; no body falls asleep, and there is no damping.
class TrialEngine {
public:
    virtual ~TrialEngine() = default;
    virtual void step(double time_step) = 0;
    virtual TrialMotion motion(int body) const = 0;
};

/// One way to run a trial.
struct Contestant {
    std::string engine, method;
    std::function<std::unique_ptr<TrialEngine>(const Trial&)> start;
    std::string name() const { return engine + " " + method; }
    bool is_ours() const { return engine == "rigor"; }
};

/// Our methods, the default first, then the other engines that were installed at build time.
std::vector<Contestant> flight_contestants();  // our integrators
std::vector<Contestant> contact_contestants(); // our contact methods

/// The other engines, with their default settings.
std::unique_ptr<TrialEngine> bullet_engine(const Trial& trial);
std::unique_ptr<TrialEngine> ode_engine(const Trial& trial, bool quick_step);

} // namespace rigor
