#include "rubsweep/diagnose/inference/density_of_size.hpp"

#include <algorithm>
#include <cmath>

namespace rubsweep::diagnose::inference {
namespace {

/// Least width of an interval in which a length may lie: cases have any size, and must find place in it.
constexpr double least_decades = 0.08;

bool inside(const Spread& spread, double value) { return value >= spread.low && value <= spread.high; }

double decades(const Spread& spread) { return std::log10(spread.high / spread.low); }

Spread widened(const Spread& spread) {
  const double factor = std::pow(10, std::max(0.0, least_decades - decades(spread)) / 2);
  return {spread.low / factor, spread.high * factor, true};
}

/// Share of the whirl ratios at which a quiet whirl of this radius is one in a clearance of the range. Its
/// shape is the same at all of them.
double share_of_whirl_ratios(const Spread& ratios, const Spread& clearances, double radius_m) {
  const double low = std::max(ratios.low, radius_m / clearances.high),
               high = std::min(ratios.high, radius_m / clearances.low);
  return low < high ? decades({low, high}) / decades(ratios) : 0;
}

}  // namespace

double density_of_size(const DiagnosisProblem& problem, const SimulatedCase& one, double case_size_m,
                       double seen_size_m) {
  const Candidate& candidate = problem.candidates[one.candidate];
  const double clearance = simulated_clearance_m(candidate) * seen_size_m / case_size_m;
  const Spread clearances = widened(candidate.clearance_m);
  double density = inside(clearances, clearance) ? 1 : 0;
  if (candidate.cause == Cause::no_rub)
    density =
        share_of_whirl_ratios(spread_of(candidate, Unknown::whirl_ratio), clearances,
                              clearance * value_of(values_at(candidate, one.unit), Unknown::whirl_ratio));
  if (!problem.eccentricity_m) return density;
  const Spread eccentricities = widened(*problem.eccentricity_m);
  if (!inside(eccentricities, one.motion.eccentricity_m * seen_size_m / case_size_m)) return 0;
  return density * decades(clearances) / decades(eccentricities);
}

}  // namespace rubsweep::diagnose::inference
