#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace rubsweep::integrate::exact::tube {

/// One number for each of the two parts of a turn's disturbances: those that contacts soon damp, and those
/// that decay slowly. If they are not separated, all are fast.
struct Parts {
  double fast = 0, slow = 0;
};

/// Bounds for all motions that start a turn near a reference motion: x(0) = reference + W y with y = (y_fast,
/// y_slow) and |y_fast| <= radii.fast, |y_slow| <= radii.slow (Euclidean). For given radii the tube shows
/// whether all these motions pass the same changes of contact mode in the same order. It also bounds, up to
/// rounding, how much their ends differ from the linear map about the reference. `turn_tubes` fills it.
///
/// Lemma. Inside a mode the law is linear, and at a change of mode it is continuous: the two right-hand sides
/// differ by b g, where g is the guard that rises through zero there. For some time one of two motions (the
/// reference and its neighbour) is still in the old mode and the other one in the new mode. The neighbour
/// therefore differs from the linear flow of its disturbance by b g integrated over this time. If |g| <= D
/// when the reference crosses, and the rate of g is at least s / 2 all around the crossing, this time is
/// below 2 D / s and the integral below D^2 / s. `holds` tests the conditions. In a window of 4 D / s about
/// each crossing the guard rises for the whole tube: its rate s, reduced by the tube's width, the bound of
/// the second derivative and the jump of the law, stays above s / 2. No other guard of either mode reaches
/// zero in the window, and no friction leaves its saturation. Outside the windows every armed guard and every
/// slip is farther from its limit than the tube is wide. Windows neither overlap nor reach the ends of the
/// turn.
struct TurnTube {
  /// Largest deviation of a linear function of the state from its value on the reference. `width`: per unit
  /// of either radius. `deflections`: two numbers for each earlier change of mode. The first is per unit of
  /// the deflection that the change gave the disturbance, the second per unit of this deflection times
  /// seconds of its window.
  struct Spread {
    Parts width;
    std::vector<double> deflections{};
  };

  /// A quantity whose distance from its limit must stay positive; `margin` is that of the reference.
  struct LimitMargin {
    double margin = 0;
    Spread spread;
  };

  /// A guard, or a slip margin, that must not reach zero in the window of a change of mode.
  struct Other {
    double value = 0;  ///< value at the change, < 0
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
    std::size_t margins_before = 0;  ///< number of `margins` recorded before the switch
  };

  /// A deflection at the end of the turn: the lengths of both parts of end_norm b, and of the rate of b in
  /// the same norm.
  struct EndDeflection {
    Parts at_end, rate_at_end;
  };

  double period_s = 0;
  std::vector<LimitMargin> margins;  ///< margins in the order of time
  std::vector<Switch> switches;
  std::vector<EndDeflection> deflections;  ///< deflection at the end due to each switch
  /// Largest length of the fast (slow) part of end_norm DF W y, per unit of each part of y.
  Parts to_fast, to_slow;

  /// Whether the tube with these radii meets the conditions of the lemma. If so, for every y within t times
  /// the radii, t <= 1, both parts of end_norm (F(reference + W y) - F(reference) - DF W y) have at most the
  /// length deviation(radii) t^2. The conditions are then met also for all smaller radii.
  bool holds(const Parts& radii) const;

  /// Bound of the deviation at the end of the turn; infinite for radii for which holds() is false.
  Parts deviation(const Parts& radii) const;

 private:
  /// Window about one change of mode, for given radii.
  struct Window {
    double distance = 0, window_s = 0, deflection = 0;
  };
  std::optional<std::vector<Window>> windows(const Parts& radii) const;
  static std::optional<Window> window_of(const Switch& change, const Parts& radii,
                                         std::span<const Window> before);
  static double width(const Spread& spread, const Parts& radii, std::span<const Window> before);
};

}  // namespace rubsweep::integrate::exact::tube
