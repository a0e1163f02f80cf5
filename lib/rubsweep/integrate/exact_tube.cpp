#include "rubsweep/integrate/exact_tube.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "rubsweep/integrate/certified_step.hpp"
#include "rubsweep/integrate/exact_motion.hpp"
#include "rubsweep/integrate/joint_mode.hpp"
#include "rubsweep/integrate/slip_watch.hpp"
#include "rubsweep/integrate/step_table.hpp"

namespace rubsweep::integrate {

// Windows of D / s, see the lemma; the distance D leaves a tenth for what the window's own kick does.
constexpr double window_in_distances = 4, share_of_distance = 0.9;
// A window is this short against the fastest rate, so that the flow over it is the identity to 5 %.
constexpr double window_by_rate = 0.05, flow_over_window = 1.05, rate_over_window = 1.1;

double TurnTube::width(const Spread& spread, double radius, std::span<const Window> before) {
  double sum = radius * spread.width;
  for (std::size_t k = 0; k < before.size() && 2 * k + 1 < spread.kicks.size(); ++k)
    sum += before[k].kick *
           (spread.kicks[2 * k] + rate_over_window * before[k].window_s * spread.kicks[2 * k + 1]);
  return sum;
}

std::optional<std::vector<TurnTube::Window>> TurnTube::windows(double radius) const {
  std::vector<Window> found;
  double free_from_s = 0;
  std::size_t margin = 0;
  const auto margins_hold = [&](std::size_t end) {
    for (; margin < end; ++margin) {
      if (!(width(margins_[margin].spread, radius, found) < margins_[margin].margin)) return false;
    }
    return true;
  };
  for (std::size_t k = 0; k < switches_.size(); ++k) {
    const Switch& at = switches_[k];
    if (!margins_hold(margins_before_[k])) return std::nullopt;
    Window window;
    window.distance = width(at.spread, radius, found) / share_of_distance;
    window.window_s = window_in_distances * window.distance / at.rate;
    window.kick = flow_over_window * window.distance * window.distance / at.rate;
    const double curvature = at.curvature + width(at.curvature_spread, radius, found);
    const double least_rate = at.rate - width(at.rate_spread, radius, found) - curvature * window.window_s -
                              at.own_kick * window.distance;
    const bool rises = least_rate >= at.rate / 2 && at.lowest_rate >= at.rate / 4 &&
                       at.own_kick * window.window_s <= 0.2 && window.window_s <= at.longest_window_s;
    if (!rises || !(at.time_s - window.window_s > free_from_s)) return std::nullopt;
    for (const OtherGuard& other : at.others) {
      const double t = window.window_s;
      const double value = other.gap + width(other.spread, radius, found) +
                           (other.rate + width(other.rate_spread, radius, found)) * t +
                           0.6 * (other.curvature + width(other.curvature_spread, radius, found)) * t * t;
      if (!(value < 0)) return std::nullopt;
    }
    free_from_s = at.time_s + window.window_s;
    found.push_back(window);
  }
  if (!(free_from_s < period_s_) || !margins_hold(margins_.size())) return std::nullopt;
  return found;
}

bool TurnTube::holds(double radius) const { return windows(radius).has_value(); }

double TurnTube::deviation(double radius) const {
  const auto at = windows(radius);
  if (!at) return std::numeric_limits<double>::infinity();
  double sum = 0;
  for (std::size_t k = 0; k < kicks_.size(); ++k)
    sum += (*at)[k].kick * (kicks_[k].at_end + rate_over_window * (*at)[k].window_s * kicks_[k].rate_at_end);
  return sum;
}

/// Follows the reference by certified steps and takes down what the tube must keep away from.
template <int N>
class TubeBuilder {
 public:
  using Motion = ExactMotion<N>;
  using State = typename Motion::State;

  TubeBuilder(const scene::Scene& scene, std::shared_ptr<ExactPlan<N>> plan)
      : motion_(scene, plan),
        slip_(scene, plan->friction()),
        speed_(scene.speed_rad_per_s),
        length_m_(scene.length_scale_m) {
    tube_.period_s_ = scene.period_s();
    for (std::size_t i = 0; i < scene.contacts.size(); ++i)
      slips_ = slips_ || plan->friction()[i].above_m_per_s > 0;
  }

  std::optional<TurnTube> build(std::vector<double>& section, const Eigen::MatrixXd& disturbances,
                                const Eigen::MatrixXd& end_norm) {
    base_ = static_cast<std::size_t>(disturbances.cols());
    if (!start(section)) return std::nullopt;
    motion_.carry(disturbances);
    for (int steps = 0; time_s_ < tube_.period_s_; ++steps) {
      if (steps > most_steps || !go_on()) return std::nullopt;
    }
    if (!motion_.free().allFinite()) return std::nullopt;
    finish(section, end_norm);
    return std::move(tube_);
  }

 private:
  using Spread = TurnTube::Spread;
  using Exit = typename Motion::Exit;
  static constexpr int most_steps = 100'000;
  static constexpr double shortest_step = 1e-12;  ///< of a turn
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  /// A guard on every disturbance: values, rates and bounds of the second derivatives.
  struct Seen {
    std::vector<double> value, rate, curvature;
  };

  bool start(const std::vector<double>& section) {
    State physical =
        Eigen::Map<const Eigen::VectorXd>(section.data(), static_cast<Eigen::Index>(section.size()));
    physical.tail(physical.size() / 2) *= speed_;
    motion_.set_phases(0, -1);
    if (!motion_.enter(0, physical)) return false;
    const std::size_t joint =
        joint_mode_of(motion_.plan().system().contacts, physical, motion_.rate_of(physical));
    return (joint == 0 || motion_.enter(joint, physical)) && motion_.mode().rings.empty();
  }

  Seen seen(std::size_t e) {
    const auto& pairs = motion_.mode().exits[e].seen.list;
    Seen seen;
    for (const State& z : motion_.carried()) {
      const SeenSum sum = sum_of(pairs, z.data(), motion_.mode().paired);
      seen.value.push_back(sum.value());
      seen.rate.push_back(sum.rate());
      seen.curvature.push_back(sum.curvature());
    }
    return seen;
  }

  /// The first `base_` numbers as one length, the others each by itself.
  Spread spread_of(const std::vector<double>& values) const {
    Spread spread;
    for (std::size_t i = 0; i < base_; ++i) spread.width += values[i] * values[i];
    spread.width = std::sqrt(spread.width);
    for (std::size_t i = base_; i < values.size(); ++i) spread.kicks.push_back(std::abs(values[i]));
    return spread;
  }

  /// Over a step: a length is convex, so that along a straight line it is largest at an end.
  Spread spread_over(const Seen& seen, double duration_s) const {
    std::vector<double> end = seen.value, bend = seen.curvature;
    for (std::size_t i = 0; i < end.size(); ++i) {
      end[i] += duration_s * seen.rate[i];
      bend[i] *= duration_s * duration_s / 2;
    }
    Spread spread = spread_of(seen.value);
    raise(spread, spread_of(end));
    const Spread bent = spread_of(bend);
    spread.width += bent.width;
    for (std::size_t i = 0; i < spread.kicks.size(); ++i) spread.kicks[i] += bent.kicks[i];
    return spread;
  }

  static void raise(Spread& spread, const Spread& other) {
    spread.width = std::max(spread.width, other.width);
    for (std::size_t i = 0; i < spread.kicks.size() && i < other.kicks.size(); ++i)
      spread.kicks[i] = std::max(spread.kicks[i], other.kicks[i]);
  }

  void keep_margin(double margin, Spread spread) { tube_.margins_.push_back({margin, std::move(spread)}); }

  bool go_on() {
    const ModePlan<N>& mode = motion_.mode();
    const std::size_t guards = mode.exits.size();
    std::vector<Exit> exits;
    for (std::size_t e = 0; e < guards; ++e) exits.push_back(motion_.exit(e));
    double step_s = std::min({mode.longest_step_s, 1 / mode.fastest_rad_per_s, tube_.period_s_ - time_s_});
    std::size_t crossing = none;
    for (std::size_t e = 0; e < guards; ++e) {
      const Exit& exit = exits[e];
      if (e == behind_) {
        if (!(exit.rate < 0)) return false;
        step_s = std::min(step_s, -exit.rate / (2 * exit.curvature));
      } else if (!(exit.value < 0)) {
        return false;
      }
    }
    for (std::size_t e = 0; e < guards; ++e) {
      const Exit& exit = exits[e];
      if (e == behind_ || !crosses(exit.value, exit.rate, exit.curvature)) continue;
      const double latest = latest_crossing(exit.value, exit.rate, exit.curvature);
      if (latest >= step_s || latest > motion_.reach_s()) continue;
      crossing = e;
      step_s = latest;
    }
    const auto safe = [&](std::size_t but) {
      double safe_s = step_s;
      for (std::size_t e = 0; e < guards; ++e) {
        if (e == behind_ || e == but) continue;
        safe_s = std::min(safe_s, safe_step(exits[e].value / 2, exits[e].rate, exits[e].curvature));
      }
      return safe_s;
    };
    if (crossing != none && safe(crossing) < step_s) crossing = none;
    step_s = safe(crossing);
    if (step_s < shortest_step * tube_.period_s_ && step_s < tube_.period_s_ - time_s_) return false;
    std::vector<Seen> seen_by;
    for (std::size_t e = 0; e < guards; ++e) seen_by.push_back(seen(e));
    if (!begin_slip()) return false;
    const double duration_s = move(crossing, step_s);
    if (!end_slip(duration_s)) return false;
    for (std::size_t e = 0; e < guards; ++e) {
      const Exit& exit = exits[e];
      const Spread spread = spread_over(seen_by[e], duration_s);
      if (e == crossing) continue;
      if (e == behind_) {
        raise(tube_.switches_.back().spread, spread);
        continue;
      }
      const double end = exit.value + duration_s * (exit.rate + duration_s / 2 * exit.curvature);
      keep_margin(-std::max(exit.value, end), spread);
    }
    behind_ = none;
    return crossing == none ||
           change_mode(crossing, exits[crossing], spread_over(seen_by[crossing], duration_s), duration_s);
  }

  /// Along the present mode; returns how far.
  double move(std::size_t crossing, double step_s) {
    double duration_s = step_s;
    if (crossing != none) {
      duration_s = motion_.land(crossing, step_s);
    } else if (step_s >= tube_.period_s_ - time_s_) {
      motion_.step_by(step_s);
      time_s_ = tube_.period_s_;
      return step_s;
    } else if (const int k = exact_step_below(step_s * motion_.mode().longest_steps_per_s);
               k < exact_step_count) {
      motion_.step_by_table(k);
      duration_s = motion_.mode().longest_step_s * exact_step_size(k);
    } else {
      motion_.step_by(step_s);
    }
    time_s_ += duration_s;
    return duration_s;
  }

  bool begin_slip() {
    if (!slips_ || motion_.mode().touches.empty()) return true;
    slip_width_ = slip_spread();
    return slip_.begin(motion_, motion_.physical());
  }

  /// The stretch that began last: how far every slip stayed above where friction is no longer saturated.
  bool end_slip(double duration_s) {
    if (!slips_ || motion_.mode().touches.empty()) return true;
    slip_.advance(duration_s);
    const double margin = slip_.margin_m_per_s(motion_, motion_.physical());
    keep_margin(margin, slip_width_);
    return margin > 0;
  }

  /// What disturbances may make of a sliding speed until the end of a step, m/s: by the largest component
  /// in units of (1, fastest rate), which grows no faster than the norm of the generator.
  Spread slip_spread() {
    const ModePlan<N>& mode = motion_.mode();
    const Eigen::Index n = mode.rest.size();
    Eigen::MatrixXd generator = mode.generator / mode.fastest_rad_per_s;
    generator.topRightCorner(n, n) *= mode.fastest_rad_per_s;
    generator.bottomLeftCorner(n, n) /= mode.fastest_rad_per_s;
    const double growth = std::exp(std::min(700.0, generator.cwiseAbs().rowwise().sum().maxCoeff()));
    std::vector<double> values;
    for (const State& z : motion_.carried()) {
      const State physical = mode.from_free(z);
      const double size = std::max(physical.head(n).cwiseAbs().maxCoeff(),
                                   physical.tail(n).cwiseAbs().maxCoeff() / mode.fastest_rad_per_s);
      double largest = 0;
      for (const TouchPlan<N>& touch : mode.touches)
        largest = std::max(largest, touch.sliding.cwiseAbs().sum());
      values.push_back(length_m_ * largest * mode.fastest_rad_per_s * growth * size);
    }
    return spread_of(values);
  }

  bool change_mode(std::size_t e, const Exit& before, const Spread& spread, double landing_s) {
    const ModePlan<N>& from = motion_.mode();
    const ExitPlan<N> guard = from.exits[e];
    const Exit at = motion_.exit(e);
    const Seen on_guard = seen(e);
    TurnTube::Switch change;
    change.time_s = time_s_;
    change.rate = at.rate;
    change.curvature = std::max(before.curvature, at.curvature);
    change.lowest_rate = (before.rate + at.rate - change.curvature * landing_s) / 2;
    change.spread = spread;
    change.rate_spread = spread_of(on_guard.rate);
    change.curvature_spread = spread_of(on_guard.curvature);
    if (!add_others(change, e)) return false;

    const State here = motion_.physical();
    const std::size_t i = guard.contact;
    const auto& contact = motion_.plan().system().contacts[i];
    const auto kinematics = kinematics_of(contact, here, motion_.closing_acceleration(i, here));
    if (contact::mode_after(guard.next, contact.stiffness, contact.damping, kinematics) != guard.next)
      return false;
    const std::size_t joint =
        motion_.joint() - in_joint_mode(from.modes[i], i) + in_joint_mode(guard.next, i);
    if (!motion_.enter(joint, here)) return false;
    const ModePlan<N>& to = motion_.mode();
    behind_ = none;
    for (std::size_t k = 0; k < to.exits.size(); ++k) {
      if (to.exits[k].contact == i && to.exits[k].physical == -guard.physical) behind_ = k;
    }
    if (behind_ != none) {
      change.curvature = std::max(change.curvature, motion_.exit(behind_).curvature);
      raise(change.curvature_spread, spread_of(seen(behind_).curvature));
    }
    if (!add_others(change, behind_)) return false;
    change.longest_window_s = window_by_rate / std::max(from.fastest_rad_per_s, to.fastest_rad_per_s);
    if (!add_kick(from, to, guard, change)) return false;
    tube_.margins_before_.push_back(tube_.margins_.size());
    tube_.switches_.push_back(std::move(change));
    return true;
  }

  /// The guards of the present mode but one, as they stand at a change of mode.
  bool add_others(TurnTube::Switch& change, std::size_t but) {
    for (std::size_t k = 0; k < motion_.mode().exits.size(); ++k) {
      if (k == but) continue;
      const Exit at = motion_.exit(k);
      if (!(at.value < 0)) return false;
      const Seen on = seen(k);
      change.others.push_back({at.value, std::abs(at.rate), at.curvature, spread_of(on.value),
                               spread_of(on.rate), spread_of(on.curvature)});
    }
    return true;
  }

  /// b of the lemma, from the two generators, whose difference is b times the guard's row.
  bool add_kick(const ModePlan<N>& from, const ModePlan<N>& to, const ExitPlan<N>& guard,
                TurnTube::Switch& change) {
    const Eigen::MatrixXd difference = to.generator - from.generator;
    const Eigen::VectorXd row = guard.physical.transpose();
    const Eigen::VectorXd b = difference * row / row.squaredNorm();
    if (!((difference - b * row.transpose()).norm() <= 1e-9 * difference.norm())) return false;
    change.own_kick = std::abs(row.dot(b));
    motion_.carry_also(State(b));
    motion_.carry_also(State(to.generator * b));
    return true;
  }

  void finish(std::vector<double>& section, const Eigen::MatrixXd& end_norm) {
    const auto scaled = [&](State state) -> Eigen::VectorXd {
      state.tail(state.size() / 2) /= speed_;
      return state;
    };
    const auto list = motion_.carried();
    const auto size_at_end = [&](std::size_t i) {
      return (end_norm * scaled(motion_.mode().from_free(list[i]))).norm();
    };
    for (std::size_t i = base_; i + 1 < list.size(); i += 2)
      tube_.kicks_.push_back({size_at_end(i), size_at_end(i + 1)});
    const Eigen::VectorXd end = scaled(motion_.physical());
    section.assign(end.data(), end.data() + end.size());
  }

  Motion motion_;
  SlipWatch<N> slip_;
  double speed_, length_m_;
  bool slips_ = false;  ///< some friction is saturated only above a slip
  Spread slip_width_;
  std::size_t base_ = 0;       ///< disturbances that are not kicks
  std::size_t behind_ = none;  ///< the guard of the present mode that has just left zero
  double time_s_ = 0;
  TurnTube tube_;
};

namespace {

template <int N>
std::optional<TurnTube> build(const scene::Scene& scene, ExactPlans& plans, std::vector<double>& section,
                              const Eigen::MatrixXd& disturbances, const Eigen::MatrixXd& end_norm) {
  return TubeBuilder<N>(scene, plans.plan_for<N>(scene)).build(section, disturbances, end_norm);
}

}  // namespace

std::optional<TurnTube> turn_tube(const scene::Scene& scene, ExactPlans& plans, std::vector<double>& section,
                                  const Eigen::MatrixXd& disturbances, const Eigen::MatrixXd& end_norm) {
  if (!exact_applies(scene) || !scene.impulses.empty()) return std::nullopt;
  switch (scene.structure.coordinates()) {
    case 2:
      return build<2>(scene, plans, section, disturbances, end_norm);
    case 4:
      return build<4>(scene, plans, section, disturbances, end_norm);
    case 6:
      return build<6>(scene, plans, section, disturbances, end_norm);
    default:
      return build<Eigen::Dynamic>(scene, plans, section, disturbances, end_norm);
  }
}

}  // namespace rubsweep::integrate
