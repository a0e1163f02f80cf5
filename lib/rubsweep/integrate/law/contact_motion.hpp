#pragma once

#include <Eigen/Core>

#include "rubsweep/contact/wall.hpp"
#include "rubsweep/integrate/run/scaled_system.hpp"

namespace rubsweep::integrate::law {

/// The motion of the rotor against the casing at one contact, from the coordinates `u` and their rates `v`.
template <int N>
contact::RelativeMotion relative_motion(const run::ScaledContact<N>& c,
                                        const Eigen::Map<const Eigen::Matrix<double, N, 1>>& u,
                                        const Eigen::Map<const Eigen::Matrix<double, N, 1>>& v) {
  return {c.first_row.dot(u.transpose()) + c.offset[0], c.second_row.dot(u.transpose()) + c.offset[1],
          c.first_row.dot(v.transpose()), c.second_row.dot(v.transpose())};
}

/// The same as it is seen from the wall.
template <int N>
contact::ContactFrame contact_frame(const run::ScaledContact<N>& c,
                                    const Eigen::Map<const Eigen::Matrix<double, N, 1>>& u,
                                    const Eigen::Map<const Eigen::Matrix<double, N, 1>>& v) {
  return contact::frame(c.wall, relative_motion(c, u, v), c.clearance);
}

template <int N>
double slip_m_per_s(const run::ScaledContact<N>& c, const contact::ContactFrame& f) {
  return c.slip_scale_m_per_s * f.sliding_speed + c.surface_speed_m_per_s;
}

/// Row that gives the sliding speed from the rates of the coordinates.
template <int N>
Eigen::Matrix<double, 1, N> tangential_row(const run::ScaledContact<N>& c, const contact::ContactFrame& f) {
  return f.cosine * c.second_row - f.sine * c.first_row;
}

/// Scaled acceleration per newton of friction on the casing.
template <int N>
Eigen::Matrix<double, N, 1> tangential_push(const run::ScaledContact<N>& c, const contact::ContactFrame& f) {
  return f.cosine * c.second_push - f.sine * c.first_push;
}

}  // namespace rubsweep::integrate::law
