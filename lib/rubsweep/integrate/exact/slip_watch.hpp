#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <variant>
#include <vector>

#include "rubsweep/integrate/exact/exact_motion.hpp"
#include "rubsweep/integrate/exact/machine_modes.hpp"
#include "rubsweep/numerics/cubic_maximum.hpp"

namespace rubsweep::integrate::exact {

/// Watches that friction stays saturated, so that its coefficient is the constant that the linear mode
/// was made with, over stretches of contact no longer than the mode's longest step. Between two instants T
/// apart a slip whose rate is at most L stays above (slip at the one + slip at the other - L T) / 2. Where
/// nearly equal modes cancel each other L is a hundred times what the slip does: stretches are then so short
/// that a slip that hardly changes passes.
template <int N>
class SlipWatch {
 public:
  using State = typename ExactTypes<N>::State;

  SlipWatch(const scene::Scene& scene, const std::vector<contact::SaturatedFriction>& friction)
      : length_m_(scene.length_scale_m) {
    for (std::size_t i = 0; i < scene.contacts.size(); ++i) {
      const bool saturates = contact::saturated_friction(scene.contacts[i].friction).has_value();
      contacts_.push_back(
          {.above_m_per_s = saturates ? friction[i].above_m_per_s : std::numeric_limits<double>::infinity(),
           .surface_speed_m_per_s = scene.contacts[i].surface_speed_m_per_s,
           .constant = contact::keeps_its_direction(scene.contacts[i].friction)});
    }
  }

  /// Starts a stretch at `physical`, the motion's state; false when friction is not saturated here, or so
  /// little beyond it that the bounds hold over no stretch worth a step.
  bool begin(const ExactMotion<N>& motion, const State& physical) {
    duration_s_ = 0;
    longest_s_ = motion.mode().longest_step_s;
    may_reverse_ = false;
    for (const TouchWatch<N>& touch : motion.mode().touches) {
      Contact& c = contacts_[touch.contact];
      c.start_m_per_s = slip(touch, physical);
      c.rate_bound = length_m_ * motion.sliding_rate_bound(touch, physical);
      c.friction_rate = c.friction_swing = 0;
      for (std::size_t k = 0; k < touch.friction_rate.size(); ++k) {
        const auto& other = motion.machine().system().contacts[k];
        const double penetration =
            other.first_row.dot(physical.head(other.first_row.size()).transpose()) - other.clearance;
        c.friction_rate += length_m_ * touch.friction_rate[k] * std::max(0.0, penetration);
        c.friction_swing += length_m_ * touch.friction_swing[k] * std::max(0.0, penetration);
      }
      if (!(c.start_m_per_s > c.above_m_per_s)) return false;
      const double longest_s = motion.mode().longest_step_s;
      const double rate_bound = c.rate_bound + c.friction_rate + c.friction_swing * longest_s;
      may_reverse_ = may_reverse_ || (c.constant && c.start_m_per_s <= rate_bound * longest_s);
      const double margin = c.start_m_per_s - c.above_m_per_s;
      if (share_of_margin * margin < rate_bound * longest_s_)
        longest_s_ = share_of_margin * margin / rate_bound;
    }
    if (may_reverse_) note(motion, physical);
    return longest_s_ >= shortest_stretch * motion.mode().longest_step_s;
  }

  /// Whether the slip of a constant friction, which holds at every speed and so never ends a stretch, may
  /// come to zero in this one.
  bool may_reverse() const { return may_reverse_; }

  /// At the end of a step of `duration_s` inside the stretch: whether such a slip came to zero in it, by the
  /// cubic through its values and rates at both ends.
  bool reversed_in(const ExactMotion<N>& motion, const State& physical, double duration_s) {
    bool reversed = false;
    const auto before = [this](const TouchWatch<N>& touch) { return contacts_[touch.contact].last; };
    std::array<ValueAndRate, most_exact_contacts> starts{};
    std::size_t count = 0;
    for (const TouchWatch<N>& touch : motion.mode().touches) starts[count++] = before(touch);
    note(motion, physical);
    count = 0;
    for (const TouchWatch<N>& touch : motion.mode().touches) {
      const ValueAndRate start = starts[count++], end = before(touch);
      const double largest =
          numerics::cubic_maximum(-start.value, -duration_s * start.rate, -end.value, -duration_s * end.rate);
      reversed = reversed || (contacts_[touch.contact].constant && largest >= 0);
    }
    return reversed;
  }

  void advance(double duration_s) { duration_s_ += duration_s; }
  double duration_s() const { return duration_s_; }
  /// How long a stretch that began here may be.
  double longest_s() const { return longest_s_; }

  /// Whether friction was saturated all along the stretch that ends at `physical`; says when the slip of a
  /// constant friction is reversed there.
  bool held(const ExactMotion<N>& motion, const State& physical, bool& reversed) const {
    for (const TouchWatch<N>& touch : motion.mode().touches) {
      const double end = slip(touch, physical);
      if (end <= 0 && contacts_[touch.contact].constant) reversed = true;
      if (!(least_m_per_s(touch, end) > contacts_[touch.contact].above_m_per_s)) return false;
    }
    return true;
  }

  struct AtStart {
    double margin_m_per_s = 0;  ///< least distance of a slip from where it is no longer saturated
    double rate_m_per_s2 = 0;   ///< no slip changes faster within the mode's longest step
  };
  /// Of the stretch that began last.
  AtStart at_start(const ExactMotion<N>& motion) const {
    AtStart all{std::numeric_limits<double>::infinity(), 0};
    for (const TouchWatch<N>& touch : motion.mode().touches) {
      const Contact& c = contacts_[touch.contact];
      all.margin_m_per_s = std::min(all.margin_m_per_s, c.start_m_per_s - c.above_m_per_s);
      all.rate_m_per_s2 = std::max(all.rate_m_per_s2, c.rate_bound + c.friction_rate +
                                                          c.friction_swing * motion.mode().longest_step_s);
    }
    return all;
  }

  /// How far the slips stayed above what saturation takes, all along the stretch that ends at `physical`.
  double margin_m_per_s(const ExactMotion<N>& motion, const State& physical) const {
    double margin = std::numeric_limits<double>::infinity();
    for (const TouchWatch<N>& touch : motion.mode().touches) {
      const double least = least_m_per_s(touch, slip(touch, physical));
      margin = std::min(margin, least - contacts_[touch.contact].above_m_per_s);
    }
    return margin;
  }

 private:
  struct ValueAndRate {
    double value = 0, rate = 0;  ///< m/s, m/s^2
  };

  struct Contact {
    double above_m_per_s = 0;  ///< saturated from here on
    double surface_speed_m_per_s = 0;
    bool constant = false;  ///< friction that does not depend on the slip, nor on its sign
    ValueAndRate last{};    ///< slip at the end of the last step
    double start_m_per_s = 0;
    double rate_bound = 0, friction_rate = 0;  ///< m/s^2
    double friction_swing = 0;                 ///< m/s^3
  };

  void note(const ExactMotion<N>& motion, const State& physical) {
    const State rate = motion.rate_of(physical);
    for (const TouchWatch<N>& touch : motion.mode().touches)
      contacts_[touch.contact].last = {slip(touch, physical),
                                       length_m_ * touch.sliding.dot(rate.transpose())};
  }

  /// Bound from below over the stretch that ends with slip `end_m_per_s`.
  double least_m_per_s(const TouchWatch<N>& touch, double end_m_per_s) const {
    const Contact& c = contacts_[touch.contact];
    const double friction = c.friction_rate + c.friction_swing * duration_s_;
    return (end_m_per_s + c.start_m_per_s - (c.rate_bound + friction) * duration_s_) / 2;
  }

  double slip(const TouchWatch<N>& touch, const State& physical) const {
    return contacts_[touch.contact].surface_speed_m_per_s +
           length_m_ * touch.sliding.dot(physical.transpose());
  }

  /// Of twice the margin, the most that a slip that stays the same can be shown to keep.
  static constexpr double share_of_margin = 1.8;
  static constexpr double shortest_stretch = 1.0 / 256;  ///< of the mode's longest step

  double length_m_;
  double duration_s_ = 0, longest_s_ = 0;
  bool may_reverse_ = false;
  std::vector<Contact> contacts_;
};

}  // namespace rubsweep::integrate::exact
