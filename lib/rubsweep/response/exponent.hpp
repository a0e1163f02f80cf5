#pragma once

#include <optional>
#include <span>
#include <vector>

#include "rubsweep/response/motion/motion.hpp"
#include "rubsweep/response/proof/section_map.hpp"

namespace rubsweep::response {

/// A second state that follows a base state through the same map, always pulled back to a small distance.
/// G. Benettin, L. Galgani, J.-M. Strelcyn, Phys. Rev. A 14 (1976) 2338: the mean of ln(distance /
/// separation) tends to the largest exponent.
class Companion {
 public:
  /// Distance that the companion is pulled back to, in the units of the state (sections: of the clearance).
  /// Between 1e-9 and 1e-4 it moves no exponent of the one-side map visibly (tolerance 1e-8). Far below the
  /// tolerance the solver's noise parts the states, not the motion: at tolerance 1e-5 separation 1e-6 shows
  /// exponents of +2 where there is rest, separation 1e-5 does not.
  static constexpr double separation = 1e-5;

  /// Starts at that distance in a direction with a share of every coordinate: one along a coordinate axis
  /// would never leave an invariant subspace, such as the tangential motion at a flat wall.
  explicit Companion(std::span<const double> base);

  /// To be advanced by one iteration, as the base is.
  std::span<double> state() { return state_; }

  /// ln(distance from the base / separation), then pulls back along the line to the base. A distance lost in
  /// rounding counts as 1e-15, and the companion starts anew.
  double pull_back(std::span<const double> base);

 private:
  void start(std::span<const double> base);

  std::vector<double> state_;
};

/// Exponent from its contributions, one per iteration. The first fifth is dropped (the companion turns into
/// the direction of largest growth), the rest makes 8 blocks of equal length with means m_b, each weighted by
/// a Hann window: exponent = mean m, error bar = t s / sqrt(8), s the standard deviation of the m_b, t
/// = 3.4995 (Student, 7 degrees of freedom, 99 %). The method of batch means (A. M. Law, Simulation Modeling
/// and Analysis) with smooth weights: on a torus or a periodic motion the contributions oscillate about their
/// mean, which a flat block cuts off anywhere and a smooth one averages out (S. Das et al., Nonlinearity 30
/// (2017) 4111); the bars of such motions are ten to a hundred times shorter, those of chaotic ones 1.2 times
/// longer. SolverError for fewer than 40 contributions.
motion::Exponent exponent_of(std::span<const double> contributions);

/// Exponent of the motion from `state` over `iterations`; empty when the map fails.
std::optional<motion::Exponent> largest_exponent(const proof::SectionMap& map, std::vector<double> state,
                                                 int iterations);

}  // namespace rubsweep::response
