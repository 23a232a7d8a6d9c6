// SPDX-License-Identifier: MIT
// Free flight: how bodies move between contacts, by the world's integrator.
//
// The default integrator, `exact`, is exact for a body on which only gravity acts: the center of
// mass moves on a parabola, and the body rotates as the free rotor of free_rotation.hpp. All other
// bodies take `runge_kutta`.
//
// The integrator `runge_kutta` has three methods of fourth order. "Pulled" bodies are those on
// which springs, applied forces or drag act:
//
//   1. A body that gravity alone acts on, or that contacts hold, takes the method of
//      constant_wrench_step.hpp.
//   2. Pulled bodies take SRKN6b, if no force depends on velocities.
//   3. If any spring damps or a medium brakes a body, all pulled bodies take the method of
//      Munthe-Kaas.
//
// Methods 2 and 3 advance all pulled bodies together, in equal substeps of length h. The substeps
// are so short that two conditions hold. Each of these bodies, unless it is isotropic, rotates by
// at most a quarter turn in a substep (but there are never more than 1000 substeps). And
// `fastest_force_rate` times h is at most 0.5. The integrators other than `exact` and `runge_kutta`
// do not divide the step for forces, so that students can watch where springs make these
// integrators unstable.
//
// SRKN6b, in which kicks (impulses) and free flights alternate, is a symplectic
// Runge–Kutta–Nyström method of Blanes and Moan (2002, "Practical symplectic partitioned
// Runge–Kutta and Runge–Kutta–Nyström methods", J. Comput. Appl. Math. 142).
//
//     kick by bᵢ:    V += bᵢ h F/M,  L += bᵢ h τ
//     flight by aᵢ:  a free flight without forces and torques over the time aᵢ h
//     order:         b₁ a₁ b₂ a₂ b₃ a₃ b₄ a₃ b₃ a₂ b₂ a₁ b₁
//
// On a pendulum, SRKN6b is as accurate as Runge–Kutta 4 with steps a sixth as long, and its energy
// does not drift with the number of swings. On a spring, SRKN6b is stable up to √(k/M) h = 5,
// Runge–Kutta 4 only up to 2.8.
//
// Method 3 is the Runge–Kutta method of Munthe-Kaas (1999, "High order Runge–Kutta methods on
// manifolds", Appl. Numer. Math. 29) with the two commutators of Munthe-Kaas and Owren (1999,
// "Computations in a free Lie algebra", Phil. Trans. R. Soc. A 357). The orientation changes by
// `advance_exact` alone, so it stays a rotation, and a steady spin is exact. With ωᵢ at stage i and
// exp(u) = advance_exact(q, u, h):
//
//     stage 2 at exp(½ω₁)   stage 3 at exp(½ω₂ - ⅛h ω₁×ω₂)   stage 4 at exp(ω₃)
//     q' = exp((ω₁ + 2ω₂ + 2ω₃ + ω₄)/6 - h/12 ω₁×ω₄)
//
// X, V, L take the classical Runge–Kutta 4 with the same stages.
#pragma once

#include "rigid/bodies/world.hpp"

namespace rigor {

enum class Gravity { acts, left_out };

/// The state of one body after a time step in which gravity alone or nothing acts on it.
///
/// If a body would rotate by more than a quarter turn, the step is divided into equal substeps in
/// which it rotates by at most a quarter turn (`max_time_step`), but into at most 1000. Four
/// kinds of flight are never divided:
///
///   1. any body by `exact`
///   2. an isotropic body by any integrator but `linear`
///   3. a body of revolution by `runge_kutta`
///   4. any body by `matrix`, because assignment A1 uses `matrix` and `max_time_step` belongs to A3
///
/// @param gravity  `left_out` for a body that contacts hold, whose velocity already contains the
///                 effect of gravity. Such a body moves by `Settings::integrator_under_forces`, so
///                 never by `exact`.
RigidState fly(const Settings& settings, const RigidBody& body, RigidState state, double time_step,
               Counters& counters, Gravity gravity = Gravity::acts);

/// The distance by which gravity moves a body in a step h of free flight without substeps, divided
/// by h² |g|. It is ½ on a parabola. It is 1 by symplectic Euler, which moves the body with its
/// velocity at the end of the step.
double fall_in_step(Integrator integrator);

/// Calls work(first, last, counted) for ranges that cover [0, count), shared by the threads of the
/// pool. Each call counts in its own `counted`, and the sums are added to `counters`.
template <class Work>
void fly_in_parallel(ThreadPool& pool, std::size_t count, Counters& counters, const Work& work)
{
    constexpr std::size_t grain_size = 64; // least number of bodies in one parallel task
    const int ranges = pool.range_count(count, grain_size);
    if (ranges < 2) return work(std::size_t{0}, count, counters);
    std::vector<Counters> counted(ranges);
    pool.for_each_task(ranges, [&](int k) {
        const auto [first, last] = ThreadPool::range(count, ranges, k);
        work(first, last, counted[k]);
    });
    for (const Counters& part : counted)
        counters += part;
}

/// The states of all bodies after a time step without contacts. Bodies that are `pulled` are
/// integrated together, all others one by one. Sleeping bodies keep their state, and so do static
/// ones unless a drive moves or turns them. In the world, only the counters change.
///
/// @param pulled    for each body, whether springs, applied forces, drag (`with_dragged_bodies`)
///                  or a wrench of `supports` act on it
/// @param supports  for each body, the constant wrench of the contacts that hold it; may be empty
std::vector<RigidState> fly_all(World& world, const std::vector<bool>& pulled, double time_step,
                                ThreadPool& pool, std::span<const Wrench> supports = {});

/// Whether an integrator computes forces several times in a step, along the path of the body. One
/// that does so only once (symplectic Euler) makes no error by a path that contacts change.
bool computes_forces_in_stages(Integrator integrator_under_forces);

} // namespace rigor
