#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "rubsweep/core/integrate/run/turn.hpp"
#include "rubsweep/core/response/proof/periodic_orbit.hpp"
#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::response::rotating {

/// Watches a transient of a rotationally symmetric scene for signs of a closed orbit in the rotating frame:
/// the states at maxima of |z| of the observed point, seen in the rotating frame, then return.
class ApexReturnSearch {
 public:
  explicit ApexReturnSearch(const scene::Scene& scene);

  /// Adds one more turn, which must have samples.
  void add(const integrate::run::TurnReport& turn);

  /// Number of maxima in the latest turn.
  int maxima_in_turn() const { return in_turn_; }

  struct Return {
    int maxima = 0;                   ///< number of maxima after which the last one returned
    std::vector<double> periods_rad;  ///< ascending; last: time of the return, before it: fractions of it
                                      ///< after which the transient is within `farthest_orbit` (linear
                                      ///< interpolation)
  };

  /// Return in the latest turn that is worth a proof; usually empty.
  std::optional<Return> candidate() const;

  /// Excludes a candidate that could not be proven.
  void refuse(const Return& candidate);

 private:
  struct Maximum {
    double phase_rad = 0;  ///< phase since the first turn
    Eigen::VectorXd state;
  };

  void add_maximum(const double* before, const double* here, double share, double phase_before_rad,
                   double spacing_rad, bool touched);
  const Maximum& maximum(int ago) const {
    return maxima_[maxima_.size() - 1 - static_cast<std::size_t>(ago)];
  }

  Eigen::Matrix<double, 2, Eigen::Dynamic> map_;
  Eigen::Index states_;
  proof::PeriodSearch returns_;
  long turns_ = 0;
  int in_turn_ = 0;
  std::vector<double> last_;  ///< sample before the turn; empty at the start
  std::vector<Maximum> maxima_;
};

}  // namespace rubsweep::response::rotating
