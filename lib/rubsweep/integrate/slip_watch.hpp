#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "rubsweep/integrate/exact_motion.hpp"

namespace rubsweep::integrate {

/// Watches that friction stays saturated over stretches of contact that a mode's longest step covers. Between
/// two instants a slip stays above their mean less half of what its rate allows.
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
           .surface_speed_m_per_s = scene.contacts[i].surface_speed_m_per_s});
    }
  }

  /// Starts a stretch at `physical`, the motion's state; false when friction is not saturated here.
  bool begin(const ExactMotion<N>& motion, const State& physical) {
    duration_s_ = 0;
    for (const TouchPlan<N>& touch : motion.mode().touches) {
      Contact& c = contacts_[touch.contact];
      c.start_m_per_s = slip(touch, physical);
      c.rate_bound = length_m_ * motion.sliding_rate_bound(touch, physical);
      c.friction_rate = c.friction_swing = 0;
      for (std::size_t k = 0; k < touch.friction_rate.size(); ++k) {
        const auto& other = motion.plan().system().contacts[k];
        const double penetration =
            other.first_row.dot(physical.head(other.first_row.size()).transpose()) - other.clearance;
        c.friction_rate += length_m_ * touch.friction_rate[k] * std::max(0.0, penetration);
        c.friction_swing += length_m_ * touch.friction_swing[k] * std::max(0.0, penetration);
      }
      if (!(c.start_m_per_s > c.above_m_per_s)) return false;
    }
    return true;
  }

  void advance(double duration_s) { duration_s_ += duration_s; }
  double duration_s() const { return duration_s_; }

  /// Whether friction was saturated all along the stretch that ends at `physical`; says when the slip there
  /// is reversed.
  bool held(const ExactMotion<N>& motion, const State& physical, bool& reversed) const {
    for (const TouchPlan<N>& touch : motion.mode().touches) {
      const double end = slip(touch, physical);
      if (end <= 0) reversed = true;
      if (!(least_m_per_s(touch, end) > contacts_[touch.contact].above_m_per_s)) return false;
    }
    return true;
  }

  /// How far the slips stayed above what saturation takes, all along the stretch that ends at `physical`.
  double margin_m_per_s(const ExactMotion<N>& motion, const State& physical) const {
    double margin = std::numeric_limits<double>::infinity();
    for (const TouchPlan<N>& touch : motion.mode().touches) {
      const double least = least_m_per_s(touch, slip(touch, physical));
      margin = std::min(margin, least - contacts_[touch.contact].above_m_per_s);
    }
    return margin;
  }

 private:
  struct Contact {
    double above_m_per_s = 0;  ///< saturated from here on
    double surface_speed_m_per_s = 0;
    double start_m_per_s = 0;
    double rate_bound = 0, friction_rate = 0;  ///< m/s^2
    double friction_swing = 0;                 ///< m/s^3
  };

  /// Bound from below over the stretch that ends with slip `end_m_per_s`.
  double least_m_per_s(const TouchPlan<N>& touch, double end_m_per_s) const {
    const Contact& c = contacts_[touch.contact];
    const double friction = c.friction_rate + c.friction_swing * duration_s_;
    return (end_m_per_s + c.start_m_per_s - (c.rate_bound + friction) * duration_s_) / 2;
  }

  double slip(const TouchPlan<N>& touch, const State& physical) const {
    return contacts_[touch.contact].surface_speed_m_per_s +
           length_m_ * touch.sliding.dot(physical.transpose());
  }

  double length_m_;
  double duration_s_ = 0;
  std::vector<Contact> contacts_;
};

}  // namespace rubsweep::integrate
