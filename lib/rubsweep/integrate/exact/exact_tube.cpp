#include "rubsweep/integrate/exact/exact_tube.hpp"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <memory>

#include "rubsweep/contact/friction_law.hpp"
#include "rubsweep/integrate/exact/exact_motion.hpp"
#include "rubsweep/integrate/exact/joint_mode.hpp"
#include "rubsweep/integrate/exact/slip_watch.hpp"
#include "rubsweep/integrate/exact/tube_spread.hpp"
#include "rubsweep/numerics/certified_step.hpp"
#include "rubsweep/numerics/step_table.hpp"

namespace rubsweep::integrate::exact {
namespace {

/// A window is this short against the norm of the generator, so that the flow over it is the identity to 5 %.
constexpr double window_by_rate = 0.05;

/// Follows the reference by certified steps and takes down what the tube must keep away from.
template <int N>
class TubeBuilder {
 public:
  using Motion = ExactMotion<N>;
  using State = typename Motion::State;

  TubeBuilder(const scene::Scene& scene, std::shared_ptr<MachineModes<N>> modes)
      : motion_(scene, modes), slip_(scene, modes->friction()), scale_(run::state_scale(scene)) {
    tube_.period_s = scene.period_s();
    for (const contact::SaturatedFriction& friction : modes->friction())
      slips_ = slips_ || friction.above_m_per_s > 0;
  }

  std::optional<TurnTube> build(std::vector<double>& section, const Eigen::MatrixXd& disturbances,
                                const Eigen::MatrixXd& end_norm) {
    base_ = static_cast<std::size_t>(disturbances.cols());
    if (!start(section)) return std::nullopt;
    motion_.carry_tangents(disturbances);
    if (!keep_clamped()) return std::nullopt;
    for (int steps = 0; time_s_ < tube_.period_s; ++steps) {
      if (steps > most_steps || !go_on()) return std::nullopt;
    }
    if (!motion_.free().allFinite()) return std::nullopt;
    finish(section, end_norm);
    return std::move(tube_);
  }

 private:
  using Spread = TurnTube::Spread;
  using Seen = SeenByDisturbances;
  using GuardValue = typename Motion::GuardValue;
  static constexpr int most_steps = 100'000;
  static constexpr double shortest_step = 1e-12;  ///< of a turn
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  bool start(const std::vector<double>& section) {
    State physical =
        Eigen::Map<const Eigen::VectorXd>(section.data(), static_cast<Eigen::Index>(section.size()));
    scale_.to_seconds(physical);
    motion_.set_phases(0);
    if (!motion_.enter(0, physical)) return false;
    const std::size_t joint =
        joint_mode_of(motion_.machine().system().contacts, physical, motion_.rate_of(physical));
    return (joint == 0 || motion_.enter(joint, physical)) && motion_.mode().annular_guards.empty();
  }

  Seen seen(std::size_t e) {
    const auto& pairs = motion_.mode().guards[e].terms.list;
    Seen seen;
    for (const State& z : motion_.tangents()) {
      const ModalSum sum = sum_of(pairs, z.data(), motion_.mode().paired);
      seen.value.push_back(sum.value());
      seen.rate.push_back(sum.rate());
      seen.curvature.push_back(sum.curvature());
    }
    return seen;
  }

  Spread spread_of(const std::vector<double>& values) const { return exact::spread_of(values, base_); }

  Spread spread_over(const Seen& seen, double duration_s) const {
    return exact::spread_over(seen, base_, duration_s);
  }

  void keep_margin(double margin, Spread spread) { tube_.margins.push_back({margin, std::move(spread)}); }

  /// The guards of clamped do not watch p, which only its entry makes positive: a turn that starts there must
  /// be told.
  bool keep_clamped() {
    const auto& contacts = motion_.machine().system().contacts;
    const State here = motion_.physical();
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      if (motion_.mode().modes[i] != contact::Mode::clamped) continue;
      std::vector<double> widths;
      for (const State& z : motion_.tangents()) {
        const State physical = motion_.mode().from_free(z);
        widths.push_back(contacts[i].first_row.dot(physical.head(contacts[i].first_row.size()).transpose()));
      }
      keep_margin(kinematics_of(contacts[i], here, 0).penetration, spread_of(widths));
    }
    return std::ranges::all_of(tube_.margins, [](const TurnTube::Margin& m) { return m.margin > 0; });
  }

  struct Choice {
    double step_s = 0;
    std::size_t crossing = none;
  };

  /// A step that leaves every guard at half its distance from zero, or the landing on the guard that crosses
  /// first. Empty where a guard stands at zero.
  std::optional<Choice> choose(const std::vector<GuardValue>& guards) const {
    const LinearMode<N>& mode = motion_.mode();
    Choice choice{std::min({mode.longest_step_s, 1 / mode.fastest_rad_per_s, tube_.period_s - time_s_})};
    for (std::size_t e = 0; e < guards.size(); ++e) {
      const GuardValue& guard = guards[e];
      if (e == behind_) {
        if (!(guard.rate < 0)) return std::nullopt;
        choice.step_s = std::min(choice.step_s, -guard.rate / (2 * guard.curvature));
      } else if (!(guard.value < 0)) {
        return std::nullopt;
      }
    }
    for (std::size_t e = 0; e < guards.size(); ++e) {
      const GuardValue& guard = guards[e];
      if (e == behind_ || !numerics::crosses(guard.value, guard.rate, guard.curvature)) continue;
      const double latest = numerics::latest_crossing(guard.value, guard.rate, guard.curvature);
      if (latest < choice.step_s && latest <= motion_.reach_s()) choice = {latest, e};
    }
    const auto safe_but = [&](std::size_t but) {
      double safe_s = choice.step_s;
      for (std::size_t e = 0; e < guards.size(); ++e) {
        if (e == behind_ || e == but) continue;
        safe_s =
            std::min(safe_s, numerics::safe_step(guards[e].value / 2, guards[e].rate, guards[e].curvature));
      }
      return safe_s;
    };
    if (choice.crossing != none && safe_but(choice.crossing) < choice.step_s) choice.crossing = none;
    choice.step_s = safe_but(choice.crossing);
    const bool stands = choice.step_s < shortest_step * tube_.period_s;
    return stands && choice.step_s < tube_.period_s - time_s_ ? std::nullopt : std::optional(choice);
  }

  bool go_on() {
    const std::size_t count = motion_.mode().guards.size();
    std::vector<GuardValue> guards;
    std::vector<Seen> seen_by;
    for (std::size_t e = 0; e < count; ++e) {
      guards.push_back(motion_.guard(e));
      seen_by.push_back(seen(e));
    }
    const auto choice = choose(guards);
    if (!choice || !begin_slip()) return false;
    const double duration_s = move(choice->crossing, choice->step_s);
    if (!end_slip(duration_s)) return false;
    for (std::size_t e = 0; e < count; ++e) {
      if (e == choice->crossing) continue;
      const Spread spread = spread_over(seen_by[e], duration_s);
      if (e == behind_) {
        raise(tube_.switches.back().spread, spread);
        continue;
      }
      const GuardValue& guard = guards[e];
      const double end = guard.value + duration_s * (guard.rate + duration_s / 2 * guard.curvature);
      keep_margin(-std::max(guard.value, end), spread);
    }
    behind_ = none;
    if (choice->crossing == none) return true;
    const Spread spread = spread_over(seen_by[choice->crossing], duration_s);
    return change_mode(choice->crossing, guards[choice->crossing], spread, duration_s);
  }

  /// Along the present mode; returns how far.
  double move(std::size_t crossing, double step_s) {
    double duration_s = step_s;
    if (crossing != none) {
      duration_s = motion_.land(crossing, step_s);
    } else if (step_s >= tube_.period_s - time_s_) {
      motion_.step_by(step_s);
      time_s_ = tube_.period_s;
      return step_s;
    } else if (const int k = numerics::exact_step_below(step_s * motion_.mode().longest_steps_per_s);
               k < numerics::exact_step_count) {
      motion_.step_by_table(k);
      duration_s = motion_.mode().longest_step_s * numerics::exact_step_size(k);
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

  /// Norm of the generator in units of (1, fastest rate).
  static double norm_of(const LinearMode<N>& mode) {
    const Eigen::Index n = mode.rest.size();
    Eigen::MatrixXd generator = mode.generator / mode.fastest_rad_per_s;
    generator.topRightCorner(n, n) *= mode.fastest_rad_per_s;
    generator.bottomLeftCorner(n, n) /= mode.fastest_rad_per_s;
    return generator.cwiseAbs().rowwise().sum().maxCoeff();
  }

  /// What disturbances may make of a sliding speed until the end of a step, m/s: by the largest component in
  /// units of (1, fastest rate), which grows no faster than the norm of the generator.
  Spread slip_spread() {
    const LinearMode<N>& mode = motion_.mode();
    const Eigen::Index n = mode.rest.size();
    const double growth = std::exp(std::min(700.0, norm_of(mode)));
    double largest = 0;
    for (const TouchWatch<N>& touch : mode.touches)
      largest = std::max(largest, touch.sliding.cwiseAbs().sum());
    std::vector<double> values;
    for (const State& z : motion_.tangents()) {
      const State physical = mode.from_free(z);
      const double size = std::max(physical.head(n).cwiseAbs().maxCoeff(),
                                   physical.tail(n).cwiseAbs().maxCoeff() / mode.fastest_rad_per_s);
      values.push_back(scale_.length_m * largest * mode.fastest_rad_per_s * growth * size);
    }
    return spread_of(values);
  }

  /// What is left of the slips at a change of mode, for whoever touches in its window: in the old mode until
  /// the guard is crossed, in the new one from then on.
  bool add_slip(TurnTube::Switch& change) {
    if (!slips_ || motion_.mode().touches.empty()) return true;
    if (!slip_.begin(motion_, motion_.physical())) return false;
    const auto [margin, rate] = slip_.at_start(motion_);
    TurnTube::Other slip;
    slip.value = -margin;
    slip.rate = rate;
    slip.spread = slip_spread();
    change.others.push_back(std::move(slip));
    other_rows_.push_back(State::Zero(motion_.free().size()).transpose());
    return true;
  }

  bool change_mode(std::size_t e, const GuardValue& before, const Spread& spread, double landing_s) {
    const LinearMode<N>& from = motion_.mode();
    const LinearGuard<N> guard = from.guards[e];
    const GuardValue at = motion_.guard(e);
    const Seen on_guard = seen(e);
    TurnTube::Switch change;
    change.time_s = time_s_;
    change.rate = at.rate;
    change.curvature = std::max(before.curvature, at.curvature);
    change.lowest_rate = (before.rate + at.rate - change.curvature * landing_s) / 2;
    change.spread = spread;
    change.rate_spread = spread_of(on_guard.rate);
    change.curvature_spread = spread_of(on_guard.curvature);
    other_rows_.clear();
    if (!add_others(change, e) || !add_slip(change)) return false;

    const State here = motion_.physical();
    const std::size_t i = guard.contact;
    const auto& contact = motion_.machine().system().contacts[i];
    const auto kinematics = kinematics_of(contact, here, motion_.closing_acceleration(i, here));
    if (contact::mode_after(guard.next, contact.stiffness, contact.damping, kinematics) != guard.next)
      return false;
    const std::size_t joint =
        motion_.joint() - in_joint_mode(from.modes[i], i) + in_joint_mode(guard.next, i);
    if (!motion_.enter(joint, here)) return false;
    const LinearMode<N>& to = motion_.mode();
    behind_ = none;
    for (std::size_t k = 0; k < to.guards.size(); ++k) {
      if (to.guards[k].contact == i && to.guards[k].physical == -guard.physical) behind_ = k;
    }
    if (behind_ != none) {
      change.curvature = std::max(change.curvature, motion_.guard(behind_).curvature);
      raise(change.curvature_spread, spread_of(seen(behind_).curvature));
    }
    if (!add_others(change, behind_) || !add_slip(change)) return false;
    change.longest_window_s =
        window_by_rate / std::max(norm_of(from) * from.fastest_rad_per_s, norm_of(to) * to.fastest_rad_per_s);
    if (!add_kick(from, to, guard, change)) return false;
    change.margins_before = tube_.margins.size();
    tube_.switches.push_back(std::move(change));
    return true;
  }

  /// The guards of the present mode but one, as they stand at a change of mode.
  bool add_others(TurnTube::Switch& change, std::size_t but) {
    for (std::size_t k = 0; k < motion_.mode().guards.size(); ++k) {
      if (k == but) continue;
      const GuardValue at = motion_.guard(k);
      if (!(at.value < 0)) return false;
      const Seen on = seen(k);
      change.others.push_back({at.value, std::abs(at.rate), at.curvature, spread_of(on.value),
                               spread_of(on.rate), spread_of(on.curvature), 0});
      other_rows_.push_back(motion_.mode().guards[k].physical);
    }
    return true;
  }

  /// b of the lemma, from the two generators, whose difference is b times the guard's row.
  bool add_kick(const LinearMode<N>& from, const LinearMode<N>& to, const LinearGuard<N>& guard,
                TurnTube::Switch& change) {
    const Eigen::MatrixXd difference = to.generator - from.generator;
    const Eigen::VectorXd row = guard.physical.transpose();
    const Eigen::VectorXd b = difference * row / row.squaredNorm();
    if (!((difference - b * row.transpose()).norm() <= 1e-9 * difference.norm())) return false;
    change.own_kick = std::abs(row.dot(b));
    for (std::size_t k = 0; k < change.others.size(); ++k)
      change.others[k].own_kick = std::abs(other_rows_[k].dot(b.transpose()));
    motion_.carry_tangent_too(State(b));
    motion_.carry_tangent_too(State(to.generator * b));
    return true;
  }

  void finish(std::vector<double>& section, const Eigen::MatrixXd& end_norm) {
    const auto scaled = [&](State state) -> Eigen::VectorXd {
      scale_.from_seconds(state);
      return state;
    };
    const auto list = motion_.tangents();
    const auto at_end = [&](std::size_t i) -> Eigen::VectorXd {
      return end_norm * scaled(motion_.mode().from_free(list[i]));
    };
    Eigen::MatrixXd linear(end_norm.rows(), static_cast<Eigen::Index>(base_));
    for (std::size_t i = 0; i < base_; ++i) linear.col(static_cast<Eigen::Index>(i)) = at_end(i);
    tube_.contraction = Eigen::JacobiSVD<Eigen::MatrixXd>(linear).singularValues()(0);
    for (std::size_t i = base_; i + 1 < list.size(); i += 2)
      tube_.kicks.push_back({at_end(i).norm(), at_end(i + 1).norm()});
    const Eigen::VectorXd end = scaled(motion_.physical());
    section.assign(end.data(), end.data() + end.size());
  }

  Motion motion_;
  SlipWatch<N> slip_;
  run::StateScale scale_;  ///< of sections
  bool slips_ = false;     ///< some friction is saturated only above a slip
  Spread slip_width_;
  std::size_t base_ = 0;       ///< disturbances that are not kicks
  std::size_t behind_ = none;  ///< the guard of the present mode that has just left zero
  double time_s_ = 0;
  std::vector<typename ExactTypes<N>::Row> other_rows_;  ///< of the present change's others
  TurnTube tube_;
};

template <int N>
std::optional<TurnTube> build(const scene::Scene& scene, ModeCache& modes, std::vector<double>& section,
                              const Eigen::MatrixXd& disturbances, const Eigen::MatrixXd& end_norm) {
  return TubeBuilder<N>(scene, modes.modes_of<N>(scene)).build(section, disturbances, end_norm);
}

}  // namespace

std::optional<TurnTube> turn_tube(const scene::Scene& scene, ModeCache& modes, std::vector<double>& section,
                                  const Eigen::MatrixXd& disturbances, const Eigen::MatrixXd& end_norm) {
  const bool saturates = std::ranges::all_of(scene.contacts, [](const scene::Contact& contact) {
    return contact::saturated_friction(contact.friction).has_value();
  });
  if (!saturates || !exact_applies(scene) || !scene.impulses.empty()) return std::nullopt;
  switch (scene.structure.coordinates()) {
    case 2:
      return build<2>(scene, modes, section, disturbances, end_norm);
    case 4:
      return build<4>(scene, modes, section, disturbances, end_norm);
    case 6:
      return build<6>(scene, modes, section, disturbances, end_norm);
    default:
      return build<Eigen::Dynamic>(scene, modes, section, disturbances, end_norm);
  }
}

}  // namespace rubsweep::integrate::exact
