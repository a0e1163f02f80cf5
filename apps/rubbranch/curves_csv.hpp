#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "rubsweep/analysis/branch/curves/curve.hpp"

namespace rubsweep::apps {

/// A curve and the event that it starts from.
struct CurveFrom {
  branch::curves::Curve curve;
  std::size_t branch = 0;
  std::size_t event = 0;  ///< row of events.csv, from 0
};

/// `#` lines of both files: which the parameters are, and how each curve ends.
std::string curve_comments(const std::string& parameter, const std::string& curve_parameter,
                           const std::vector<CurveFrom>& curves);

/// Header and a row for every point, curve by curve, by ascending arclength.
std::string curves_csv(const std::vector<CurveFrom>& curves);

/// Header and a row for every meeting, the same way.
std::string meetings_csv(const std::vector<CurveFrom>& curves);

/// Summary for a terminal: the extent of each curve, and its meetings.
std::string curves_summary(const std::string& parameter, const std::string& curve_parameter,
                           const std::vector<CurveFrom>& curves);

}  // namespace rubsweep::apps
