// SPDX-License-Identifier: MIT
// Free flight: how bodies move between contacts, by the world's integrator.
//
// The default integrator, `runge_kutta`, has three ways of fourth order. A body that only gravity acts on
// takes gravity_flight.hpp's.
//
// Bodies that springs or applied forces pull at take kicks and free flights in turns, the symplectic
// Runge–Kutta–Nyström method SRKN6b of Blanes and Moan (2002, "Practical symplectic partitioned
// Runge–Kutta and Runge–Kutta–Nyström methods", J. Comput. Appl. Math. 142):
//
//     kick by bᵢ: V += bᵢ h F/M, L += bᵢ h τ     flight by aᵢ: as gravity_flight.hpp, without a wrench, aᵢ h
//     b₁ a₁ b₂ a₂ b₃ a₃ b₄ a₃ b₃ a₂ b₂ a₁ b₁
//
// On a pendulum it is as accurate as Runge–Kutta 4 with steps a sixth as long, it keeps the energy for any
// number of swings, and on a spring it is stable up to √(k/M) h = 5, where Runge–Kutta 4 ends at 2.8. It
// takes forces that depend on places alone. If any spring damps, all of them take the Runge–Kutta
// method of Munthe-Kaas (1999, "High order Runge–Kutta methods on manifolds", Appl. Numer. Math. 29)
// with the two commutators of Munthe-Kaas and Owren (1999, "Computations in a free Lie algebra",
// Phil. Trans. R. Soc. A 357): the orientation only ever changes by `advance_exact`, so it stays a
// rotation, and a steady spin is exact. With ωᵢ at stage i and exp(u) = advance_exact(q, u, h):
//
//     stage 2 at exp(½ω₁)   stage 3 at exp(½ω₂ - ⅛h ω₁×ω₂)   stage 4 at exp(ω₃)
//     q' = exp((ω₁ + 2ω₂ + 2ω₃ + ω₄)/6 - h/12 ω₁×ω₄)
//
// X, V, L take the classical Runge–Kutta 4 with the same stages.
#pragma once

#include "rigid/team.hpp"
#include "rigid/world.hpp"

namespace rigor {

/// Rotation matrix of a body: by `to_matrix`, but by Eigen for the integrator `matrix`, whose
/// assignment comes first.
Matrix3d body_rotation(Integrator integrator, const RigidState& state);

/// I(t)⁻¹ = R I_body⁻¹ Rᵀ by `world_inverse_inertia`; an isotropic body's needs no R.
Matrix3d inverse_inertia(Integrator integrator, const RigidBody& body, const RigidState& state);

/// The state of one body that gravity alone acts on, after a time step; without gravity if `drifts`.
///
/// A body that would turn by more than a quarter turn takes equal substeps that do not
/// (`max_time_step`). Those do not: an isotropic body with an integrator that turns it exactly, a
/// symmetric one with the default, and the integrator `matrix`, which comes before that formula.
RigidState fly(const World& world, const RigidBody& body, RigidState state, double time_step,
               Counters& counters, bool drifts = false);

/// Calls work(first, last, counters) for stretches of [0, count), shared by the team. What it counts of flights
/// is added up.
template <class Work>
void share_flights(Team& team, std::size_t count, Counters& counters, const Work& work)
{
    constexpr std::size_t worth_sharing = 64; // bodies
    const int stretches = team.stretches_of(count, worth_sharing);
    if (stretches < 2) return work(std::size_t{0}, count, counters);
    std::vector<Counters> counted(stretches);
    team.share(stretches, [&](int k) {
        const auto [first, last] = Team::stretch(count, stretches, k);
        work(first, last, counted[k]);
    });
    for (const Counters& part : counted) {
        counters.free_flights += part.free_flights;
        counters.substeps += part.substeps;
        counters.isotropic_shortcuts += part.isotropic_shortcuts;
    }
}

/// The states of all bodies after a time step without contacts: bodies that springs or applied
/// forces pull at fly together, all the others one by one. Static bodies stay.
///
/// @param pulled  see `pulled_bodies`
std::vector<RigidState> fly_all(const World& world, const std::vector<bool>& pulled,
                                double time_step, Counters& counters, Team& team);

} // namespace rigor
