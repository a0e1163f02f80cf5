#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "rubsweep/maps/sweep/attractors.hpp"
#include "rubsweep/maps/sweep/key_axis.hpp"

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

/// The numbers of sample `index`, from 0.
std::vector<KeyValue> draw(const BasinSampling& sampling, std::size_t index);

/// Runs every sample and counts the attractors.
Basins sample_basins(const BasinSampling& sampling,
                     const std::function<SampledMotion(const std::vector<KeyValue>&)>& run);

}  // namespace rubsweep::sweep
