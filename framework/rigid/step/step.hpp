// SPDX-License-Identifier: MIT
// The time step of rigid bodies, in the order of Guendelman, Bridson and Fedkiw (2003, "Nonconvex
// rigid bodies with stacking", ACM Trans. Graph. 22). Each stage is a call or two in step.cpp:
//
// stage                 reads                     writes               where
//   a single body       its state, gravity        its state            step/single_body; then the
//                                                                      other stages are left out
//   wake up             forces, springs           sleeping bodies      step/sleep, `wake_pulled`
//   bodies with forces  forces, drag              none                 motion/forces,
//                                                                      `pulled_bodies`,
//                                                                      `with_dragged_bodies`
// 1 free flight         states, forces            flown states         motion/free_flight
// 2 find contacts       states, flown states      contact candidates   detection/contact_candidates
//   broad, narrow phase bounds, then shapes       pairs, then points   detection/broad_phase,
//                                                                      detection/narrow_phase
//   wake up             candidates                sleeping bodies      step/sleep, `wake`; if any
//                                                                      wakes, 1 and 2 run again
//   no candidates: the states after free flight are final, and the step ends here
//   make the problem    candidates                contacts in islands  contact/make_problem
//   warm start          memory                    initial impulses     contact/warm_start
// 3 collisions          velocities before forces  velocities           contact/collisions
// 4 velocities          flown states              velocities           step/step, `apply_forces`
// 5 contact, friction   velocities, gaps          velocities, impulses contact/resting_contact
//   choose contacts     gaps, impulse matrices    target speeds        contact/active_contacts
//   load estimate       weights (no warm start)   initial impulses     contact/load_estimate
//   solve               initial impulses          velocities, impulses contact/solvers/ or
//                                                                      contact/one_at_a_time
//   solve again         contacts in the middle     velocities, impulses step/mean_velocity,
//                       of the step                                     step/midpoint_contact
// 6 position correction gaps, velocities          displacements        contact/position_correction
// 7 positions           velocities, displacements states               step/position_update
// 8 refine              states, contacts          states, records      step/impact,
//                                                                      step/adaptive_substeps
//   collect contacts    impulses                  records, memory      step/step_result
// 9 sleep               states, islands           memory, states       step/sleep
//   finish the step     states, records           world                step/step_result
//
// "Memory" is what the world keeps for its next step (`StepMemory` in bodies/step_memory.hpp). A
// "record" is a contact with its impulse, for the trajectory (`ContactRecord`).
//
// The normal and the friction part of an impulse are found together, so friction has no separate
// file. The law of friction is in contact/solvers/: `contact_law` in optimised_sweeps and `correct`
// in collision_law_sweeps for one contact, `projected` in newton_row for Newton's method;
// simultaneous_sweeps and contact/one_at_a_time call the formulas of topic `contact`. Stage 3 has
// friction in the formula `collision_impulse`. The nodes of deformable solids have friction too:
// deformable/contact/node_collisions calls `collision_impulse`, and deformable/motion/contact_set
// has the law of friction for the implicit step.
//
// Papers of the stages, by the numbers above: 1 Jacobi (1849) and van Zon and Schofield (2007), see
// free_rotation.hpp, Buss (2000), see constant_wrench_step.hpp, Blanes and Moan (2002) and
// Munthe-Kaas (1999), see free_flight.hpp; 2 Verlet (1967) for the pair cache, Gottschalk et al.
// (1996) for boxes, Guendelman et al. (2003) for level sets; 3 Guendelman et al.; 5 Guendelman et
// al., Jean (1999), Moreau (1999), Erleben (2007), Silcowitz-Hansen et al. (2010), Alart and
// Curnier (1991); 6 Catto (2009), and Baumgarte (1972) without gravity. Stages 7 to 9 were made for
// Rigor, this engine.
#pragma once

#include "rigid/bodies/world.hpp"

namespace rigor {

/// Advances a world by one time step. The result depends only on (world, time_step), since no state
/// is kept elsewhere. If warm start and sleep are turned off, the memory of the last step does not
/// influence the result.
///
/// @return the contacts that got an impulse, and those that hold sleeping bodies
/// @throws NonFiniteState if a state is infinite or not a number
/// @throws std::domain_error if a spring, damper, drag or force is too fast for the time step, or
///         if the formula `max_time_step` returned no time above 0
std::vector<ContactRecord> step(World& world, double time_step);

} // namespace rigor
