#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "rubsweep/maps/sweep/grid.hpp"

namespace rubsweep::sweep {

/// Outcome of one start, as far as attractors are told apart.
struct SampledMotion {
  std::string name;  ///< class and order
  bool failed = false;
  bool rubs = false;
  bool repeats = false;         ///< else the numbers depend on when one looks, and the name alone counts
  std::vector<double> orbit_m;  ///< lengths of its orbit, the largest first
};

/// One attractor, or all motions of a name that never repeat.
struct Attractor {
  SampledMotion motion;  ///< motion of the first start that led there
  std::size_t samples = 0;
  double share = 0;           ///< share of all starts, failed ones among them
  double standard_error = 0;  ///< sqrt(share (1 - share) / starts)
};

/// Attractors of all starts; the most frequent first, of equally frequent ones the one that was met first.
struct Basins {
  std::vector<Attractor> attractors;
  std::vector<int> numbers;  ///< attractor that each start led to, from 1; 0: its run failed
  std::size_t failed = 0;    ///< starts whose run failed; they count among the starts and to no attractor
};

/// Tells attractors apart, a start at a time: orbits are one attractor when their names are equal and no
/// length differs by more than a thousandth of the largest one. Keeps one orbit for each attractor.
class AttractorCount {
 public:
  void add(SampledMotion motion);

  /// All that were added.
  Basins basins() const;

 private:
  Basins met_;  ///< basins in the order in which they are met, without shares
};

/// A key of the configuration that is drawn evenly between two numbers, or evenly between their logarithms.
struct DrawnKey {
  std::string key;
  double from = 0, to = 0;
  bool logarithmic = false;
};

/// Which starts a study of basins draws in every cell: points of low discrepancy in the box of the keys, the
/// same ones in every cell.
struct BasinSampling {
  std::size_t samples = 0;
  std::vector<DrawnKey> over;  ///< keys that are drawn, at least one
};

/// The numbers of sample `index`, from 0.
std::vector<KeyValue> draw(const BasinSampling& sampling, std::size_t index);

/// Runs every sample and counts the attractors.
Basins sample_basins(const BasinSampling& sampling,
                     const std::function<SampledMotion(const std::vector<KeyValue>&)>& run);

}  // namespace rubsweep::sweep
