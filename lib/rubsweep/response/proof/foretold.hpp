#pragma once

#include <cmath>
#include <numbers>

namespace rubsweep::response::proof {

/// Counts returns of a transient that came to what the derivative of its orbit says of them, up to a tenth of
/// what a return gains. What is off is of second order in the distance, so that nearer by it is less: where
/// several in a row came so and half of the distance is gone, the transient is on its way to the orbit.
/// Where an orbit attracts by next to nothing, beside a fold or a torus bifurcation, what is off may be more
/// for long: it speeds the approach up, or turns it by an angle that goes with the distance, so that what the
/// derivative tells is far off and yet as near to the orbit. There as many returns in a row count as halve
/// the distance by what the orbit promises, each of which gained nine tenths of that or more. A transient
/// behind the unstable orbit or torus of that bifurcation gains nothing.
class Foretold {
 public:
  /// `in_a_row`: so many returns, or turns of them, have to be told.
  explicit Foretold(int in_a_row) : wanted_(in_a_row) {}

  /// One more return, or turn of one, which came `error` off from what the derivative says, from `distance`
  /// away in a norm that it multiplies by `contraction` or less, 0 < contraction < 1.
  void add_told(double error, double distance, double contraction) {
    told_ = error <= told_within * (1 - contraction) * distance ? told_ + 1 : 0;
  }
  /// One more return, which came from `before` to `now` away in such a norm.
  void add_gain(double before, double now, double contraction) {
    gained_ = before - now >= gained_at_least * (1 - contraction) * before ? gained_ + 1 : 0;
    halving_ = std::numbers::ln2 / -std::log(contraction);
  }

  /// Now that `distance` is left of `first`.
  bool holds(double distance, double first) const {
    const bool on_its_way = told_ >= wanted_ || (gained_ > 0 && gained_ >= halving_);
    return on_its_way && distance < followed_down * first;
  }

 private:
  static constexpr double followed_down = 0.5, told_within = 0.1, gained_at_least = 0.9;

  int wanted_, told_ = 0, gained_ = 0;
  double halving_ = 0;
};

}  // namespace rubsweep::response::proof
