#pragma once

#include <cstddef>

#include "rubsweep/core/contact/contact_mode.hpp"
#include "rubsweep/core/contact/wall.hpp"
#include "rubsweep/core/integrate/exact/exact_motion.hpp"
#include "rubsweep/core/integrate/exact/modes/joint_mode.hpp"
#include "rubsweep/core/integrate/exact/slip_watch.hpp"
#include "rubsweep/core/integrate/run/turn_book.hpp"

namespace rubsweep::integrate::exact {

/// Joint mode after the crossing of guard `e` of the motion's mode, at its state `here`. Other contacts
/// change their modes together with it where the state requires it; annular stops are open. The slip of a
/// contact keeps its direction as long as it touches.
template <int N>
std::size_t joint_mode_behind(const ExactMotion<N>& motion, const SlipWatch<N>& slip, std::size_t e,
                              const typename ExactMotion<N>::State& here) {
  const auto& mode = motion.mode();
  const auto& contacts = motion.machine().system().contacts;
  std::size_t joint = 0;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const auto& c = contacts[i];
    const contact::Mode from = mode.modes[i];
    contact::Mode to = from;
    if (contact::linear(c.wall)) {
      const auto kinematics = modes::kinematics_of(c, here, motion.closing_acceleration(i, here));
      if (mode.guards[e].contact == i) to = contact::mode_through(from, mode.guards[e].next, kinematics);
      to = contact::mode_after(to, c.stiffness, c.damping, kinematics);
    }
    if (to == contact::Mode::open) continue;
    const std::size_t backward = modes::backward_in_joint_mode(i, contacts.size());
    const bool goes_backward = from != contact::Mode::open ? (motion.joint() & backward) != 0
                                                           : slip.goes_backward(motion.machine(), i, here);
    joint += modes::in_joint_mode(to, i) + (goes_backward ? backward : 0);
  }
  return joint;
}

/// Reports the mode switches of all contacts between two joint modes, at this phase.
inline void note_switches(std::size_t from, std::size_t to, std::size_t contacts, double phase_rad,
                          run::TurnBook& book, run::TurnReport& report) {
  for (std::size_t i = 0; i < contacts; ++i) {
    const contact::Mode before = modes::mode_in_joint_mode(from, i), after = modes::mode_in_joint_mode(to, i);
    if (after != before) book.note_switch({phase_rad, static_cast<int>(i), before, after}, report);
  }
}

}  // namespace rubsweep::integrate::exact
