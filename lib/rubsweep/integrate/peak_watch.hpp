#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "rubsweep/integrate/exact_motion.hpp"
#include "rubsweep/integrate/step_observer.hpp"
#include "rubsweep/integrate/turn.hpp"

namespace rubsweep::integrate {

/// Largest displacement and contact force of an exact run, from values and rates at the ends of its steps.
template <int N>
class PeakWatch {
 public:
  using State = typename ExactTypes<N>::State;

  explicit PeakWatch(const ExactPlan<N>& plan, double length_m)
      : observed_(plan.system().observed),
        length_m_(length_m),
        now_{{}, std::vector<ValueAndRate>(plan.system().contacts.size())},
        last_(now_) {}

  /// From here on, in the motion's present mode.
  void begin(const ExactMotion<N>& motion) { look(motion, now_); }

  /// A step of `duration_s` in one mode ends here, `since_look_s` after the last state that was passed or the
  /// step's start.
  void step(const ExactMotion<N>& motion, double duration_s, double since_look_s, Turn& turn) {
    std::swap(now_, last_);
    look(motion, now_);
    raise_displacement(since_look_s, turn);
    for (const TouchPlan<N>& touch : motion.mode().touches) {
      const std::size_t i = touch.contact;
      turn.peak_contact_force_n =
          std::max(turn.peak_contact_force_n, largest(last_.force_n[i], now_.force_n[i], duration_s));
    }
  }

  /// The same at a state between the ends of steps, for the displacement alone.
  void pass(const State& here, double duration_s, Turn& turn) {
    last_.square = now_.square;
    now_.square = square_of_displacement(here);
    raise_displacement(duration_s, turn);
  }

 private:
  struct ValueAndRate {
    double value = 0, rate = 0;
  };
  struct Look {
    ValueAndRate square;  ///< of the observed displacement
    std::vector<ValueAndRate> force_n;
  };

  static double largest(const ValueAndRate& a, const ValueAndRate& b, double duration_s) {
    return cubic_maximum(a.value, duration_s * a.rate, b.value, duration_s * b.rate);
  }

  void raise_displacement(double duration_s, Turn& turn) const {
    const double square = std::max(0.0, largest(last_.square, now_.square, duration_s));
    turn.peak_displacement_m = std::max(turn.peak_displacement_m, length_m_ * std::sqrt(square));
  }

  ValueAndRate square_of_displacement(const State& here) const {
    const Eigen::Index n = here.size() / 2;
    const Eigen::Vector2d z = observed_ * here.template head<N>(n),
                          v = observed_ * here.template segment<N>(n, n);
    return {z.squaredNorm(), 2 * z.dot(v)};
  }

  void look(const ExactMotion<N>& motion, Look& look) const {
    const State here = motion.physical();
    look.square = square_of_displacement(here);
    if (motion.mode().touches.empty()) return;
    State offset = here;
    offset.template head<N>(here.size() / 2) -= motion.mode().rest;
    const State rate = motion.rate_of(here);
    for (const TouchPlan<N>& touch : motion.mode().touches) {
      look.force_n[touch.contact] = {touch.force.dot(offset.transpose()) + touch.force_constant,
                                     touch.force.dot(rate.transpose())};
    }
  }

  Eigen::Matrix<double, 2, N> observed_;
  double length_m_;
  Look now_, last_;
};

}  // namespace rubsweep::integrate
