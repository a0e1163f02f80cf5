#pragma once

#include <cmath>
#include <numbers>

namespace rubsweep::response::proof {

/// Test for linear convergence of a transient to its orbit: counts successive returns that the derivative of
/// the return map predicts to within a tenth of what a return gains. The error is of second order in the
/// distance, so that it is less nearer by: where several returns in a row pass and half of the distance is
/// gone, the transient is on its way to the orbit.
/// Beside a fold or a torus bifurcation an orbit attracts by next to nothing, and the error may be larger for
/// long: it speeds the approach up, or turns it by an angle that goes with the distance, so that the
/// predicted point is far off and yet as near to the orbit. There as many returns in a row count as halve the
/// distance at the promised rate, each of which gained nine tenths of that or more. A transient behind the
/// unstable orbit or torus of that bifurcation gains nothing.
class LinearConvergenceTest {
 public:
  /// `in_a_row`: number of returns, or turns of them, that have to be predicted.
  explicit LinearConvergenceTest(int in_a_row) : in_a_row_(in_a_row) {}

  /// One more return, or turn of one, which came `error` off from the prediction, from `distance` away in a
  /// norm that the derivative multiplies by `contraction` or less, 0 < contraction < 1.
  void add_prediction(double error, double distance, double contraction) {
    predicted_ = error <= predicted_within * (1 - contraction) * distance ? predicted_ + 1 : 0;
  }
  /// One more return, which came from `before` to `now` away in such a norm.
  void add_contraction(double before, double now, double contraction) {
    gained_ = before - now >= gained_at_least * (1 - contraction) * before ? gained_ + 1 : 0;
    halving_ = std::numbers::ln2 / -std::log(contraction);
  }

  /// Whether the test is passed now that `distance` is left of `first`.
  bool passed(double distance, double first) const {
    const bool on_its_way = predicted_ >= in_a_row_ || (gained_ > 0 && gained_ >= halving_);
    return on_its_way && distance < followed_down * first;
  }

 private:
  static constexpr double followed_down = 0.5, predicted_within = 0.1, gained_at_least = 0.9;

  int in_a_row_, predicted_ = 0, gained_ = 0;
  double halving_ = 0;
};

}  // namespace rubsweep::response::proof
