// SPDX-License-Identifier: MIT
#include "rigid/contact_formulas.hpp"

#include "formulas/contact.hpp"
#include "rigid/from_lowest.hpp"

#include <algorithm>
#include <stdexcept>

namespace rigor {

namespace {

constexpr int iterations = 10; // of each of the two formulas, as in the paper
// Weight comes down from a heavy body through a light one in small parts: before shock propagation, `more`
// times as many iterations until contacts approach no faster than this share of what they did, as long as
// no more than `work` contacts are visited.
constexpr double handed_down = 0.02;
constexpr int more = 4, work = 4000;
constexpr double steepest = 0.3; // contacts whose normal is flatter than this carry no weight

// Which bodies each body rests on: those that a contact pushes it away from, against gravity.
std::vector<std::vector<int>> supports(const ContactProblem& problem, const LocalIsland& local)
{
    std::vector<std::vector<int>> rests_on(local.bodies.size());
    for (const BodyContact& c : local.contacts) {
        const double lift = c.normal.dot(problem.up());
        if (lift > steepest) rests_on[c.body1].push_back(c.body2);
        if (lift < -steepest) rests_on[c.body2].push_back(c.body1);
    }
    return rests_on;
}

// The fastest that bodies still approach at a contact [m/s].
double fastest_approach(const std::vector<Body>& bodies, const std::vector<BodyContact>& contacts)
{
    double fastest = 0;
    for (const BodyContact& c : contacts) {
        const Body &b1 = bodies[c.body1], &b2 = bodies[c.body2];
        const Vector3d v = b1.velocity + b1.angular_velocity.cross(c.point - b1.position) -
                           b2.velocity - b2.angular_velocity.cross(c.point - b2.position);
        fastest = std::max(fastest, c.separation_speed - v.dot(c.normal));
    }
    return fastest;
}

ContactResult resolved(ContactProblem& problem, const LocalIsland& local, int n)
{
    ContactResult result = resolve_contacts(local.bodies, local.contacts, n);
    check_size(local, result, "resolve_contacts");
    problem.counters->contact_sweeps += n;
    return result;
}

} // namespace

LocalIsland local_island(const ContactProblem& problem, std::span<const Held> held)
{
    LocalIsland local;
    std::vector<int> touched;
    for (const Held& h : held) {
        const SolvedContact& c = problem.contacts[h.contact];
        touched.push_back(c.body1);
        touched.push_back(c.body2);
    }
    local.indices = touched;
    std::sort(local.indices.begin(), local.indices.end());
    local.indices.erase(std::unique(local.indices.begin(), local.indices.end()),
                        local.indices.end());
    const auto local_index = [&](int body) {
        return static_cast<int>(std::lower_bound(local.indices.begin(), local.indices.end(), body) -
                                local.indices.begin());
    };
    for (int i : local.indices)
        local.bodies.push_back(problem.bodies[i]);
    const Coarse coarse(
        held, [&](const Held& h) -> const Vector3d& { return problem.contacts[h.contact].point; });
    for (const Held& h : held) {
        const SolvedContact& c = problem.contacts[h.contact];
        local.contacts.push_back({local_index(c.body1), local_index(c.body2), c.point, c.normal,
                                  -coarse(c.gap), c.friction, h.target, c.guess});
    }
    return local;
}

void check_size(const LocalIsland& local, const ContactResult& result, const char* formula)
{
    if (result.bodies.size() == local.bodies.size() &&
        result.impulses.size() == local.contacts.size())
        return;
    throw std::out_of_range(std::string(formula) + " returned " +
                            std::to_string(result.bodies.size()) + " bodies and " +
                            std::to_string(result.impulses.size()) + " impulses for " +
                            std::to_string(local.bodies.size()) + " bodies and " +
                            std::to_string(local.contacts.size()) + " contacts");
}

void take_result(ContactProblem& problem, const LocalIsland& local, std::span<const Held> held,
                 const ContactResult& result, const char* formula)
{
    check_size(local, result, formula);
    for (std::size_t i = 0; i < local.indices.size(); ++i) {
        Body& body = problem.bodies[local.indices[i]];
        if (body.is_static()) continue;
        body.velocity = result.bodies[i].velocity;
        body.angular_velocity = result.bodies[i].angular_velocity;
        body.angular_momentum = result.bodies[i].angular_momentum;
    }
    for (std::size_t k = 0; k < held.size(); ++k)
        problem.contacts[held[k].contact].holding = result.impulses[k];
}

void resolve_one_at_a_time(ContactProblem& problem, std::span<const Held> held, bool shock)
{
    const LocalIsland local = local_island(problem, held);
    ContactResult result = resolved(problem, local, iterations);
    if (shock) { // weight that has not come down by now is lost
        const double enough = handed_down * fastest_approach(local.bodies, local.contacts);
        const int most = work / static_cast<int>(held.size());
        for (int n = more * iterations;
             n <= most && fastest_approach(result.bodies, local.contacts) > enough; n *= more)
            result = resolved(problem, local, n);
    }
    take_result(problem, local, held, result, "resolve_contacts");
    if (!shock) return;

    std::vector<bool> is_static;
    for (const Body& body : local.bodies)
        is_static.push_back(body.is_static());
    const std::vector<int> levels = contact_levels(supports(problem, local), is_static);
    if (levels.size() != local.bodies.size())
        throw std::out_of_range("contact_levels returned " + std::to_string(levels.size()) +
                                " levels for " + std::to_string(local.bodies.size()) + " bodies");
    const ContactResult pushed =
        shock_propagation(result.bodies, local.contacts, levels, iterations);
    check_size(local, pushed, "shock_propagation");
    const std::vector<Vector3d> before = result.impulses;
    result = pushed;
    for (std::size_t k = 0; k < before.size(); ++k)
        result.impulses[k] += before[k];
    take_result(problem, local, held, result, "shock_propagation");
    problem.counters->contact_sweeps += iterations;
}

namespace {

class SimultaneousSweeps : public Sweeps {
public:
    SimultaneousSweeps(ContactProblem& problem, std::span<const Held> held)
        : problem_(problem), held_(held), local_(local_island(problem, held))
    {
        result_.bodies = local_.bodies;
    }

    Progress sweep(std::vector<Vector3d>& steps) override
    {
        result_ = resolve_simultaneously(local_.bodies, local_.contacts, 1);
        check_size(local_, result_, "resolve_simultaneously");
        Progress progress;
        for (std::size_t k = 0; k < held_.size(); ++k) {
            const double K = held_[k].normal_K;
            Vector3d& j = local_.contacts[k].impulse;
            steps[k] = result_.impulses[k] - j;
            j = result_.impulses[k];
            progress.change = std::max(progress.change, K * steps[k].norm());
            progress.total = std::max(progress.total, K * j.norm());
            progress.squared += K * steps[k].squaredNorm();
            if (!steps[k].isZero(0)) ++problem_.counters->contact_impulses;
        }
        return progress;
    }

    std::vector<Vector3d> impulses() const override
    {
        std::vector<Vector3d> all;
        for (const BodyContact& c : local_.contacts)
            all.push_back(c.impulse);
        return all;
    }

    void add(const std::vector<Vector3d>& changes) override
    {
        for (std::size_t k = 0; k < held_.size(); ++k)
            local_.contacts[k].impulse += changes[k];
    }

    void finish() override
    {
        take_result(problem_, local_, held_, result_, "resolve_simultaneously");
    }

private:
    ContactProblem& problem_;
    std::span<const Held> held_;
    LocalIsland local_;
    ContactResult result_; // of the last sweep
};

} // namespace

std::unique_ptr<Sweeps> simultaneous_sweeps(ContactProblem& problem, std::span<const Held> held)
{
    return std::make_unique<SimultaneousSweeps>(problem, held);
}

} // namespace rigor
