#include "rubsweep/scene/unbalance.hpp"

#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/roots.hpp>
#include <cstdint>

namespace rubsweep::scene {

std::optional<double> eccentricity_reaching(double target_m, double bow_m, double slope,
                                            const std::function<double(double)>& excursion) {
  // excursion(e) >= slope e - bow: beyond `high` it is above the target for ever.
  const double high = (target_m + bow_m) / slope;
  if (high == 0) return 0;
  const auto excess = [&](double e) { return excursion(e) - target_m; };
  double low = 0;
  if (bow_m > target_m) {
    low = boost::math::tools::brent_find_minima(excess, 0.0, high, 40).first;
    if (excess(low) > 0) return std::nullopt;
  }
  if (excess(high) <= 0) return high;
  std::uintmax_t iterations = 400;  // four halve the bracket at least: it ends before
  const auto bracket = boost::math::tools::toms748_solve(
      excess, low, high, boost::math::tools::eps_tolerance<double>(52), iterations);
  return (bracket.first + bracket.second) / 2;
}

}  // namespace rubsweep::scene
