#include "rubsweep/integrate/exact/tube_spread.hpp"

#include <algorithm>
#include <cmath>

namespace rubsweep::integrate::exact {

TurnTube::Spread spread_of(const std::vector<double>& values, std::size_t base) {
  TurnTube::Spread spread;
  for (std::size_t i = 0; i < base; ++i) spread.width += values[i] * values[i];
  spread.width = std::sqrt(spread.width);
  for (std::size_t i = base; i < values.size(); ++i) spread.kicks.push_back(std::abs(values[i]));
  return spread;
}

TurnTube::Spread spread_over(const SeenByDisturbances& seen, std::size_t base, double duration_s) {
  std::vector<double> end = seen.value, bend = seen.curvature;
  for (std::size_t i = 0; i < end.size(); ++i) {
    end[i] += duration_s * seen.rate[i];
    bend[i] *= duration_s * duration_s / 2;
  }
  TurnTube::Spread spread = spread_of(seen.value, base);
  raise(spread, spread_of(end, base));
  const TurnTube::Spread bent = spread_of(bend, base);
  spread.width += bent.width;
  for (std::size_t i = 0; i < spread.kicks.size(); ++i) spread.kicks[i] += bent.kicks[i];
  return spread;
}

void raise(TurnTube::Spread& spread, const TurnTube::Spread& other) {
  spread.width = std::max(spread.width, other.width);
  for (std::size_t i = 0; i < spread.kicks.size() && i < other.kicks.size(); ++i)
    spread.kicks[i] = std::max(spread.kicks[i], other.kicks[i]);
}

}  // namespace rubsweep::integrate::exact
