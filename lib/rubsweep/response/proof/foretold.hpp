#pragma once

namespace rubsweep::response::proof {

/// Counts returns of a transient that came to what the derivative of its orbit says of them, up to a tenth of
/// what a return gains. What is off is of second order in the distance, so that nearer by it is less: where
/// several in a row came so and half of the distance is gone, the transient is on its way to the orbit.
class Foretold {
 public:
  /// `in_a_row`: that many returns are asked for.
  explicit Foretold(int in_a_row) : wanted_(in_a_row) {}

  /// One more return, which came `error` off from what the derivative says, from `distance` away in a norm
  /// that every return multiplies by `contraction` or less.
  void add(double error, double distance, double contraction) {
    const bool so = error <= told_within * (1 - contraction) * distance;
    in_a_row_ = so ? in_a_row_ + 1 : 0;
  }

  /// Now that `distance` is left of `first`.
  bool holds(double distance, double first) const {
    return in_a_row_ >= wanted_ && distance < followed_down * first;
  }

 private:
  static constexpr double followed_down = 0.5, told_within = 0.1;

  int wanted_, in_a_row_ = 0;
};

}  // namespace rubsweep::response::proof
