#pragma once

#include <optional>

#include "rubsweep/basin/label_grid.hpp"

namespace rubsweep::basin {

/// Growth of the share f of uncertain boxes, those that hold more than one label, with their side e: f ~
/// e^exponent. The dimension of the boundary is that of the plane less this (McDonald, Grebogi, Ott and Yorke
/// 1985). 1: a line; near 0: a better knowledge of the start hardly helps.
struct UncertaintyExponent {
  double value = 0;
  double standard_error = 0;  ///< of the straight line through log f over log e
};

/// Exponent from boxes of 2, 3, 5, 9, ... points a side (1, 2, 4, 8, ... steps), up to a quarter of the
/// shorter side. Empty where fewer than three sizes have an uncertain box and a certain one.
std::optional<UncertaintyExponent> uncertainty_exponent(const LabelGrid& grid);

}  // namespace rubsweep::basin
