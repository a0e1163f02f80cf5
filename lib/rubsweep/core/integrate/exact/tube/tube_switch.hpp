#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "rubsweep/core/integrate/exact/tube/tube_reference.hpp"

namespace rubsweep::integrate::exact::tube {

/// Takes a tube's reference through a change of contact mode and records the quantities for the lemma of
/// TurnTube.
template <int N>
class TubeSwitch {
 public:
  using State = typename ExactMotion<N>::State;
  using GuardValue = typename ExactMotion<N>::GuardValue;
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  explicit TubeSwitch(TubeReference<N>& reference) : reference_(reference), motion_(reference.motion()) {}

  /// Passes a change of mode. The reference is where guard `e` is zero, after a landing of `landing_s` from
  /// the value `before`; `spread` is the spread by the disturbances over the landing. Empty where the
  /// conditions of the lemma are not met.
  std::optional<TurnTube::Switch> through(std::size_t e, const GuardValue& before,
                                          const TurnTube::Spread& spread, double landing_s) {
    const modes::LinearMode<N>& from = motion_.mode();
    const modes::LinearGuard<N>& guard = from.guards[e];
    const GuardValue at = motion_.guard(e);
    const modes::ModalSums& on_guard = reference_.seen(e);
    TurnTube::Switch change;
    change.rate = at.rate;
    change.curvature = std::max(before.curvature, at.curvature);
    change.lowest_rate = (before.rate + at.rate - change.curvature * landing_s) / 2;
    change.spread = spread;
    change.rate_spread = reference_.spread_of(on_guard.rate);
    change.curvature_spread = reference_.spread_of(on_guard.curvature);
    if (!add_others(change, e) || !add_slip(change)) return std::nullopt;

    const State here = motion_.physical();
    const std::size_t i = guard.contact;
    const auto& contact = motion_.machine().system().contacts[i];
    const auto kinematics = modes::kinematics_of(contact, here, motion_.closing_acceleration(i, here));
    if (contact::mode_after(guard.next, contact.stiffness, contact.damping, kinematics) != guard.next)
      return std::nullopt;
    const std::size_t count = motion_.machine().system().contacts.size();
    const std::size_t modes = modes::modes_of_joint_mode(motion_.joint(), count) -
                              modes::in_joint_mode(from.modes[i], i) + modes::in_joint_mode(guard.next, i);
    if (!motion_.change(reference_.slip().with_ways(motion_.machine(), modes, here))) return std::nullopt;
    const modes::LinearMode<N>& to = motion_.mode();
    for (std::size_t k = 0; k < to.guards.size(); ++k) {
      if (to.guards[k].contact == i && to.guards[k].physical == -guard.physical) behind_ = k;
    }
    if (behind_ != none) {
      change.curvature = std::max(change.curvature, motion_.guard(behind_).curvature);
      raise(change.curvature_spread, reference_.spread_of(reference_.seen(behind_).curvature));
    }
    if (!add_others(change, behind_) || !add_slip(change)) return std::nullopt;
    change.longest_window_s =
        window_by_rate / std::max(TubeReference<N>::norm_of(from) * from.fastest_rad_per_s,
                                  TubeReference<N>::norm_of(to) * to.fastest_rad_per_s);
    if (!add_deflection(from, to, guard, change)) return std::nullopt;
    return change;
  }

  /// Index of the present mode's guard that has just left zero; `none` unless this guard is the old one with
  /// the sign reversed.
  std::size_t behind() const { return behind_; }

 private:
  /// Adds the slip guards of contacts that touch in the window of a change of mode: those of the old mode
  /// until the guard is crossed, then those of the new mode.
  bool add_slip(TurnTube::Switch& change) {
    for (const auto& slip : reference_.slip_guards()) {
      if (!add_other(change, slip.value, slip.seen)) return false;
      other_rows_.push_back(slip.row);
    }
    return true;
  }

  /// Adds all guards of the present mode except `but`, with their values at a change of mode.
  bool add_others(TurnTube::Switch& change, std::size_t but) {
    for (std::size_t k = 0; k < motion_.mode().guards.size(); ++k) {
      if (k == but) continue;
      if (!add_other(change, motion_.guard(k), reference_.seen(k))) return false;
      other_rows_.push_back(motion_.mode().guards[k].physical);
    }
    return true;
  }

  bool add_other(TurnTube::Switch& change, const GuardValue& at, const modes::ModalSums& on) const {
    if (!(at.value < 0)) return false;
    change.others.push_back({at.value, std::abs(at.rate), at.curvature, reference_.spread_of(on.value),
                             reference_.spread_of(on.rate), reference_.spread_of(on.curvature), 0});
    return true;
  }

  /// Adds the vector b of the lemma: the difference of both generators is b times the guard's row.
  bool add_deflection(const modes::LinearMode<N>& from, const modes::LinearMode<N>& to,
                      const modes::LinearGuard<N>& guard, TurnTube::Switch& change) {
    const typename modes::ExactTypes<N>::Flow difference = to.generator - from.generator;
    using Column = Eigen::Matrix<double, modes::ExactTypes<N>::states, 1>;
    const Column row = guard.physical.transpose(), b = difference * row / row.squaredNorm();
    if (!((difference - b * row.transpose()).norm() <= 1e-9 * difference.norm())) return false;
    change.own_deflection = std::abs(row.dot(b));
    for (std::size_t k = 0; k < change.others.size(); ++k)
      change.others[k].own_deflection = std::abs(other_rows_[k].dot(b.transpose()));
    motion_.carry_tangent_too(State(b));
    motion_.carry_tangent_too(State(to.generator * b));
    return true;
  }

  /// Length of a window relative to the norm of the generator: so short that the flow over it is the identity
  /// within 5 %.
  static constexpr double window_by_rate = 0.05;

  TubeReference<N>& reference_;
  ExactMotion<N>& motion_;
  std::size_t behind_ = none;
  std::vector<typename modes::ExactTypes<N>::Row> other_rows_;  ///< rows of the change's other guards
};

}  // namespace rubsweep::integrate::exact::tube
