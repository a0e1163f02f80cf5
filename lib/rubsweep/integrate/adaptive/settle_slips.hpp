#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "rubsweep/contact/dry_friction.hpp"
#include "rubsweep/integrate/adaptive/dynamics.hpp"

namespace rubsweep::integrate::adaptive {

/// A slip nearer to zero than this share of the surface's own speed (or of one clearance a radian) is zero:
/// rounding leaves less, and what it leaves friction would stop within as many radians.
inline constexpr double no_slip = 1e-12;

template <class Law, class State>
bool stands(const Law& law, std::size_t i, const State& state) {
  const auto& c = law.system().contacts[i];
  const double surface = c.surface_speed_m_per_s / c.slip_scale_m_per_s;
  return std::abs(law.slip(i, state)) <= no_slip * std::max(1.0, std::abs(surface));
}

/// Settles what those contacts do whose slip is zero: the ones that stick, those that stand, and those that
/// `besides` says.
/// `rate` is room for a rate of the state.
template <class Law, class State, class Besides>
void settle_slips(Law& law, const State& state, State& rate, double phase, const Besides& besides) {
  typename Law::Stuck standing;
  for (std::size_t i = 0; i < law.slips().size() && standing.count < standing.list.size(); ++i) {
    if (!law.touches_dry(i)) continue;
    if (law.slips()[i] != contact::Slip::sticking && !besides(i) && !stands(law, i, state)) continue;
    law.slips()[i] = contact::Slip::sticking;
    standing.list[standing.count++] = i;
  }
  if (standing.count == 0) return;
  law.loose(state, rate, phase);
  contact::StickVector limit(static_cast<Eigen::Index>(standing.count)), force;
  for (std::size_t k = 0; k < standing.count; ++k)
    limit(static_cast<Eigen::Index>(k)) = std::max(0.0, law.largest_friction_n(standing.list[k], state));
  std::array<contact::Slip, contact::most_sticking> slips{};
  const contact::StickMobility mobility = law.mobility(standing, state);
  contact::settle_slips(mobility, law.accelerations(standing, state, rate), limit, slips.data(), force);
  for (std::size_t k = 0; k < standing.count; ++k) law.slips()[standing.list[k]] = slips[k];
  if (standing.count > 1 && law.stuck_contacts().count > 0 && !contact::determined(mobility))
    law.leave_undetermined(true);
}

/// Which way contact `i` slips by the state alone; what stands is left to `settle_slips`.
template <class Law, class State>
void take_slip_of_state(Law& law, std::size_t i, const State& state) {
  law.slips()[i] = stands(law, i, state)    ? contact::Slip::sticking
                   : law.slip(i, state) > 0 ? contact::Slip::forward
                                            : contact::Slip::backward;
}

/// All of them.
template <class Law, class State>
void enter_slips_by_state(Law& law, const State& state, State& rate, double phase) {
  if (!law.any_dry()) return;
  law.leave_undetermined(false);
  for (std::size_t i = 0; i < law.slips().size(); ++i) {
    if (law.touches_dry(i)) take_slip_of_state(law, i, state);
  }
  settle_slips(law, state, rate, phase, [](std::size_t) { return false; });
}

/// A small change of a state, one a column, across the instant at which `rate` becomes another one because
/// the slip of contact `i` has come to zero (Leine & Nijmeijer, Dynamics and Bifurcations of Non-Smooth
/// Mechanical Systems, eq. 7.46: the saltation matrix). Where it sticks, no change lets it slip.
template <class Law, class State, class Changes>
void cross_slip(const Law& law, std::size_t i, const State& state, const State& rate_before,
                const State& rate_after, Changes&& changes) {
  const Eigen::RowVectorXd gradient = law.slip_gradient(i, state);
  const Eigen::Map<const Eigen::VectorXd> before(&rate_before[0], gradient.size()),
      after(&rate_after[0], gradient.size());
  const double way = law.slip_rate(i, state, rate_before);
  if (way == 0) return;
  for (Eigen::Index column = 0; column < changes.cols(); ++column) {
    const double share = gradient.dot(changes.col(column)) / way;
    changes.col(column) += (after - before) * share;
  }
}

}  // namespace rubsweep::integrate::adaptive
