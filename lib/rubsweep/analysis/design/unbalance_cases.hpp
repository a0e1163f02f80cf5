#pragma once

#include <Eigen/Core>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "rubsweep/analysis/linear/whirl_modes.hpp"
#include "rubsweep/core/model/machine.hpp"

namespace rubsweep::design {

/// Unbalance of an analysis by API 617: four times the largest residual unbalance. To be multiplied by the
/// mass in kg and divided by the maximum continuous speed in rpm.
inline constexpr double unbalance_g_mm_rpm_per_kg = 4 * 6350;

/// A bearing of a kit; seals do not count as bearings.
struct Bearing {
  std::size_t support = 0;
  double position_m = 0;
  double static_load_n = 0;  ///< static load from the weight of the rotor, > 0 downwards
  Eigen::VectorXd x, y;      ///< n: displacement of the rotor at the bearing is x * q, y * q
};

/// A distribution of unbalance for which API 617 requires the response.
struct UnbalanceCase {
  std::string name;
  Eigen::VectorXcd unbalance_kg_m;  ///< n: at a speed w the force is w^2 Re(unbalance_kg_m e^{i w t})
};

/// A rotor in all coordinates of its finite elements, with the data for its unbalance response.
class WholeRotor {
 public:
  explicit WholeRotor(const model::Machine& machine);

  const linear::FreeRotor& rotor() const { return rotor_; }
  const std::vector<Bearing>& bearings() const { return bearings_; }
  /// Index of the place along the shaft nearest to a position; for a Jeffcott rotor, the disc.
  Eigen::Index place(std::optional<double> position_m) const;
  /// Index of the place midway between the outer bearings, or at the middle of the shaft.
  Eigen::Index midspan() const;

  /// Unbalance as distributed in the configuration, with an eccentricity of 1 m.
  const Eigen::VectorXcd& configured_kg() const { return configured_kg_; }
  /// The case `configured` with an eccentricity. For a kit also cases with four times the residual unbalance
  /// 6350 W / N g mm (N in rpm). `mode 1`: at the largest deflection of the first undamped mode at rest, with
  /// W the total mass. `mode 2`: in opposite phase at the largest deflections to either side of the second
  /// mode, each with W the load of the nearest bearing. `left end`, `right end`: at each end beyond the
  /// bearings, as of a coupling, with W the overhung mass.
  std::vector<UnbalanceCase> cases(double eccentricity_m, double max_continuous_hz) const;

  /// Amplitudes of the coordinates at a speed, one column for each column of unbalance.
  Eigen::MatrixXcd response(const Eigen::MatrixXcd& unbalance_kg_m, double speed_hz) const;
  /// Largest force on a bearing during a turn, in newtons, for one column of the response.
  double bearing_force_n(const Bearing& bearing, const Eigen::VectorXcd& response, double speed_hz) const;

 private:
  Eigen::VectorXcd in_one_place(Eigen::Index place, double kg_m) const;
  void add_shaft(const model::RotorKit& kit);
  void weigh_overhangs(const model::RotorKit& kit);

  model::Machine machine_;
  linear::FreeRotor rotor_;
  Eigen::VectorXcd configured_kg_;
  std::vector<Bearing> bearings_;
  Eigen::VectorXd first_, second_;  ///< deflections of the first two undamped modes at the places, or empty
  Eigen::VectorXd mass_kg_;         ///< share of the weight of each place
  double left_kg_ = 0, right_kg_ = 0;  ///< masses that overhang the outer bearings
  double whole_mass_kg_ = 0;
  Eigen::Index band_ = 0;
};

/// Responses of a rotor by the speed, kept: peaks of one column ask for speeds at which others were asked.
class Responses {
 public:
  /// `unbalance_kg_m`: a column for each of unbalance. The rotor must outlive this.
  Responses(const WholeRotor& rotor, Eigen::MatrixXcd unbalance_kg_m)
      : rotor_(rotor), unbalance_kg_m_(std::move(unbalance_kg_m)) {}

  const WholeRotor& rotor() const { return rotor_; }
  const Eigen::MatrixXcd& at(double speed_hz);
  /// Full major axis at a place of the rotor; 0 at a node, where the motion is rounding alone.
  double major_axis(double speed_hz, Eigen::Index place, Eigen::Index column = 0);

 private:
  const WholeRotor& rotor_;
  Eigen::MatrixXcd unbalance_kg_m_;
  std::map<double, Eigen::MatrixXcd> known_;
};

}  // namespace rubsweep::design
