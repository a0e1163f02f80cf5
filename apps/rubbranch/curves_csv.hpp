#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "rubsweep/analysis/branch/curves/curve.hpp"

namespace rubsweep::apps {

/// A curve and the event at which it starts.
struct CurveFrom {
  branch::curves::Curve curve;
  std::size_t branch = 0;
  std::size_t event = 0;  ///< row in events.csv, counted from 0
};

/// Lines beginning with `#` for both files: names of the parameters, and how each curve ends.
std::string curve_comments(const std::string& parameter, const std::string& curve_parameter,
                           const std::vector<CurveFrom>& curves);

/// Header, and a row for every point: curve by curve, in ascending arclength.
std::string curves_csv(const std::vector<CurveFrom>& curves);

/// Header, and a row for every point where curves meet, in the same order.
std::string meetings_csv(const std::vector<CurveFrom>& curves);

/// Summary for a terminal: the extent of each curve, and the points where curves meet.
std::string curves_summary(const std::string& parameter, const std::string& curve_parameter,
                           const std::vector<CurveFrom>& curves);

}  // namespace rubsweep::apps
