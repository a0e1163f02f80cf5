#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "rubsweep/core/contact/contact_mode.hpp"
#include "rubsweep/core/integrate/adaptive/step_method.hpp"
#include "rubsweep/core/integrate/run/turn_book.hpp"
#include "rubsweep/core/numerics/cubic_maximum.hpp"

namespace rubsweep::integrate::adaptive {

/// Adds each step to the report of a turn.
class StepObserver {
 public:
  StepObserver(const run::TurnRequest& request, run::TurnReport& report)
      : request_(request), report_(report) {}

  /// Samples the grid phases in [start_phase, end_phase). `state_at(phase)` gives a state inside the step.
  template <class StateAt>
  void sample(double start_phase, const State& start, double end_phase, const StateAt& state_at) {
    const int count = request_.samples_per_revolution;
    if (report_.sample_count >= count) return;
    report_.samples.resize(static_cast<std::size_t>(count) * start.size());
    for (int& k = report_.sample_count; k < count; ++k) {
      const double phase = 2 * std::numbers::pi * k / count;
      if (phase >= end_phase) return;
      const State& state = phase <= start_phase ? start : state_at(phase);
      std::copy(state.begin(), state.end(),
                report_.samples.begin() + k * static_cast<std::ptrdiff_t>(start.size()));
    }
  }

  /// Adds contact time, slip sign and, if requested, peaks of the step; called before any mode switch.
  template <class Dynamics>
  void watch(const Step& step, const Dynamics& dynamics, const std::vector<contact::Kinematics>& start,
             const std::vector<contact::Kinematics>& end) {
    const double h = step.end_phase - step.start_phase;
    double touching = 0;
    for (std::size_t i = 0; i < start.size(); ++i) {
      const double share = touching_share(dynamics, i, start[i], end[i]);
      if (share == 0) continue;
      touching = std::max(touching, share);
      if (dynamics.slip_m_per_s(i, step.end) <= 0 &&
          contact::keeps_its_direction(dynamics.system().contacts[i].friction))
        report_.slip_reversed = true;
      if (request_.peaks) watch_force(dynamics, i, h, start[i], end[i]);
    }
    if (touching > 0) run::add_contact(touching * h / (2 * std::numbers::pi), report_);
    if (request_.peaks) watch_displacement(step, dynamics, h);
    if constexpr (requires { dynamics.twist(step.start, step.start_rate); }) {
      if (request_.peaks) watch_twist(step, dynamics, h);
    }
  }

  run::TurnReport& report() { return report_; }
  bool wants_peaks() const { return request_.peaks; }

  /// Whether some contact touches at the end of the turn.
  template <class Dynamics>
  static bool touching(const State& state, const Dynamics& dynamics) {
    for (std::size_t i = 0; i < dynamics.modes().size(); ++i)
      if (touching_now(dynamics, i, dynamics.kinematics(i, state, state).penetration)) return true;
    return false;
  }

 private:
  template <class Dynamics>
  static bool touching_now(const Dynamics& dynamics, std::size_t i, double penetration) {
    if constexpr (Dynamics::smoothed) return penetration > 0;
    return dynamics.modes()[i] != contact::Mode::open;
  }

  /// Share of the step in contact. A located step has one mode throughout. A smoothed step may begin or end
  /// contact inside; the penetration is then assumed to be linear in time.
  template <class Dynamics>
  double touching_share(const Dynamics& dynamics, std::size_t i, const contact::Kinematics& start,
                        const contact::Kinematics& end) {
    if constexpr (Dynamics::smoothed) {
      const double p0 = start.penetration, p1 = end.penetration;
      if (p0 <= 0 && p1 > 0) ++report_.hits;
      if (p0 <= 0 && p1 <= 0) return 0;
      if (p0 > 0 && p1 > 0) return 1;
      return std::max(p0, p1) / std::abs(p1 - p0);
    }
    return dynamics.modes()[i] == contact::Mode::open ? 0 : 1;
  }

  template <class Dynamics>
  void watch_force(const Dynamics& dynamics, std::size_t i, double h, const contact::Kinematics& start,
                   const contact::Kinematics& end) {
    const auto total = [&](double p, double v) { return dynamics.normal_force(i, p, v).total_n; };
    const auto rate = [&](const contact::Kinematics& k) {
      // The located law is linear in (p, v) within a step, so any difference is exact; a small one is also
      // accurate for the smoothed law.
      constexpr double nudge = 1e-6;
      return (total(k.penetration + nudge * k.closing_speed,
                    k.closing_speed + nudge * k.closing_acceleration) -
              total(k.penetration - nudge * k.closing_speed,
                    k.closing_speed - nudge * k.closing_acceleration)) /
             (2 * nudge);
    };
    const double peak =
        numerics::cubic_maximum(total(start.penetration, start.closing_speed), h * rate(start),
                                total(end.penetration, end.closing_speed), h * rate(end));
    report_.peak_contact_force_n = std::max(report_.peak_contact_force_n, peak);
  }

  template <class Dynamics>
  void watch_twist(const Step& step, const Dynamics& dynamics, double h) {
    const auto start = dynamics.twist(step.start, step.start_rate),
               end = dynamics.twist(step.end, step.end_rate);
    const auto largest = [h](double a, double a_rate, double b, double b_rate) {
      return std::max(numerics::cubic_maximum(a, h * a_rate, b, h * b_rate),
                      numerics::cubic_maximum(-a, -h * a_rate, -b, -h * b_rate));
    };
    report_.peak_twist_rad = std::max(
        report_.peak_twist_rad, largest(start.angle_rad, start.angle_rate, end.angle_rad, end.angle_rate));
    report_.peak_torque_nm = std::max(
        report_.peak_torque_nm, largest(start.torque_nm, start.torque_rate, end.torque_nm, end.torque_rate));
  }

  template <class Dynamics>
  void watch_displacement(const Step& step, const Dynamics& dynamics, double h) {
    const auto largest_of = [&](const auto& map) {
      const auto square_and_slope = [&](const State& state) {
        const Eigen::Index n = map.cols();
        const Eigen::Vector2d z = map * Eigen::Map<const Eigen::VectorXd>(&state[0], n);
        const Eigen::Vector2d v = map * Eigen::Map<const Eigen::VectorXd>(&state[0] + n, n);
        return std::pair{z.squaredNorm(), 2 * z.dot(v)};
      };
      const auto [start, start_slope] = square_and_slope(step.start);
      const auto [end, end_slope] = square_and_slope(step.end);
      const double square = numerics::cubic_maximum(start, h * start_slope, end, h * end_slope);
      return std::sqrt(square) * dynamics.system().scale.length_m;
    };
    report_.peak_displacement_m =
        std::max(report_.peak_displacement_m, largest_of(dynamics.system().observed));
    for (const auto& casing : dynamics.system().casings)
      report_.peak_casing_displacement_m =
          std::max(report_.peak_casing_displacement_m, largest_of(casing.map));
  }

  const run::TurnRequest& request_;
  run::TurnReport& report_;
};

/// Reports long steps, whose method `knows_modes`, in parts where peaks are wanted: the cubics with which an
/// observer finds peaks need short steps.
class StepParts {
 public:
  /// Reports `step` of `method`. `at_start`, `at_end`: kinematics of the contacts there.
  template <class Law>
  void watch(const Step& step, const std::vector<contact::Kinematics>& at_start,
             const std::vector<contact::Kinematics>& at_end, Law& law, RightHandSide& right_hand_side,
             StepMethod& method, StepObserver& observer) {
    if (!step.knows_modes || !observer.wants_peaks()) return observer.watch(step, law, at_start, at_end);
    constexpr int parts = 8;
    part_ = step;
    start_ = at_start;
    end_.resize(start_.size());
    for (int k = 1; k <= parts; ++k) {
      part_.end_phase = step.start_phase + k * (step.end_phase - step.start_phase) / parts;
      method.state_at(right_hand_side, step, part_.end_phase, part_.end);
      law(part_.end, part_.end_rate, part_.end_phase);
      for (std::size_t i = 0; i < start_.size(); ++i) end_[i] = law.kinematics(i, part_.end, part_.end_rate);
      observer.watch(part_, law, start_, end_);
      part_.turn_around();
      start_.swap(end_);
      part_.start_phase = part_.end_phase;
    }
  }

 private:
  Step part_;
  std::vector<contact::Kinematics> start_, end_;
};

}  // namespace rubsweep::integrate::adaptive
