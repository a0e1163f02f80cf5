#pragma once

#include <Eigen/Core>
#include <vector>

#include "rubsweep/core/numerics/exponential_series.hpp"
#include "rubsweep/core/numerics/pair_flow.hpp"

namespace rubsweep::numerics {

/// Taylor coefficients of the flows of pairs, x = fastest t: with the generator G of pair j
/// e^{G t} = sum_k x^k (unit(j, k) 1 + generator(j, k) G).
struct PairSeries {
  Eigen::Array<double, Eigen::Dynamic, most_series_terms> unit, generator;
};

/// `fastest_rad_per_s`: a unit of time in which no pair is fast, so that |x| <= longest_series suffices.
PairSeries pair_series(const std::vector<Pair>& generators, double fastest_rad_per_s);

}  // namespace rubsweep::numerics
