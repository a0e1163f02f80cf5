#include "rubsweep/core/numerics/pair_series.hpp"

namespace rubsweep::numerics {

/// By Cayley and Hamilton, G^2 = trace G - determinant: every power of G is some of 1 and some of G.
PairSeries pair_series(const std::vector<Pair>& generators, double fastest_rad_per_s) {
  const auto count = static_cast<Eigen::Index>(generators.size());
  PairSeries series;
  series.unit.setZero(count, most_series_terms);
  series.generator.setZero(count, most_series_terms);
  for (Eigen::Index j = 0; j < count; ++j) {
    const Pair& g = generators[static_cast<std::size_t>(j)];
    const double trace = (g.uu + g.vv) / fastest_rad_per_s;
    const double determinant = (g.uu * g.vv - g.uv * g.vu) / (fastest_rad_per_s * fastest_rad_per_s);
    double unit = 1, generator = 0;  // of G^k / k!, time in units of 1 / fastest
    for (std::size_t k = 0; k < most_series_terms; ++k) {
      series.unit(j, static_cast<Eigen::Index>(k)) = unit;
      series.generator(j, static_cast<Eigen::Index>(k)) = generator / fastest_rad_per_s;
      const double last = generator;
      generator = reciprocals[k + 1] * (unit + trace * last);
      unit = -reciprocals[k + 1] * determinant * last;
    }
  }
  return series;
}

}  // namespace rubsweep::numerics
