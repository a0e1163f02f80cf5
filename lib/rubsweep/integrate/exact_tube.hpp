#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "rubsweep/integrate/exact.hpp"
#include "rubsweep/scene/scene.hpp"

namespace rubsweep::integrate {

/// What holds for all motions that start a turn near one motion, its reference: x(0) = reference + W y with
/// |y| <= radius (Euclidean). For every radius it is asked for, `TurnTube` answers whether all of them go
/// through the same changes of contact mode in the same order, and by how much their ends can differ from
/// the linear map about the reference. Rigorous up to rounding; docs of the lemma stand at `holds`.
class TurnTube {
 public:
  /// Whether the tube of this radius holds. Then for every |y| <= r <= radius
  ///   |end_norm (F(reference + W y) - F(reference) - DF W y)| <= deviation(radius) (r / radius)^2.
  ///
  /// Lemma. Inside a mode the law is linear, and at a change of mode it goes on without a jump: the two right
  /// hand sides differ by b g, g the guard that rises through zero there. So a motion near the reference
  /// differs from what the linear flow makes of its disturbance by b g integrated over the time in which one
  /// of the two is still in the old mode and the other in the new. With |g| <= D at the reference's own
  /// crossing and a rate of at least s / 2 all around it, that time is below 2 D / s and the integral below
  /// D^2 / s. The conditions make this true: in a window of 4 D / s about each crossing the guard rises for
  /// the whole tube (its rate s, less what the tube's width, the bound of its second derivative and the jump
  /// of the law can take, stays above s / 2); no other guard of either mode comes to zero in the window;
  /// outside the windows every armed guard stays below zero by more than the tube's width there; windows
  /// neither overlap nor reach the ends of the turn; friction stays saturated by more than that width.
  bool holds(double radius) const;

  /// Bound of the deviation at the end of the turn, in the norm given there, for a radius that holds.
  double deviation(double radius) const;

 private:
  template <int N>
  friend class TubeBuilder;

  /// How far something linear in the state can be from its value on the reference: `width` per unit of
  /// radius, and per unit of each kick that a change of mode before gave the disturbance.
  struct Spread {
    double width = 0;
    std::vector<double> kicks{};
  };

  /// A quantity that stays `margin` > 0 away from where it must not come.
  struct Margin {
    double margin = 0;
    Spread spread;
  };

  struct OtherGuard {
    double gap = 0, rate = 0, curvature = 0;
    Spread spread, rate_spread, curvature_spread;
  };

  struct Switch {
    double time_s = 0;
    double rate = 0, curvature = 0, lowest_rate = 0;  ///< of the guard
    Spread spread, rate_spread, curvature_spread;
    double own_kick = 0;          ///< |row of the guard . b|
    double longest_window_s = 0;  ///< for which the bounds hold
    std::vector<OtherGuard> others;
  };

  struct Kick {
    double at_end = 0, rate_at_end = 0;  ///< |end_norm b|, and of what the flow makes of A b
  };

  /// Widths at the crossings for a radius: D of each switch and its window; empty when a condition fails.
  struct Window {
    double distance = 0, window_s = 0, kick = 0;
  };
  std::optional<std::vector<Window>> windows(double radius) const;
  static double width(const Spread& spread, double radius, std::span<const Window> before);

  double period_s_ = 0;
  std::vector<Margin> margins_;
  std::vector<std::size_t> margins_before_;  ///< per switch: how many margins lie before it
  std::vector<Switch> switches_;
  std::vector<Kick> kicks_;
};

/// The tube of the turn that starts at `section` (as Turn::section) of a scene without pulse and impulses.
/// `disturbances` is W, 2n x 2n, in the units of a section; `end_norm` 2n x 2n on a section. Replaces
/// `section` by the one at the end. Empty where the turn has no closed form, two changes of mode happen at
/// one instant, or a guard is at zero without crossing it.
std::optional<TurnTube> turn_tube(const scene::Scene& scene, ExactPlans& plans, std::vector<double>& section,
                                  const Eigen::MatrixXd& disturbances, const Eigen::MatrixXd& end_norm);

}  // namespace rubsweep::integrate
