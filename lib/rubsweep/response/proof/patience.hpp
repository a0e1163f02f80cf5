#pragma once

#include <algorithm>
#include <cmath>

namespace rubsweep::response::proof {

/// Turns (or returns) that following a transient towards an orbit may take: three times what the norm
/// promises near the orbit, and some at the start, where the transient is not yet near.
struct Patience {
  double start = 0;
  double most = 0;

  /// Limit where the norm promises to get as near as it must in `promised` turns.
  double turns(double promised) const { return std::min(most, start + times_promised * promised); }
  /// Up to `now`, from `first` away, in a norm that every turn multiplies by `contraction` or less: a
  /// transient that is not as near by then is on its way to somewhere else.
  double turns(double contraction, double first, double now) const {
    return turns(std::log(std::max(1.0, first / now)) / -std::log(contraction));
  }

 private:
  static constexpr double times_promised = 3;
};

}  // namespace rubsweep::response::proof
