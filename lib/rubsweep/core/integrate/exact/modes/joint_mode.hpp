#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "rubsweep/core/contact/contact_mode.hpp"
#include "rubsweep/core/contact/wall.hpp"

namespace rubsweep::integrate::exact::modes {

/// Contribution of contact `i` to the number of a joint mode. This number holds the mode of each contact, two
/// bits each, and above them one bit per contact for a backward slip.
constexpr std::size_t in_joint_mode(contact::Mode mode, std::size_t i) {
  return static_cast<std::size_t>(mode) << (2 * i);
}

/// Bit for a backward slip of contact `i` out of `contacts`.
constexpr std::size_t backward_in_joint_mode(std::size_t i, std::size_t contacts) {
  return std::size_t{1} << (2 * contacts + i);
}

/// Number of the joint mode of these contact modes with all slips forward.
inline std::size_t joint_mode_of(const std::vector<contact::Mode>& modes) {
  std::size_t joint = 0;
  for (std::size_t i = 0; i < modes.size(); ++i) joint += in_joint_mode(modes[i], i);
  return joint;
}

/// Number of a joint mode without the directions of slips.
constexpr std::size_t modes_of_joint_mode(std::size_t joint, std::size_t contacts) {
  return joint & ((std::size_t{1} << 2 * contacts) - 1);
}

/// Mode of contact `i`.
constexpr contact::Mode mode_in_joint_mode(std::size_t joint, std::size_t i) {
  return static_cast<contact::Mode>((joint >> 2 * i) % contact::mode_count);
}

/// Kinematics of a flat scaled contact at (u, u').
template <class Contact, class State>
contact::Kinematics kinematics_of(const Contact& contact, const State& physical,
                                  double closing_acceleration) {
  const Eigen::Index n = contact.first_row.size();
  return {contact.first_row.dot(physical.head(n).transpose()) - contact.clearance,
          contact.first_row.dot(physical.tail(n).transpose()), closing_acceleration};
}

/// Joint mode of a state, with annular stops open. `rate` is the rate without contact: a contact exactly at a
/// wall that moves into it is in contact from the first instant.
template <class Contact, class State>
std::size_t joint_mode_of(const std::vector<Contact>& contacts, const State& physical, const State& rate) {
  std::size_t joint = 0;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const Contact& c = contacts[i];
    if (!contact::linear(c.wall)) continue;
    const contact::Kinematics k =
        kinematics_of(c, physical, c.first_row.dot(rate.tail(c.first_row.size()).transpose()));
    const contact::Mode now = contact::mode_of(c.stiffness, c.damping, k.penetration, k.closing_speed);
    joint += in_joint_mode(contact::mode_after(now, c.stiffness, c.damping, k), i);
  }
  return joint;
}

}  // namespace rubsweep::integrate::exact::modes
