#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "rubsweep/core/contact/dry_friction.hpp"
#include "rubsweep/core/integrate/law/dynamics.hpp"

namespace rubsweep::integrate::law {

/// Zero band of the slip of a poised contact (compare contact::no_slip). A contact that leaves the band
/// against its friction is settled again.
inline constexpr double poised_slip = 1e-11;

template <class Law, class State>
bool stands(const Law& law, std::size_t i, const State& state) {
  const auto& c = law.system().contacts[i];
  const double surface = c.surface_speed_m_per_s / c.slip_scale_m_per_s;
  // A contact that is settled again may be slightly outside the band and become poised again.
  const double near = law.poised(i) ? 2 * poised_slip : contact::no_slip;
  return std::abs(law.slip(i, state)) <= near * std::max(1.0, std::abs(surface));
}

/// Lists the contacts with zero slip: contacts that stick, contacts within the zero band, and those selected
/// by `besides`, but not those excluded by `never`. None of them remains poised. False where there are too
/// many.
template <class Law, class State, class Besides, class Never>
bool find_standing(Law& law, const State& state, const Besides& besides, const Never& never,
                   typename Law::Stuck& standing) {
  for (std::size_t i = 0; i < law.slips().size(); ++i) {
    const bool takes_part =
        law.touches_dry(i) && !never(i) &&
        (law.slips()[i] == contact::Slip::sticking || besides(i) || stands(law, i, state));
    law.poise(i, false);
    if (!takes_part) continue;
    if (standing.count == standing.list.size()) return false;
    standing.list[standing.count++] = i;
  }
  return true;
}

/// Decides stick or slip for these contacts. `more`: an acceleration of their slips in addition to that by
/// all other forces.
template <class Law, class State>
void settle_standing(Law& law, const typename Law::Stuck& standing, const State& state, State& rate,
                     double phase, const contact::StickVector& more) {
  if (standing.count == 0) return;
  for (std::size_t k = 0; k < standing.count; ++k) law.slips()[standing.list[k]] = contact::Slip::sticking;
  law.loose(state, rate, phase);
  const auto size = static_cast<Eigen::Index>(standing.count);
  contact::StickVector limit(size), sliding(size);
  for (std::size_t k = 0; k < standing.count; ++k) {
    limit(static_cast<Eigen::Index>(k)) = std::max(0.0, law.largest_friction_n(standing.list[k], state));
    sliding(static_cast<Eigen::Index>(k)) = std::max(0.0, law.sliding_friction_n(standing.list[k], state));
  }
  const contact::StickVector acceleration = law.accelerations(standing, state, rate);
  const contact::SettledSlips settled =
      contact::settle_slips(law.mobility(standing, state), acceleration, more, limit, sliding);
  if (!settled.obeys_law) law.leave_unsettled(true);
  for (std::size_t k = 0; k < standing.count; ++k) {
    law.slips()[standing.list[k]] = settled.slips[k];
    law.poise(standing.list[k], settled.poised[k]);
  }
}

/// Decides stick or slip for all contacts with zero slip: contacts that stick, contacts within the zero band,
/// and those selected by `besides`. `rate` is scratch for a rate of the state.
template <class Law, class State, class Besides>
void settle_slips(Law& law, const State& state, State& rate, double phase, const Besides& besides) {
  typename Law::Stuck standing;
  const auto none = [](std::size_t) { return false; };
  if (!find_standing(law, state, besides, none, standing)) return law.leave_unsettled(true);
  const auto count = static_cast<Eigen::Index>(standing.count);
  settle_standing(law, standing, state, rate, phase, contact::StickVector::Zero(count));
}

/// Releases the sticking contact `i`, whose friction has reached its limit in the direction of `slip`. Poised
/// contacts may have to take over its load. They are settled again for a slightly larger load: the part that
/// `i` can no longer take. All frictions are continuous unless that of `i` drops as soon as it slips. In that
/// case all contacts are settled, because others may be unable to take over. Returns true where contacts were
/// settled. `rate` is scratch.
template <class Law, class State>
bool let_go(Law& law, std::size_t i, contact::Slip slip, const State& state, State& rate, double phase) {
  constexpr double little = 1e-9;  // share of the limit: above rounding of the forces
  const double asked_n = contact::sign_of(slip) * little * law.largest_friction_n(i, state);
  const bool all = law.jumps(i);
  if (!all) law.slips()[i] = slip;
  if (!all && !law.any_poised()) return false;
  typename Law::Stuck standing;
  const auto none = [](std::size_t) { return false; };
  const auto given = [&](std::size_t j) { return j == i && !all; };
  if (!find_standing(law, state, none, given, standing) || (!all && standing.count == standing.list.size())) {
    law.leave_unsettled(true);
    return true;
  }
  typename Law::Stuck with_i = standing;
  if (!all) with_i.list[with_i.count++] = i;
  const auto count = static_cast<Eigen::Index>(standing.count);
  const Eigen::Index at = std::ranges::find(with_i.list, i) - with_i.list.begin();
  const contact::StickVector more = law.mobility(with_i, state).col(at).head(count) * asked_n;
  settle_standing(law, standing, state, rate, phase, more);
  if (!all) law.poise(i, law.stuck_contacts().count > 0);
  return true;
}

/// Sets the slip direction of contact `i` from the state; zero slips are left to `settle_slips`.
template <class Law, class State>
void take_slip_of_state(Law& law, std::size_t i, const State& state) {
  law.slips()[i] = stands(law, i, state)    ? contact::Slip::sticking
                   : law.slip(i, state) > 0 ? contact::Slip::forward
                                            : contact::Slip::backward;
}

/// Sets the slip states of all contacts from the state.
template <class Law, class State>
void enter_slips_by_state(Law& law, const State& state, State& rate, double phase) {
  if (!law.any_dry()) return;
  law.leave_unsettled(false);
  for (std::size_t i = 0; i < law.slips().size(); ++i) {
    law.poise(i, false);
    if (law.touches_dry(i)) take_slip_of_state(law, i, state);
  }
  settle_slips(law, state, rate, phase, [](std::size_t) { return false; });
}

/// Saltation matrix applied to small changes of a state, one per column, at an instant where an event
/// function reaches zero and `rate` jumps. `gradient`: derivative of the event function by the state; `way`:
/// its rate (Leine & Nijmeijer, Dynamics and Bifurcations of Non-Smooth Mechanical Systems, eq. 7.46).
template <class State, class Changes>
void cross(const Eigen::RowVectorXd& gradient, double way, const State& rate_before, const State& rate_after,
           Changes&& changes) {
  const Eigen::Map<const Eigen::VectorXd> before(&rate_before[0], gradient.size()),
      after(&rate_after[0], gradient.size());
  if (way == 0) return;
  for (Eigen::Index column = 0; column < changes.cols(); ++column) {
    const double share = gradient.dot(changes.col(column)) / way;
    changes.col(column) += (after - before) * share;
  }
}

/// Applies `cross` where the slip of contact `i` reaches zero. If it then sticks, no change lets it slip.
template <class Law, class State, class Changes>
void cross_slip(const Law& law, std::size_t i, const State& state, const State& rate_before,
                const State& rate_after, Changes&& changes) {
  cross(law.slip_gradient(i, state), law.slip_rate(i, state, rate_before), rate_before, rate_after, changes);
}

}  // namespace rubsweep::integrate::law
