// SPDX-License-Identifier: MIT
// Our engine as a contestant, and the lists of all contestants.
#include "engine.hpp"
#include "rigid/bodies/mass.hpp"
#include "rigid/step/step.hpp"

namespace rigor {

namespace {

Quaternion ours(const Eigen::Quaterniond& q)
{
    return {q.w(), q.vec()};
}

RigidBody rigid_body(const TrialBody& from, const Material& material)
{
    RigidBody body;
    body.parts = {Part{from.shape, Vector3d::Zero(), Quaternion(), 1}};
    body.material = material;
    set_mass(body, from.mass, from.inertia.asDiagonal().toDenseMatrix());
    body.state.position = from.position;
    body.state.orientation = ours(from.orientation);
    body.state.velocity = from.velocity;
    // L = R I Rᵀ ω
    const Matrix3d R = from.orientation.toRotationMatrix();
    body.state.angular_momentum =
        R * from.inertia.asDiagonal() * R.transpose() * from.angular_velocity;
    return body;
}

class RigorEngine final : public TrialEngine {
public:
    RigorEngine(const Trial& trial, Integrator integrator, ContactMethod method)
    {
        world_.settings.integrator = integrator;
        world_.settings.contact_method = method;
        world_.settings.formulas_are_reference = true;
        world_.settings.optimisations.sleep = false;
        world_.settings.gravity = trial.gravity;
        const Material material = {trial.restitution, trial.friction};
        for (const TrialBody& body : trial.bodies) {
            world_.bodies.push_back(rigid_body(body, material));
            world_.bodies.back().name = "body " + std::to_string(world_.bodies.size());
        }
        if (trial.has_ground) {
            RigidBody& ground = world_.bodies.emplace_back();
            ground.name = "ground";
            ground.parts = {Part{Plane(), Vector3d::Zero(), Quaternion(), 1}};
            ground.material = material;
            ground.is_static = true;
            ground.state.orientation = ours(trial.ground);
        }
        if (!trial.couple.isZero(0)) {
            world_.forces.push_back({0, trial.couple, trial.arm});
            world_.forces.push_back({0, -trial.couple, Vector3d::Zero()});
        }
    }

    void step(double time_step) override { rigor::step(world_, time_step); }

    TrialMotion motion(int body) const override
    {
        const RigidState& state = world_.bodies[body].state;
        const Quaternion& q = state.orientation;
        return {state.position, Eigen::Quaterniond(q.s, q.v.x(), q.v.y(), q.v.z()), state.velocity};
    }

private:
    World world_;
};

Contestant rigor_contestant(const std::string& name, Integrator integrator, ContactMethod method)
{
    return {"rigor", name, [integrator, method](const Trial& trial) {
                return std::make_unique<RigorEngine>(trial, integrator, method);
            }};
}

void add_bullet([[maybe_unused]] std::vector<Contestant>& all)
{
#ifdef RIGOR_BULLET
    all.push_back({"bullet", RIGOR_BULLET, bullet_engine});
#endif
}

void add_ode([[maybe_unused]] std::vector<Contestant>& all, [[maybe_unused]] bool quick_step)
{
#ifdef RIGOR_ODE
    all.push_back({"ode", quick_step ? "quick_step" : "step",
                   [quick_step](const Trial& trial) { return ode_engine(trial, quick_step); }});
#endif
}

} // namespace

TrialBody solid_ball(double radius, double mass)
{
    TrialBody body;
    body.shape = Sphere{radius};
    body.mass = mass;
    body.inertia.setConstant(0.4 * mass * radius * radius);
    return body;
}

TrialBody solid_cuboid(const Vector3d& size, double mass)
{
    TrialBody body;
    body.shape = Box{size};
    body.mass = mass;
    const Vector3d s = size.cwiseProduct(size);
    body.inertia = mass / 12 * Vector3d(s.y() + s.z(), s.z() + s.x(), s.x() + s.y());
    return body;
}

std::vector<Contestant> flight_contestants()
{
    constexpr ContactMethod any = ContactMethod::built_in;
    std::vector<Contestant> all = {rigor_contestant("runge_kutta", Integrator::runge_kutta, any),
                                   rigor_contestant("matrix", Integrator::matrix, any),
                                   rigor_contestant("buss", Integrator::buss, any),
                                   rigor_contestant("exponential", Integrator::exponential, any),
                                   rigor_contestant("linear", Integrator::linear, any),
                                   rigor_contestant("exact", Integrator::exact, any)};
    add_bullet(all);
    add_ode(all, false);
    return all;
}

std::vector<Contestant> contact_contestants()
{
    constexpr Integrator best = Integrator::runge_kutta;
    std::vector<Contestant> all;
    for (const auto& [name, method] :
         {std::pair("built_in", ContactMethod::built_in),
          std::pair("simultaneous", ContactMethod::simultaneous),
          std::pair("one_at_a_time", ContactMethod::one_at_a_time),
          std::pair("shock_propagation", ContactMethod::shock_propagation)})
        all.push_back(rigor_contestant(name, best, method));
    add_bullet(all);
    add_ode(all, false);
    add_ode(all, true);
    return all;
}

} // namespace rigor
