#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "rubsweep/core/contact/dry_friction.hpp"
#include "rubsweep/core/contact/friction_law.hpp"
#include "rubsweep/core/integrate/exact/exact_motion.hpp"
#include "rubsweep/core/integrate/exact/modes/joint_mode.hpp"
#include "rubsweep/core/integrate/exact/modes/machine_modes.hpp"
#include "rubsweep/core/integrate/exact/modes/mode_cache.hpp"
#include "rubsweep/core/numerics/certified_step.hpp"
#include "rubsweep/core/numerics/cubic_maximum.hpp"

namespace rubsweep::integrate::exact {

/// Event function for friction that must stay saturated and keep its direction, so that its coefficient is
/// the constant of the linear mode. It is applied to stretches of contact no longer than the mode's longest
/// step. The slip margin is a guard: its value, its rate and a bound of its second derivative give a stretch
/// over which it cannot reach zero. Friction is therefore saturated throughout a stretch. If the next stretch
/// would be too short for a step, the motion is still at a point with saturated friction.
template <int N>
class SlipWatch {
 public:
  using State = typename modes::ExactTypes<N>::State;
  using Guard = typename ExactMotion<N>::GuardValue;

  SlipWatch(const scene::Scene& scene, const std::vector<contact::SaturatedFriction>& friction)
      : length_m_(scene.length_scale_m) {
    for (std::size_t i = 0; i < scene.contacts.size(); ++i) {
      const scene::Contact& c = scene.contacts[i];
      contacts_.push_back(
          {.above_m_per_s = saturated_above(scene, c, friction[i]),
           .surface_speed_m_per_s = c.surface_speed_m_per_s,
           .one_way = contact::keeps_its_direction(c.friction) && friction[i].coefficient != 0});
    }
  }

  /// Joint mode of these contact modes with the present direction of each slip at `physical`. Empty where the
  /// friction of a touching contact is not saturated.
  std::optional<std::size_t> saturated_mode(const modes::MachineModes<N>& machine, std::size_t modes,
                                            const State& physical) const {
    const std::size_t joint = with_ways(machine, modes, physical);
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
      if (modes::mode_in_joint_mode(modes, i) == contact::Mode::open || contacts_[i].always()) continue;
      if (!(std::abs(slip(machine, i, physical)) > contacts_[i].above_m_per_s)) return std::nullopt;
    }
    return joint;
  }

  /// Joint mode with the present slip directions, as saturated_mode, without the test for saturation.
  std::size_t with_ways(const modes::MachineModes<N>& machine, std::size_t modes,
                        const State& physical) const {
    std::size_t joint = modes;
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
      if (modes::mode_in_joint_mode(modes, i) == contact::Mode::open) continue;
      if (goes_backward(machine, i, physical)) joint += modes::backward_in_joint_mode(i, contacts_.size());
    }
    return joint;
  }

  /// Whether slip and friction of contact `i` are backward at `physical`.
  bool goes_backward(const modes::MachineModes<N>& machine, std::size_t i, const State& physical) const {
    return !contacts_[i].always() && slip(machine, i, physical) < 0;
  }

  /// Starts a stretch at `physical`, the motion's state. False where friction is not saturated, or where its
  /// saturation is certain for less than `least_share` of the mode's longest step.
  bool begin(const ExactMotion<N>& motion, const State& physical, double least_share = shortest_stretch) {
    duration_s_ = 0;
    longest_s_ = motion.mode().longest_step_s;
    may_reverse_ = false;
    for (std::size_t t = 0; t < motion.mode().touches.size(); ++t) {
      const modes::TouchWatch<N>& touch = motion.mode().touches[t];
      Contact& c = contacts_[touch.contact];
      if (c.always()) {
        if (c.one_way) look_at_one_way(motion, t, physical);
        continue;
      }
      const Guard left = guard(motion, t, physical);
      if (!(left.value < 0)) return false;
      if (numerics::stays_below(left.value, left.rate, left.curvature, longest_s_)) continue;
      longest_s_ = std::min(longest_s_, numerics::safe_step(left.value, left.rate, left.curvature));
    }
    if (may_reverse_) note(motion, physical);
    return longest_s_ >= least_share * motion.mode().longest_step_s;
  }

  /// Slip margin of touch `t` at `physical`, the motion's state, as a guard in m/s. It is negative while
  /// friction is saturated and zero where friction leaves saturation, and has a bound of its second
  /// derivative within the mode's longest step. For a touch with a `friction_rate`, the rate is instead an
  /// upper bound of the first derivative. Only for contacts that are not `always` saturated.
  Guard guard(const ExactMotion<N>& motion, std::size_t t, const State& physical) const {
    const modes::TouchWatch<N>& touch = motion.mode().touches[t];
    const Contact& c = contacts_[touch.contact];
    const double value = c.above_m_per_s - touch.way * slip(touch, physical);
    if (!touch.friction_rate.empty()) return {value, rate_bound(motion, touch, physical), 0};
    const auto sliding = motion.sliding_rate(t);
    return {value, -touch.way * length_m_ * sliding.rate, length_m_ * sliding.curvature};
  }

  /// Whether the friction of touch `t` is the same at every slip.
  bool always(const ExactMotion<N>& motion, std::size_t t) const {
    return contacts_[motion.mode().touches[t].contact].always();
  }

  /// Whether the slip may reach zero in this stretch with one-way friction. (Such friction is saturated at
  /// every speed, so it never ends a stretch.)
  bool may_reverse() const { return may_reverse_; }

  /// Whether such a slip reached zero in a step of `duration_s` that lies inside the stretch and ends at
  /// `physical`, by the cubic through its values and rates at both ends.
  bool reversed_in(const ExactMotion<N>& motion, const State& physical, double duration_s) {
    bool reversed = false;
    const auto before = [this](const modes::TouchWatch<N>& touch) { return contacts_[touch.contact].last; };
    std::array<ValueAndRate, modes::most_exact_contacts> starts{};
    std::size_t count = 0;
    for (const modes::TouchWatch<N>& touch : motion.mode().touches) starts[count++] = before(touch);
    note(motion, physical);
    count = 0;
    for (const modes::TouchWatch<N>& touch : motion.mode().touches) {
      const ValueAndRate start = starts[count++], end = before(touch);
      const double largest =
          numerics::cubic_maximum(-start.value, -duration_s * start.rate, -end.value, -duration_s * end.rate);
      reversed = reversed || (contacts_[touch.contact].one_way && largest >= 0);
    }
    return reversed;
  }

  void advance(double duration_s) { duration_s_ += duration_s; }
  double duration_s() const { return duration_s_; }
  /// Longest duration of the present stretch from its start.
  double longest_s() const { return longest_s_; }

  /// Shortest stretch worth a step, as a share of the mode's longest step.
  static constexpr double shortest_stretch = 1.0 / 256;

 private:
  struct ValueAndRate {
    double value = 0, rate = 0;  ///< slip speed in m/s, its rate in m/s^2
  };

  struct Contact {
    double above_m_per_s = 0;  ///< slip speed above which friction is saturated
    double surface_speed_m_per_s = 0;
    bool one_way = false;  ///< true: friction that depends neither on the slip nor on its sign
    ValueAndRate last{};   ///< slip at the end of the last step

    bool always() const { return above_m_per_s < 0; }
  };

  /// Slip speed above which friction is saturated. The slip of a sticking contact is zero with rounding
  /// errors; these must not release the contact where its friction drops as soon as it slips.
  static double saturated_above(const scene::Scene& scene, const scene::Contact& contact,
                                const contact::SaturatedFriction& friction) {
    if (!contact::saturated_friction(contact.friction)) return std::numeric_limits<double>::infinity();
    if (!contact::friction_terms(contact.friction).jumps()) return friction.above_m_per_s;
    return contact::no_slip *
           std::max(scene.length_scale_m * scene.speed_rad_per_s, std::abs(contact.surface_speed_m_per_s));
  }

  void look_at_one_way(const ExactMotion<N>& motion, std::size_t t, const State& physical) {
    const modes::TouchWatch<N>& touch = motion.mode().touches[t];
    const double now = slip(touch, physical), longest_s = motion.mode().longest_step_s;
    may_reverse_ = may_reverse_ ||
                   (touch.friction_rate.empty() ? !stays_forward(now, motion.sliding_rate(t), longest_s)
                                                : now <= rate_bound(motion, touch, physical) * longest_s);
  }

  bool stays_forward(double slip_m_per_s, const typename ExactMotion<N>::SlidingRate& sliding,
                     double duration_s) const {
    return numerics::stays_below(-slip_m_per_s, -length_m_ * sliding.rate, length_m_ * sliding.curvature,
                                 duration_s);
  }

  /// Bound on the rate of a slip within the mode's longest step, in m/s^2.
  double rate_bound(const ExactMotion<N>& motion, const modes::TouchWatch<N>& touch,
                    const State& physical) const {
    double rate = motion.sliding_rate_bound(touch, physical), swing = 0;
    for (std::size_t k = 0; k < touch.friction_rate.size(); ++k) {
      const auto& other = motion.machine().system().contacts[k];
      const double penetration = std::max(
          0.0, other.first_row.dot(physical.head(other.first_row.size()).transpose()) - other.clearance);
      rate += touch.friction_rate[k] * penetration;
      swing += touch.friction_swing[k] * penetration;
    }
    return length_m_ * (rate + swing * motion.mode().longest_step_s);
  }

  void note(const ExactMotion<N>& motion, const State& physical) {
    const State rate = motion.rate_of(physical);
    for (const modes::TouchWatch<N>& touch : motion.mode().touches)
      contacts_[touch.contact].last = {slip(touch, physical),
                                       length_m_ * touch.sliding.dot(rate.transpose())};
  }

  double slip(const modes::MachineModes<N>& machine, std::size_t i, const State& physical) const {
    const Eigen::RowVectorXd& row = machine.system().contacts[i].second_row;
    double sliding = 0;
    for (Eigen::Index j = 0; j < row.size(); ++j) sliding += row(j) * physical(row.size() + j);
    return contacts_[i].surface_speed_m_per_s + length_m_ * sliding;
  }

  double slip(const modes::TouchWatch<N>& touch, const State& physical) const {
    return contacts_[touch.contact].surface_speed_m_per_s +
           length_m_ * touch.sliding.dot(physical.transpose());
  }

  double length_m_;
  double duration_s_ = 0, longest_s_ = 0;
  bool may_reverse_ = false;
  std::vector<Contact> contacts_;
};

}  // namespace rubsweep::integrate::exact
