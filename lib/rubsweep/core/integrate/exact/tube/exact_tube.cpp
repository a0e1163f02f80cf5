#include "rubsweep/core/integrate/exact/tube/exact_tube.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "rubsweep/core/contact/friction_law.hpp"
#include "rubsweep/core/integrate/exact/modes/machine_modes.hpp"
#include "rubsweep/core/integrate/exact/tube/tube_reference.hpp"
#include "rubsweep/core/integrate/exact/tube/tube_switch.hpp"
#include "rubsweep/core/integrate/run/coordinates.hpp"
#include "rubsweep/core/numerics/certified_step.hpp"
#include "rubsweep/core/numerics/dense/eigenvalues.hpp"
#include "rubsweep/core/numerics/exponential_series.hpp"

namespace rubsweep::integrate::exact::tube {
namespace {

/// Spectral norm of a matrix; infinite where the matrix is not finite.
double spectral_norm(const Eigen::MatrixXd& matrix) {
  if (matrix.size() == 0) return 0;
  const Eigen::MatrixXd narrow = matrix.rows() < matrix.cols() ? matrix.transpose() : matrix;
  const Eigen::MatrixXd square = narrow.transpose() * narrow;
  if (!square.allFinite()) return std::numeric_limits<double>::infinity();
  const Eigen::VectorXd squares = numerics::dense::self_adjoint_eigenvalues(square);
  if (!squares.allFinite()) return std::numeric_limits<double>::infinity();
  return std::sqrt(std::max(0.0, squares.maxCoeff()));
}

/// Follows the reference by certified steps and records the limits that the tube must keep away from.
template <int N>
class TubeBuilder {
 public:
  using State = typename ExactMotion<N>::State;

  TubeBuilder(const scene::Scene& scene, std::shared_ptr<modes::MachineModes<N>> modes)
      : reference_(scene, std::move(modes)), period_s_(scene.period_s()) {}

  std::optional<TurnTube> build(std::vector<double>& section, const Eigen::MatrixXd& disturbances,
                                const Eigen::MatrixXd& end_norm, Eigen::Index slow) {
    tube_ = {.period_s = period_s_,
             .margins = {},
             .switches = {},
             .deflections = {},
             .to_fast = {},
             .to_slow = {}};
    time_s_ = 0;
    behind_ = none;
    if (!reference_.start(section, disturbances, static_cast<std::size_t>(slow))) return std::nullopt;
    tube_.margins = reference_.clamped_margins();
    tube_.margins.reserve(margins_of_a_turn_);
    if (!std::ranges::all_of(tube_.margins, [](const TurnTube::LimitMargin& m) { return m.margin > 0; }))
      return std::nullopt;
    for (int steps = 0; time_s_ < tube_.period_s; ++steps) {
      if (steps > most_steps || !go_on()) return std::nullopt;
    }
    if (!motion().free().allFinite()) return std::nullopt;
    finish(section, end_norm);
    margins_of_a_turn_ = std::max(margins_of_a_turn_, tube_.margins.size());
    return std::move(tube_);
  }

 private:
  using Spread = TurnTube::Spread;
  using GuardValue = typename ExactMotion<N>::GuardValue;
  static constexpr int most_steps = 100'000;
  static constexpr double shortest_step = 1e-12;  ///< share of a turn
  static constexpr std::size_t none = TubeSwitch<N>::none;

  ExactMotion<N>& motion() { return reference_.motion(); }
  const ExactMotion<N>& motion() const { return reference_.motion(); }

  void keep_margin(double margin, Spread spread) { tube_.margins.push_back({margin, std::move(spread)}); }

  /// Adds the margin of a guard over a step of `duration_s`; false where the reference itself has no margin.
  bool keep_below_zero(const GuardValue& guard, const modes::ModalSums& seen, double duration_s) {
    const double end = guard.value + duration_s * (guard.rate + duration_s / 2 * guard.curvature);
    keep_margin(-std::max(guard.value, end), reference_.spread_over(seen, duration_s));
    return tube_.margins.back().margin > 0;
  }

  struct Choice {
    double step_s = 0;
    std::size_t crossing = none;
  };

  /// A step that keeps every guard at least half its distance away from zero, or the landing on the guard
  /// that crosses first. Empty where a guard is at zero.
  std::optional<Choice> choose(const std::vector<GuardValue>& guards) const {
    const modes::LinearMode<N>& mode = motion().mode();
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
      if (latest < choice.step_s && latest <= motion().reach_s()) choice = {latest, e};
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
    const std::size_t count = motion().mode().guards.size();
    if (seen_.size() < count) seen_.resize(count);
    guards_.clear();
    for (std::size_t e = 0; e < count; ++e) {
      guards_.push_back(motion().guard(e));
      reference_.see(e, seen_[e]);
    }
    const auto choice = choose(guards_);
    if (!choice) return false;
    const auto slips = reference_.slip_guards();
    const double duration_s = move(choice->crossing, choice->step_s);
    for (const auto& slip : slips) {
      if (!keep_below_zero(slip.value, slip.seen, duration_s)) return false;
    }
    for (std::size_t e = 0; e < count; ++e) {
      if (e == choice->crossing) continue;
      const Spread spread = reference_.spread_over(seen_[e], duration_s);
      if (e == behind_) {
        raise(tube_.switches.back().spread, spread);
        continue;
      }
      keep_below_zero(guards_[e], seen_[e], duration_s);
    }
    behind_ = none;
    if (choice->crossing == none) return true;
    const Spread spread = reference_.spread_over(seen_[choice->crossing], duration_s);
    TubeSwitch<N> change(reference_);
    auto made = change.through(choice->crossing, guards_[choice->crossing], spread, duration_s);
    if (!made) return false;
    made->time_s = time_s_;
    made->margins_before = tube_.margins.size();
    tube_.switches.push_back(std::move(*made));
    behind_ = change.behind();
    return true;
  }

  /// Moves along the present mode; returns the duration.
  double move(std::size_t crossing, double step_s) {
    double duration_s = step_s;
    if (crossing != none) {
      duration_s = motion().land(crossing, step_s);
    } else if (step_s >= tube_.period_s - time_s_) {
      motion().step_by(step_s);
      time_s_ = tube_.period_s;
      return step_s;
    } else if (const int k = numerics::exact_step_below(step_s * motion().mode().longest_steps_per_s);
               k < numerics::exact_step_count) {
      motion().step_by_table(k);
      duration_s = motion().mode().longest_step_s * numerics::exact_step_size(k);
    } else {
      motion().step_by(step_s);
    }
    time_s_ += duration_s;
    return duration_s;
  }

  void finish(std::vector<double>& section, const Eigen::MatrixXd& end_norm) {
    const auto scaled = [&](State state) {
      reference_.scale().from_seconds(state);
      return state;
    };
    const auto fast = static_cast<Eigen::Index>(reference_.base().fast),
               slow = static_cast<Eigen::Index>(reference_.base().slow);
    const std::size_t base = reference_.base().all();
    const auto list = motion().tangents();
    const auto at_end = [&](std::size_t i) -> State {
      return end_norm.lazyProduct(scaled(motion().mode().from_free(list[i])));
    };
    Eigen::MatrixXd linear(end_norm.rows(), fast + slow);
    for (std::size_t i = 0; i < base; ++i) linear.col(static_cast<Eigen::Index>(i)) = at_end(i);
    tube_.to_fast = {spectral_norm(linear.topLeftCorner(fast, fast)),
                     spectral_norm(linear.topRightCorner(fast, slow))};
    tube_.to_slow = {spectral_norm(linear.bottomLeftCorner(slow, fast)),
                     spectral_norm(linear.bottomRightCorner(slow, slow))};
    const auto lengths = [&](const State& x) -> Parts { return {x.head(fast).norm(), x.tail(slow).norm()}; };
    for (std::size_t i = base; i + 1 < list.size(); i += 2)
      tube_.deflections.push_back({lengths(at_end(i)), lengths(at_end(i + 1))});
    const State end = scaled(motion().physical());
    section.assign(end.data(), end.data() + end.size());
  }

  TubeReference<N> reference_;
  double period_s_ = 0;
  std::size_t behind_ = none;  ///< index of the present mode's guard that has just left zero
  double time_s_ = 0;
  std::size_t margins_of_a_turn_ = 0;   ///< most margins of the turns so far
  std::vector<GuardValue> guards_;      ///< guards of the present mode, at the start of a step
  std::vector<modes::ModalSums> seen_;  ///< projections of the disturbances onto these guards
  TurnTube tube_;
};

}  // namespace

std::optional<std::vector<TurnTube>> turn_tubes(const scene::Scene& scene, modes::ModeCache& modes,
                                                std::vector<double>& section,
                                                const std::vector<Eigen::MatrixXd>& disturbances,
                                                const std::vector<Eigen::MatrixXd>& norms,
                                                Eigen::Index slow) {
  const bool saturates = std::ranges::all_of(scene.contacts, [](const scene::Contact& contact) {
    return contact::saturated_friction(contact.friction).has_value();
  });
  if (!saturates || !modes::exact_applies(scene) || !scene.impulses.empty()) return std::nullopt;
  return run::with_coordinates(
      scene.structure.coordinates(), [&](auto n) -> std::optional<std::vector<TurnTube>> {
        TubeBuilder<n()> builder(scene, modes.modes_of<n()>(scene));
        std::vector<TurnTube> tubes;
        for (std::size_t i = 0; i < disturbances.size(); ++i) {
          auto tube = builder.build(section, disturbances[i], norms[(i + 1) % norms.size()], slow);
          if (!tube) return std::nullopt;
          tubes.push_back(std::move(*tube));
        }
        return tubes;
      });
}

}  // namespace rubsweep::integrate::exact::tube
