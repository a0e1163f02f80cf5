#pragma once

#include <algorithm>
#include <cmath>

#include "rubsweep/core/integrate/taylor/creep.hpp"
#include "rubsweep/core/numerics/taylor_series.hpp"

namespace rubsweep::integrate::taylor {

/// Variation of the sliding speed of a creeping contact, found by sweeps like the sliding speed itself.
class CreepTangent {
 public:
  /// Starts with a constant variation, its value at the start of the expansion.
  void begin(double sliding) {
    for (int k = 0; k <= numerics::most_taylor_order + 1; ++k) sliding_.set(k, k == 0 ? sliding : 0);
  }

  /// Sets the variation of the slip to the value that the varied friction requires, up to `order` terms.
  /// `holding(k)` and `load(k)` are the coefficients of the variations of this friction and of the spring
  /// force S. Friction is mu S, and the variation of mu is mu' times that of the sliding speed.
  template <class Holding, class Load>
  void sweep(const Creep& creep, int order, const Holding& holding, const Load& load) {
    for (int k = 0; k < order; ++k) {
      load_.set(k, load(k));
      double rest = holding(k) - creep.coefficient()[0] * load_[k];
      if (k > 0) {
        rest -= creep.coefficient()[k] * load_[0] + inner_sum(creep.coefficient(), load_, k) +
                creep.load()[k] * coefficient_[0] + inner_sum(creep.load(), coefficient_, k);
      }
      coefficient_.set(k, rest / creep.load()[0]);
      rest = coefficient_[k];
      if (k > 0) rest -= creep.slope()[k] * sliding_[0] + inner_sum(creep.slope(), sliding_, k);
      const double sliding = rest / creep.slope()[0];
      change_[k] = sliding - sliding_[k];
      sliding_.set(k, sliding);
    }
    order_ = order;
  }

  const numerics::Series& sliding() const { return sliding_; }
  /// Largest term of the change by the latest sweep, within `duration_rad`.
  double change(double duration_rad) const {
    double largest = 0, power = 1;
    for (int k = 0; k < order_; ++k, power *= duration_rad)
      largest = std::max(largest, power * std::abs(change_[k]));
    return largest;
  }

 private:
  int order_ = 0;
  numerics::Series sliding_, load_, coefficient_;
  double change_[numerics::most_taylor_order + 1];
};

}  // namespace rubsweep::integrate::taylor
