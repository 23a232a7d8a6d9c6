// SPDX-License-Identifier: MIT
// The time step of rigid bodies, in the order of Guendelman, Bridson and Fedkiw (2003, "Nonconvex
// rigid bodies with stacking", ACM Trans. Graph. 22). The stages are calls in step.cpp:
//
// stage                 reads                     writes               where
//   a single body       its state, gravity        its state, memory    step/single_body; then the
//                                                                      other stages are left out
//   bodies with forces  forces, drag              none                 motion/forces,
//                                                                      `pulled_bodies`,
//                                                                      `with_dragged_bodies`
//   wake up             forces, springs           sleeping bodies,     step/sleep, `wake_pulled`
//                                                 memory
// 1 free flight         states, forces            flown states         motion/free_flight
// 2 find contacts       states, flown states      contact candidates   detection/contact_candidates
//   broad phase         bounds, memory            pairs of bodies,     detection/broad_phase
//                                                 memory
//   margins, turn ahead flown states, masses,     margins, poses       `margins_of`, `turn_ahead`
//                       restitutions                                   in contact_candidates
//   narrow phase        shapes, poses, margins    candidates           detection/narrow_phase
//   wake up             candidates                sleeping bodies,     step/sleep, `wake`; if any
//                                                 memory               wakes, 1 and 2 run again
//   no candidates: the states after free flight are final, and the step ends here
//   make the problem    candidates                contacts,            contact/make_problem
//                                                 impulse matrices
//   islands             contacts                  contacts in islands  contact/islands
//   warm start          memory                    initial impulses     contact/warm_start
//   blocks              large islands             blocks, colors       contact/blocks
//   moving frames       drives                    velocities, frames   contact/driven_bodies
// 3 collisions          velocities before forces, velocities, impulses contact/collisions
//                       gaps
//   bounced flight      velocities, forces        flown states,        step/bounced_flight; for
//                                                 predicted gaps       bodies that bounced and that
//                                                                      springs or drag pull
// 4 velocities          flown states              velocities           step/velocity_update; 4 and
//                                                                      5 alternate: each island
//                                                                      does both
// 5 contact, friction   velocities, gaps          velocities, impulses contact/resting_contact
//   set drives          drives, velocities        velocities of drives contact/driven_bodies
//                       before forces
//   choose contacts     gaps, impulse matrices    target speeds        contact/active_contacts
//   load estimate       weights (no warm start)   initial impulses     contact/load_estimate
//   solve               initial impulses          velocities, impulses contact/solvers/
//   friction step check forces, impulses          none                 step/supported_flight; if
//                                                                      forces are too fast for
//                                                                      friction, the whole step
//                                                                      runs again in two halves
//   supported flight    forces, impulses          flown states,        step/supported_flight; for
//                                                 velocities, impulses bodies that contacts hold
//                                                                      and springs or drag pull
//   solve again         contacts in mid-step      velocities, impulses step/mean_velocity,
//                                                 contacts             step/midpoint/
// 6 position correction gaps, velocities          displacements        contact/position_correction
//   leave unheld frames impulses, frames          velocities           contact/driven_bodies
// 7 positions           velocities, displacements states               step/position_update
//   leave frames        frames                    velocities           contact/driven_bodies
// 8 refine              states, contacts, memory  states, records,     step/impact,
//                                                 impulses (to 0)      step/substeps/
//   missed contacts     flown states, states,     none                 step/missed_contacts; if
//                       margins                                        there is one, the whole step
//                                                                      runs again in two parts
//   collect contacts    impulses                  records, the next    step/step_result
//                                                 warm contacts
// 9 sleep               states, islands           states, memory, the  step/sleep
//                                                 next warm contacts
//   finish the step     states, records, memory,  world (also `rest`   step/step_result
//                       the next warm contacts  of bodies), memory
//
// "Memory" is what the world keeps for its next step (`StepMemory` in bodies/step_memory.hpp). A
// "record" is a contact with its impulse, for the trajectory (`ContactRecord`).
//
// Friction has no file of its own, because the normal and the friction part of an impulse are found
// together. `sweeps_of` in contact/solvers/island_solver chooses the law of stage 5:
//
// contact method        with the reference                 with any other implementation
// default (`built_in`)  `contact_law` in optimised_sweeps  the formula `collision_impulse`, which
//                                                          collision_law_sweeps calls
// simultaneous          the same `contact_law`             the formula `resolve_simultaneously`,
//                                                          which simultaneous_sweeps calls
//
// Where these sweeps do not converge, Newton's method may continue (island_solver.hpp lists when),
// with its own law (`projected` in newton_row). If a scene turns the optimization
// `optimised_formulas` off, the reference is treated as any other implementation. The contact
// methods `one_at_a_time` and `shock_propagation` always call formulas of topic `contact`, from
// contact/solvers/one_at_a_time. Stage 3 calls `collision_impulse` with any implementation and any
// contact method, but under `simultaneous` it leaves contacts with ε = 0 to stage 5. The impulses
// from which sweeps start are put into the friction cone where they are made: in contact/warm_start
// and contact/load_estimate.
//
// In a world with deformable solids, deformable/step/step.cpp moves the solids first and then calls
// this step. Their nodes have friction and position correction of their own: `collide_nodes`,
// `push_by_held_nodes` (whose friction limits the impulse of nodes that handles hold) and
// `correct_node_positions` in deformable/contact/node_collisions, and the law of friction of the
// implicit step in deformable/motion/contact_set.
//
// Papers of the stages, by the numbers above (7 to 9 have no paper):
//
// 1 Jacobi (1849), van Zon and Schofield (2007)      motion/free_rotation
//   Buss (2000)                                      motion/constant_wrench_step
//   Blanes and Moan (2002), Munthe-Kaas (1999)       motion/free_flight
// 2 Verlet (1967)                                    the pair cache, bodies/pair_cache
//   Gottschalk, Lin and Manocha (1996)               boxes, detection/shapes/box_box
//   Guendelman, Bridson and Fedkiw (2003)            level sets, detection/shapes/mesh_contact
// 3 Guendelman, Bridson and Fedkiw (2003)            contact/collisions
// 5 Guendelman, Bridson and Fedkiw (2003)            contact/solvers/one_at_a_time
//   Jean (1999), Erleben (2007)                      sweeps, contact/solvers/optimised_sweeps
//   Silcowitz-Hansen, Niebe and Erleben (2010)       their acceleration, contact/solvers/run_sweeps
//   Alart and Curnier (1991)                         contact/solvers/newton_contact
//   Moreau (1999)                                    solve again, step/midpoint/midpoint_contact
//   Baumgarte (1972), only without gravity           `correction_speed`, which `activate_contacts`
//                                                    calls; contact/position_correction
// 6 Catto (2014)                                     contact/position_correction
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
/// @throws std::out_of_range if a formula returned an index or a list that does not fit its
///         arguments
std::vector<ContactRecord> step(World& world, double time_step);

} // namespace rigor
