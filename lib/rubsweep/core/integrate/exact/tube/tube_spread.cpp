#include "rubsweep/core/integrate/exact/tube/tube_spread.hpp"

#include <algorithm>
#include <cmath>

#include "rubsweep/core/numerics/twin.hpp"

namespace rubsweep::integrate::exact::tube {

TurnTube::Spread spread_of(const std::vector<double>& values, const PartSizes& base) {
  const auto length = [&values](std::size_t from, std::size_t to) {
    double square = 0;
    for (std::size_t i = from; i < to; ++i) square += values[i] * values[i];
    return std::sqrt(square);
  };
  TurnTube::Spread spread;
  spread.width = {length(0, base.fast), length(base.fast, base.all())};
  spread.deflections.reserve(values.size() - base.all());
  for (std::size_t i = base.all(); i < values.size(); ++i) spread.deflections.push_back(std::abs(values[i]));
  return spread;
}

TurnTube::Spread spread_over(const modes::ModalSums& seen, const PartSizes& base, double duration_s) {
  const double half_square = duration_s * duration_s / 2;
  const auto end = [&](std::size_t i) { return seen.value[i] + duration_s * seen.rate[i]; };
  const auto width = [&](std::size_t from, std::size_t to) {
    numerics::Twin at_ends{};
    double bent = 0;
    for (std::size_t i = from; i < to; ++i) {
      const numerics::Twin at{seen.value[i], end(i)};
      at_ends += at * at;
      bent += seen.curvature[i] * seen.curvature[i];
    }
    return std::sqrt(std::max(at_ends[0], at_ends[1])) + half_square * std::sqrt(bent);
  };
  TurnTube::Spread spread;
  spread.width = {width(0, base.fast), width(base.fast, base.all())};
  spread.deflections.reserve(seen.value.size() - base.all());
  for (std::size_t i = base.all(); i < seen.value.size(); ++i)
    spread.deflections.push_back(std::max(std::abs(seen.value[i]), std::abs(end(i))) +
                                 half_square * std::abs(seen.curvature[i]));
  return spread;
}

void raise(TurnTube::Spread& spread, const TurnTube::Spread& other) {
  spread.width.fast = std::max(spread.width.fast, other.width.fast);
  spread.width.slow = std::max(spread.width.slow, other.width.slow);
  for (std::size_t i = 0; i < spread.deflections.size() && i < other.deflections.size(); ++i)
    spread.deflections[i] = std::max(spread.deflections[i], other.deflections[i]);
}

}  // namespace rubsweep::integrate::exact::tube
