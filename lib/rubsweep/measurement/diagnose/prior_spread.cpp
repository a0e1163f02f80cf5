#include "rubsweep/measurement/diagnose/prior_spread.hpp"

#include <cmath>

namespace rubsweep::diagnose {

double value_at(const Spread& spread, double unit) {
  if (spread.low == spread.high) return spread.low;
  if (!spread.logarithmic) return spread.low + (spread.high - spread.low) * unit;
  return spread.low * std::pow(spread.high / spread.low, unit);
}

}  // namespace rubsweep::diagnose
