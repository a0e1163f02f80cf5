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

/// Unbalance of an analysis by API 617, by the mass in kg and the maximum continuous speed in rpm: four times
/// the largest residual unbalance.
inline constexpr double unbalance_g_mm_rpm_per_kg = 4 * 6350;

/// Whether a support holds nothing: by the name of its element in a file of another program, or because it is
/// a hundred times softer than the stiffest bearing.
bool is_seal(const model::RotorKit& kit, std::size_t support);

/// A bearing of a kit; seals are none.
struct Bearing {
  std::size_t support = 0;
  double position_m = 0;
  double static_load_n = 0;  ///< its share of the weight of the rotor, > 0 downwards
  Eigen::VectorXd x, y;      ///< n: what it is displaced by = x * q, y * q
};

/// A distribution of unbalance that API 617 asks the response to.
struct UnbalanceCase {
  std::string name;
  Eigen::VectorXcd unbalance_kg_m;  ///< n: at a speed w it forces w^2 Re(unbalance_kg_m e^{i w t})
};

/// A rotor in all coordinates of its finite elements, with what its unbalance response needs.
class WholeRotor {
 public:
  explicit WholeRotor(const model::Machine& machine);

  const linear::FreeRotor& rotor() const { return rotor_; }
  const std::vector<Bearing>& bearings() const { return bearings_; }
  /// Number of the place along the shaft next to a position; of a Jeffcott rotor its disc.
  Eigen::Index place(std::optional<double> position_m) const;
  /// Middle between the outer bearings, or of the shaft.
  Eigen::Index midspan() const;

  /// As the machine spreads it, with an eccentricity of 1 m.
  const Eigen::VectorXcd& configured_kg() const { return configured_kg_; }
  /// `configured` with an eccentricity; and of a kit four times the residual unbalance 6350 W / N g mm, N in
  /// rpm: at the largest deflection of its first undamped mode at rest (`mode 1`, W all its mass); at the
  /// largest deflections to either side of the second one (`mode 2`, in opposite phase, W the load of the
  /// bearing next to each); at each end beyond the bearings (`left end`, `right end`, W the mass that
  /// overhangs, as of a coupling).
  std::vector<UnbalanceCase> cases(double eccentricity_m, double max_continuous_hz) const;

  /// Amplitudes of the coordinates at a speed, a column for each of unbalance.
  Eigen::MatrixXcd response(const Eigen::MatrixXcd& unbalance_kg_m, double speed_hz) const;
  /// The largest force on a bearing in a turn, in newtons, of a column of the response.
  double bearing_force_n(const Bearing& bearing, const Eigen::VectorXcd& response, double speed_hz) const;

 private:
  Eigen::VectorXcd in_one_place(Eigen::Index place, double kg_m) const;
  void add_shaft(const model::RotorKit& kit);
  void weigh_overhangs(const model::RotorKit& kit);

  model::Machine machine_;
  linear::FreeRotor rotor_;
  Eigen::VectorXcd configured_kg_;
  std::vector<Bearing> bearings_;
  Eigen::VectorXd first_, second_;  ///< deflections of the first undamped modes over the places; may be empty
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
  /// Full major axis at a place of the rotor.
  double major_axis(double speed_hz, Eigen::Index place, Eigen::Index column = 0);

 private:
  const WholeRotor& rotor_;
  Eigen::MatrixXcd unbalance_kg_m_;
  std::map<double, Eigen::MatrixXcd> known_;
};

}  // namespace rubsweep::design
