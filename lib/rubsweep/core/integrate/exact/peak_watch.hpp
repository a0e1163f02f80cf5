#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "rubsweep/core/integrate/exact/exact_motion.hpp"
#include "rubsweep/core/integrate/run/turn.hpp"
#include "rubsweep/core/numerics/certified_step.hpp"
#include "rubsweep/core/numerics/cubic_maximum.hpp"
#include "rubsweep/core/numerics/exponential_series.hpp"

namespace rubsweep::integrate::exact {

/// Spacing of states at which a cubic through values and rates gives the maximum of a contact force. Its
/// error is at most h^4 / 384 times the largest fourth derivative, which is F w^4 for a vibration of
/// amplitude F and angular frequency w. No w of the motion exceeds 1 / reach_s(), so that h = reach_s() / 4
/// makes the error (1 / 4)^4 / 384 = 1e-5 of the amplitude.
template <int N>
double peak_reach_s(const ExactMotion<N>& motion) {
  return 0.25 * motion.reach_s();
}

/// Largest displacements and contact force of an exact run. The rotor's displacement: from values and rates
/// at the ends of steps. The force: by certified steps towards the instants where it may exceed the known
/// peak. A casing's displacement: by steps as short as its vibration requires, unless its energy shows that
/// it stays below the known peak.
template <int N>
class PeakWatch {
 public:
  using State = typename modes::ExactTypes<N>::State;

  explicit PeakWatch(const modes::MachineModes<N>& modes, double length_m)
      : observed_(modes.system().observed), length_m_(length_m) {
    for (const auto& casing : modes.system().casings)
      casings_.push_back({casing.contact, casing.map, casing.sag, casing.rate});
  }

  bool watches_casings() const { return !casings_.empty(); }

  /// Begins watching in the motion's present mode.
  void begin(const ExactMotion<N>& motion) {
    start_state_ = motion.physical();
    now_ = square_of(observed_, start_state_);
    start_ = motion.here();
  }

  /// Ends a step of `duration_s` in one mode. `since_look_s`: time since the last state that was passed, or
  /// since the step's start.
  void step(const ExactMotion<N>& motion, double duration_s, double since_look_s, run::TurnReport& report) {
    const State end = motion.physical();
    pass(end, since_look_s, report);
    const Instant& here = motion.here();
    for (std::size_t t = 0; t < motion.mode().touches.size(); ++t) {
      if (motion.mode().touches[t].pushes)
        raise_force(motion, t, here, duration_s, report.peak_contact_force_n);
    }
    for (std::size_t c = 0; c < casings_.size(); ++c)
      raise_casing(motion, c, end, duration_s, report.peak_casing_displacement_m);
    start_ = here;
    start_state_ = end;
  }

  /// Notes a state between the ends of steps, for the displacement only.
  void pass(const State& here, double duration_s, run::TurnReport& report) {
    const ValueAndRate last = std::exchange(now_, square_of(observed_, here));
    const double known = report.peak_displacement_m / length_m_;
    if (ceiling(last, now_, duration_s) <= known * known) return;
    const double square = std::max(0.0, largest(last, now_, duration_s));
    report.peak_displacement_m = std::max(report.peak_displacement_m, length_m_ * std::sqrt(square));
  }

 private:
  using Instant = typename ExactMotion<N>::Instant;
  using Map = Eigen::Matrix<double, 2, N>;
  using Casing = run::ScaledCasing<N>;
  struct ValueAndRate {
    double value = 0, rate = 0;
  };

  template <class Value>
  static double largest(const Value& a, const Value& b, double duration_s) {
    return numerics::cubic_maximum(a.value, duration_s * a.rate, b.value, duration_s * b.rate);
  }

  static void raise(double& known, const ValueAndRate& a, const ValueAndRate& b, double duration_s) {
    known = numerics::larger_maximum(known, a.value, duration_s * a.rate, b.value, duration_s * b.rate);
  }

  /// Upper bound of all cubics through values and rates of both ends: the largest weight of a rate is 4 / 27.
  static double ceiling(const ValueAndRate& a, const ValueAndRate& b, double duration_s) {
    return std::max(a.value, b.value) + 0.1482 * duration_s * (std::abs(a.rate) + std::abs(b.rate));
  }

  static ValueAndRate square_of(const Map& map, const State& here) {
    const Eigen::Index n = here.size() / 2;
    const Eigen::Vector2d z = map * here.template head<N>(n), v = map * here.template segment<N>(n, n);
    return square_of(z, v);
  }
  static ValueAndRate square_of(const Eigen::Vector2d& z, const Eigen::Vector2d& v) {
    return {z.squaredNorm(), 2 * z.dot(v)};
  }

  /// Covers a step from start to end. A casing without contact vibrates at its own rate, a casing in contact
  /// at the rate of the contact. In a mode without pairs the run's own steps are short enough.
  void raise_casing(const ExactMotion<N>& motion, std::size_t c, const State& end, double duration_s,
                    double& known_m) {
    const Casing& casing = casings_[c];
    const bool open = motion.mode().modes[casing.contact] == contact::Mode::open;
    if (open && casing.reach(start_state_) * length_m_ <= known_m) return;
    // The square of a displacement vibrates at twice its frequency.
    const double reach_s = open ? 0.125 / casing.rate : peak_reach_s(motion);
    ValueAndRate from = square_of(casing.map, start_state_);
    double square = from.value, left_s = duration_s;
    const int k = numerics::exact_step_below(reach_s * motion.mode().longest_steps_per_s);
    if (motion.mode().paired && left_s > reach_s && k < numerics::exact_step_count) {
      const double size_s = motion.mode().longest_step_s * numerics::exact_step_size(k);
      for (at_ = start_; left_s > size_s; left_s -= size_s) {
        motion.ahead_by_table(at_, k);
        const auto there = motion.casing(c, at_);
        const ValueAndRate to = square_of(there.displacement, there.velocity);
        raise(square, from, to, size_s);
        from = to;
      }
    }
    raise(square, from, square_of(casing.map, end), left_s);
    known_m = std::max(known_m, length_m_ * std::sqrt(square));
  }

  /// Covers a step from start to its end `here`. Where the force may exceed the known peak, shorter steps are
  /// taken, so that a cubic through values and rates of both ends has its maximum. In a mode without pairs
  /// the run's own steps are short enough.
  void raise_force(const ExactMotion<N>& motion, std::size_t t, const Instant& here, double left_s,
                   double& known_n) {
    const double reach_s = peak_reach_s(motion);
    Instant& at = at_;
    at = start_;
    auto from = motion.force(t, at);
    known_n = std::max(known_n, from.value);
    while (motion.mode().paired && left_s > reach_s) {
      const double safe_s = numerics::safe_step(from.value - known_n, from.rate, from.curvature);
      if (safe_s >= left_s) return;
      const int k = numerics::exact_step_below(std::max(safe_s, reach_s) * motion.mode().longest_steps_per_s);
      if (k == numerics::exact_step_count) break;
      const double size_s = motion.mode().longest_step_s * numerics::exact_step_size(k);
      motion.ahead_by_table(at, k);
      const auto to = motion.force(t, at);
      known_n = std::max(known_n, size_s > reach_s ? to.value : largest(from, to, size_s));
      left_s -= size_s;
      from = to;
    }
    known_n = std::max(known_n, largest(from, motion.force(t, here), left_s));
  }

  Map observed_;
  double length_m_;
  std::vector<Casing> casings_;
  State start_state_;   ///< state at the start of the step
  ValueAndRate now_;    ///< square of the observed displacement
  Instant start_, at_;  ///< start of the step, and a scratch instant that moves along it
};

}  // namespace rubsweep::integrate::exact
