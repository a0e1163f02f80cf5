#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace rubsweep::integrate::exact::tube {

/// One number for each of the two parts of a turn's disturbances: those that contacts soon damp, and those
/// that decay slowly. Where they are not told apart, all are fast.
struct Parts {
  double fast = 0, slow = 0;
};

/// Bounds for all motions that start a turn near a reference motion: x(0) = reference + W y with y = (y_fast,
/// y_slow) and |y_fast| <= radii.fast, |y_slow| <= radii.slow (Euclidean). For any radii the tube answers
/// whether all of these motions go through the same changes of contact mode in the same order, and by how
/// much their ends can differ from the linear map about the reference. Up to rounding. `turn_tubes` fills it
/// in.
///
/// Lemma. Inside a mode the law is linear, and at a change of mode it goes on without a jump: the two right
/// hand sides differ by b g, g the guard that rises through zero there. So a motion near the reference
/// differs from what the linear flow makes of its disturbance by b g integrated over the time in which one of
/// the two is still in the old mode and the other in the new. With |g| <= D at the reference's own crossing
/// and a rate of at least s / 2 all around it, that time is below 2 D / s and the integral below D^2 / s.
/// `holds` asks for what makes this true: in a window of 4 D / s about each crossing the guard rises for the
/// whole tube (its rate s, less what the tube's width, the bound of its second derivative and the jump of the
/// law can take, stays above s / 2); no other guard of either mode comes to zero in the window, and no
/// friction leaves its saturation; outside the windows every armed guard and every slip stays away from its
/// limit by more than the tube's width there; windows neither overlap nor reach the ends of the turn.
struct TurnTube {
  /// Largest deviation of a linear function of the state from its value on the reference: `width` per unit of
  /// either radius, and two numbers for each change of mode before: per unit of the deflection that it gave
  /// the disturbance, and per unit of that deflection and second of its window.
  struct Spread {
    Parts width;
    std::vector<double> deflections{};
  };

  /// A quantity that must keep `margin` > 0 from its limit.
  struct LimitMargin {
    double margin = 0;
    Spread spread;
  };

  /// A guard, or a slip margin, that must not come to zero in the window of a change of mode.
  struct Other {
    double value = 0;  ///< < 0 at the change
    double rate = 0, curvature = 0;
    Spread spread, rate_spread, curvature_spread;
    double own_deflection = 0;  ///< change per unit of the switch's own deflection
  };

  struct Switch {
    double time_s = 0;
    double rate = 0, curvature = 0;
    double lowest_rate = 0;  ///< lowest rate over the landing step
    Spread spread, rate_spread, curvature_spread;
    double own_deflection = 0;
    double longest_window_s = 0;  ///< longest time for which the bounds hold
    std::vector<Other> others;
    std::size_t margins_before = 0;  ///< number of `margins` before it
  };

  /// A deflection at the end of the turn: the lengths of both parts of end_norm b, and the same of the rate
  /// of b.
  struct EndDeflection {
    Parts at_end, rate_at_end;
  };

  double period_s = 0;
  std::vector<LimitMargin> margins;  ///< margins in the order of time
  std::vector<Switch> switches;
  std::vector<EndDeflection> deflections;  ///< deflection at each switch
  /// Largest length of the fast (slow) part of end_norm DF W y, per unit of each part of y.
  Parts to_fast, to_slow;

  /// Whether the tube of these radii holds. Then for every y within t times the radii, t <= 1, both parts of
  ///   end_norm (F(reference + W y) - F(reference) - DF W y)
  /// are at most deviation(radii) t^2 long. What holds for radii holds for all smaller ones.
  bool holds(const Parts& radii) const;

  /// Bound of the deviation at the end of the turn; infinite for radii that do not hold.
  Parts deviation(const Parts& radii) const;

 private:
  /// About one change of mode, for given radii.
  struct Window {
    double distance = 0, window_s = 0, deflection = 0;
  };
  std::optional<std::vector<Window>> windows(const Parts& radii) const;
  static std::optional<Window> window_of(const Switch& change, const Parts& radii,
                                         std::span<const Window> before);
  static double width(const Spread& spread, const Parts& radii, std::span<const Window> before);
};

}  // namespace rubsweep::integrate::exact::tube
