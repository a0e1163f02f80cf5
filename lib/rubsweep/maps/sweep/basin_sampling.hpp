#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "rubsweep/maps/sweep/grid.hpp"

namespace rubsweep::sweep {

/// Outcome of one start: the facts that distinguish attractors.
struct SampledMotion {
  std::string name;  ///< class and order
  bool failed = false;
  bool rubs = false;
  bool repeats = false;         ///< false: the numbers vary with time, so that only the name is compared
  std::vector<double> orbit_m;  ///< lengths that describe the orbit, the largest first
};

/// One attractor, or all motions of the same name that never repeat.
struct Attractor {
  SampledMotion motion;  ///< motion of the first start that led there
  std::size_t samples = 0;
  double share = 0;           ///< share of all starts, including failed ones
  double standard_error = 0;  ///< sqrt(share (1 - share) / starts)
};

/// Attractors of all starts, the most frequent first; equally frequent ones in the order of discovery.
struct Basins {
  std::vector<Attractor> attractors;
  std::vector<int> numbers;  ///< attractor that each start led to, from 1; 0: its run failed
  std::size_t failed = 0;    ///< starts whose run failed; part of the total, but of no attractor
};

/// Counts attractors, one start at a time. Two motions belong to one attractor if their names are equal and
/// no length differs by more than a thousandth of the largest one. Keeps one orbit for each attractor.
class AttractorCount {
 public:
  void add(SampledMotion motion);

  /// Attractors of all motions that were added.
  Basins basins() const;

 private:
  Basins met_;  ///< basins in the order of discovery, without shares
};

/// Key of the configuration whose values are drawn with uniform density between two numbers, or between their
/// logarithms.
struct DrawnKey {
  std::string key;
  double from = 0, to = 0;
  bool logarithmic = false;
};

/// Starts that a study of basins tries in every cell, the same in all cells: points of low discrepancy in the
/// box that the keys span.
struct BasinSampling {
  std::size_t samples = 0;
  std::vector<DrawnKey> over;  ///< keys that are drawn, at least one
};

/// Values of the drawn keys for sample `index`, counted from 0.
std::vector<KeyValue> draw(const BasinSampling& sampling, std::size_t index);

/// Runs every sample and counts the attractors.
Basins sample_basins(const BasinSampling& sampling,
                     const std::function<SampledMotion(const std::vector<KeyValue>&)>& run);

}  // namespace rubsweep::sweep
