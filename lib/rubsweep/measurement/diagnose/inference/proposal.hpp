#pragma once

#include <Eigen/Core>
#include <vector>

#include "rubsweep/measurement/diagnose/candidate.hpp"
#include "rubsweep/measurement/diagnose/random_stream.hpp"

namespace rubsweep::diagnose::inference {

/// Density in the unit cube of a candidate's unknowns that is high near cases which resemble the recording:
/// Gaussian kernels whose variances are twice those of the cases (Beaumont, Cornuet, Marin, Robert 2009),
/// folded back at the faces of the cube. Known numbers stay as they are.
class Proposal {
 public:
  /// `weight` of each centre; not all zero.
  Proposal(const Candidate& candidate, std::vector<Point> centres, std::vector<double> weight);

  Point draw(RandomStream& random) const;

  /// Relative to that of the prior, which is 1 everywhere.
  double density(const Point& unit) const;

 private:
  std::vector<std::size_t> unknown_;  ///< numbers that are not known
  std::vector<Point> centres_;
  std::vector<double> weight_;  ///< add up to 1
  Point deviation_{};
};

}  // namespace rubsweep::diagnose::inference
