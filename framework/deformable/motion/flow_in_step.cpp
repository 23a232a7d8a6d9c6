// SPDX-License-Identifier: MIT
// Finds the plastic flow within a step of backward Euler by Newton's method with the consistent
// tangent (Simo and Taylor 1985). The step minimizes a convex function of the velocities, so that a
// line search makes the method converge from any start (Ortiz and Stainier 1999, "The variational
// formulation of viscoplastic constitutive updates"). Each round asks the formulas how each element
// flows at the velocities of the latest solve, and compares that with what the solve had assumed.
// If the two differ for an element, the flow is linearized about these velocities. If the
// velocities have gone too far beyond the minimum, they are first replaced by a point between them
// and the velocities of the previous linearization.
#include "deformable/motion/flow_in_step.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

namespace {

// The flow that a solve has assumed counts as right if the error of the stress after this flow,
// divided by the yield stress, is below this number. The error falls quadratically, so that a
// larger tolerance would hardly save a round.
constexpr double flow_tolerance = 1e-9;
// The rounding error of a stress, divided by 2 G ‖e‖ with the trial elastic strain e.
constexpr double rounding = 1e-13;
// On the way from the velocities of the previous linearization to those of the latest solve, the
// function that the step minimizes first falls. If its slope at the end of this way, divided by the
// size of its slope at the start, is above this number, the latest velocities lie too far beyond
// the minimum.
constexpr double largest_turn = 0.5;

Matrix3d deviatoric(const Matrix3d& a)
{
    return a - a.trace() / 3 * Matrix3d::Identity();
}

double product(const Matrix3d& a, const Matrix3d& b)
{
    return a.cwiseProduct(b).sum();
}

// The part that a linearized flow takes away from the stress of a strain d (element_flow.hpp):
// 2 G (a (dev d - (k : d) k) + (n : d) n).
Matrix3d softening(const ElementFlow& f, double G, const Matrix3d& d)
{
    Matrix3d across = deviatoric(d);
    if (f.is_limited()) across -= product(f.kept, d) * f.kept;
    return 2 * G * (f.softened * across + product(f.along, d) * f.along);
}

// Sets a, n and k of a linearized flow (element_flow.hpp). They follow from what the formula has
// returned: the direction of the flow, and the share θ of the trial deviator that the flow leaves.
void set_tangent(ElementFlow& f, const FlowRule::Flowed& flowed, const Matrix3d& plastic,
                 const Matrix3d& trial)
{
    const Matrix3d flow = deviatoric(flowed.asked - plastic), shear = deviatoric(trial);
    if (flow.isZero(0) || shear.isZero(0)) return;
    const double theta = std::min((shear - flow).norm() / shear.norm(), 1.0);
    f.softened = flowed.share * (1 - theta);
    f.along = std::sqrt(flowed.share * theta) * flow / flow.norm();
    if (flowed.share == 1) return;
    f.kept = deviatoric(flowed.asked);
    f.kept /= f.kept.norm();
    f.along -= product(f.kept, f.along) * f.kept;
}

} // namespace

// The stress that a flow takes away: C Δε_p, with the elastic stiffness C.
Matrix3d FlowInStep::relaxed_stress(const Matrix3d& flow) const
{
    return 2 * G_ * flow + lambda_ * flow.trace() * Matrix3d::Identity();
}

void FlowInStep::start(const Deformable& solid, const ElementWorkspace& work,
                       const Settings& settings, double time_step)
{
    solid_ = &solid;
    work_ = &work;
    rule_.emplace(solid, settings);
    time_step_ = time_step;
    lambda_ = solid.material.lame_lambda();
    G_ = solid.material.shear_modulus();
    flows_.clear();
    is_first_ = true;
}

// The strain that an element gains within the step, d = h sym(Rᵀ Σ vᵢ ∇Nᵢᵀ).
Matrix3d FlowInStep::strain_in_step(int e, const std::vector<Vector3d>& velocities) const
{
    const auto nodes = work_->elements.nodes(e);
    const auto gradients = work_->elements.gradients(e);
    Matrix3d L = Matrix3d::Zero();
    for (int i = 0; i < 4; ++i)
        L += velocities[nodes[i]] * gradients[i].transpose();
    const Matrix3d A = work_->strains[e].R.transpose() * L;
    return 0.5 * time_step_ * (A + A.transpose());
}

// Makes `next_`, the flow linearized about these velocities. Adds to `changed_` the elements for
// which the flow differs from that of the latest solve, `flows_`.
void FlowInStep::linearise(const std::vector<Vector3d>& velocities)
{
    next_.clear();
    slope_beyond_ = 0;
    auto latest = flows_.begin();
    for (int e = 0; e < work_->elements.size(); ++e) {
        const ElementFlow* solved =
            latest != flows_.end() && latest->element == e ? &*latest++ : nullptr;
        const Matrix3d d = strain_in_step(e, velocities), trial = work_->strains[e].elastic + d;
        const Matrix3d& plastic = solid_->plastic_strains[e];
        const FlowRule::Flowed flowed = rule_->flowed(plastic, trial);
        if (!flowed.flows && !solved) continue;
        const Matrix3d relaxed =
            flowed.flows ? relaxed_stress(flowed.plastic_strain - plastic) : Matrix3d::Zero();
        Matrix3d error = -relaxed; // the error of the stress that the solve has assumed
        if (solved) error += solved->stress + softening(*solved, G_, d);
        note_error(e, error, trial, d, solved);
        if (!flowed.flows) continue;
        ElementFlow f;
        f.element = e;
        f.strain = d;
        set_tangent(f, flowed, plastic, trial);
        f.stress = relaxed - softening(f, G_, d);
        next_.push_back(f);
    }
}

void FlowInStep::note_error(int e, const Matrix3d& error, const Matrix3d& trial, const Matrix3d& d,
                            const ElementFlow* solved)
{
    const double most_error =
        flow_tolerance * solid_->material.yield_stress + rounding * 2 * G_ * trial.norm();
    if (error.norm() > most_error) changed_.push_back(e);
    if (is_first_) return;
    const Matrix3d before = solved ? solved->strain : strain_in_step(e, guess_);
    slope_beyond_ += work_->elements.volume(e) * product(error, d - before);
}

// Goes back towards the guess if the velocities of the latest solve lie too far beyond the minimum.
// Let p be the way from the guess to these velocities, and A the matrix of the latest solve. Along
// p, the function that the step minimizes has the slope -pᵀ A p at the guess (`slope` is pᵀ A p)
// and the slope `slope_beyond_` at these velocities.
// @return whether it went back
bool FlowInStep::backtrack(VelocitySystem& s)
{
    if (is_first_ || slope_beyond_ <= 0) return false;
    way_.resize(guess_.size());
    for (std::size_t i = 0; i < guess_.size(); ++i)
        way_[i] = s.velocities[i] - guess_[i];
    const double slope = s.system.matrix().quadratic_form(way_);
    if (slope_beyond_ <= largest_turn * slope) return false;
    const double part = slope / (slope + slope_beyond_);
    for (std::size_t i = 0; i < guess_.size(); ++i)
        s.velocities[i] = guess_[i] + part * way_[i];
    return true;
}

bool FlowInStep::revise(VelocitySystem& s)
{
    changed_.clear();
    linearise(s.velocities);
    if (changed_.empty()) return false;
    if (backtrack(s)) linearise(s.velocities);
    flows_.swap(next_);
    apply(s);
    guess_ = s.velocities;
    is_first_ = false;
    return true;
}

void FlowInStep::apply(VelocitySystem& s)
{
    if (is_first_) elastic_momenta_ = s.momenta;
    s.momenta = elastic_momenta_;
    const double h = time_step_;
    s.assemble_matrix(*solid_, *work_, h);
    for (const ElementFlow& f : flows_) {
        const ElementStrain& strain = work_->strains[f.element];
        s.system.soften(work_->elements, strain.R, f, h * h * 2 * G_);
        const auto nodes = work_->elements.nodes(f.element);
        const auto gradients = work_->elements.gradients(f.element);
        const Matrix3d hVRP = h * work_->elements.volume(f.element) * strain.R * f.stress;
        for (int i = 0; i < 4; ++i)
            s.momenta[nodes[i]] += hVRP * gradients[i];
    }
}

} // namespace rigor
