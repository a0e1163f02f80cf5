#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "rubsweep/sweep/key_axis.hpp"

namespace rubsweep::sweep {

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
  std::vector<DrawnKey> over;  ///< at least one
};

/// What one sample led to, as far as attractors are told apart.
struct SampledMotion {
  std::string name;  ///< class and order
  bool failed = false;
  bool rubs = false;
  bool repeats = false;         ///< else the numbers depend on when one looks, and the name alone counts
  std::vector<double> orbit_m;  ///< lengths of its orbit, the largest first
};

/// One attractor, or all motions of a name that never repeat.
struct Attractor {
  SampledMotion motion;  ///< of the first sample that led there
  std::size_t samples = 0;
  double share = 0;           ///< of the samples
  double standard_error = 0;  ///< sqrt(share (1 - share) / samples drawn)
};

/// What the samples of a cell led to; the most frequent first.
struct Basins {
  std::vector<Attractor> attractors;
  std::size_t failed = 0;  ///< samples whose run failed; they count among the samples and to no attractor
};

/// The numbers of sample `index`, from 0.
std::vector<KeyValue> draw(const BasinSampling& sampling, std::size_t index);

/// Runs every sample and counts. Orbits are one attractor when their names are equal and no length differs by
/// more than a thousandth of the largest one.
Basins sample_basins(const BasinSampling& sampling,
                     const std::function<SampledMotion(const std::vector<KeyValue>&)>& run);

}  // namespace rubsweep::sweep
