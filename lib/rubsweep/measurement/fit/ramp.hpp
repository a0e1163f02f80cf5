#pragma once

#include <utility>
#include <vector>

namespace rubsweep::fit {

/// Shaft angle phi = 2 pi (from_hz t + rate_hz_per_s t^2 / 2); or, of a speed that changes unevenly, straight
/// lines between the speeds at ascending instants, of which the first and last go on beyond them.
struct Ramp {
  double from_hz = 0;
  double rate_hz_per_s = 0;
  std::vector<double> knot_s{}, knot_hz{};  ///< empty, or two or more of each

  bool even() const { return knot_s.empty(); }
};
double speed_hz(const Ramp& ramp, double t_s);

/// Speed and angle of the shaft over time, in radians; the angle is 0 at t = 0, or at the first knot.
class RampTurning {
 public:
  explicit RampTurning(const Ramp& ramp);

  double speed(double t_s) const;  ///< rad/s
  double gain(double t_s) const;   ///< rate of the speed, rad/s^2
  double angle(double t_s) const;
  double most_gain() const { return most_gain_; }  ///< largest size of the rate

  /// Lowest and highest speed between two instants: at one of them or at a knot.
  std::pair<double, double> speeds_between(double from_s, double to_s) const;

 private:
  Ramp ramp_;
  std::vector<double> turns_;  ///< at the knots
  double most_gain_ = 0;
};

}  // namespace rubsweep::fit
