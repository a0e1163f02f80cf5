#include "rubsweep/integrate/exact/tube_spread.hpp"

#include <algorithm>
#include <cmath>

namespace rubsweep::integrate::exact {

TurnTube::Spread spread_of(const std::vector<double>& values, const PartSizes& base) {
  const auto length = [&values](std::size_t from, std::size_t to) {
    double square = 0;
    for (std::size_t i = from; i < to; ++i) square += values[i] * values[i];
    return std::sqrt(square);
  };
  TurnTube::Spread spread;
  spread.width = {length(0, base.fast), length(base.fast, base.all())};
  for (std::size_t i = base.all(); i < values.size(); ++i) spread.kicks.push_back(std::abs(values[i]));
  return spread;
}

TurnTube::Spread spread_over(const SeenByDisturbances& seen, const PartSizes& base, double duration_s) {
  std::vector<double> end = seen.value, bend = seen.curvature;
  for (std::size_t i = 0; i < end.size(); ++i) {
    end[i] += duration_s * seen.rate[i];
    bend[i] *= duration_s * duration_s / 2;
  }
  TurnTube::Spread spread = spread_of(seen.value, base);
  raise(spread, spread_of(end, base));
  const TurnTube::Spread bent = spread_of(bend, base);
  spread.width.fast += bent.width.fast;
  spread.width.slow += bent.width.slow;
  for (std::size_t i = 0; i < spread.kicks.size(); ++i) spread.kicks[i] += bent.kicks[i];
  return spread;
}

void raise(TurnTube::Spread& spread, const TurnTube::Spread& other) {
  spread.width.fast = std::max(spread.width.fast, other.width.fast);
  spread.width.slow = std::max(spread.width.slow, other.width.slow);
  for (std::size_t i = 0; i < spread.kicks.size() && i < other.kicks.size(); ++i)
    spread.kicks[i] = std::max(spread.kicks[i], other.kicks[i]);
}

}  // namespace rubsweep::integrate::exact
