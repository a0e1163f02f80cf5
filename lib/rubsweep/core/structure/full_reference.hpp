#pragma once

#include <optional>
#include <vector>

#include "rubsweep/core/structure/assembly.hpp"
#include "rubsweep/core/structure/lateral_system.hpp"
#include "rubsweep/core/structure/reduction.hpp"

namespace rubsweep::structure {

/// Resonances move with the last digits of a frequency, and a load away from all attachment modes is followed
/// by the modes alone: there a difference counts by this share.
inline constexpr double share_beside = 0.2;

/// Judge of reductions of one kit: its full matrices, answered once by direct solution, with dampers, cross
/// terms, gyroscopic moments and damping that turns.
class FullReference {
 public:
  /// Responses in x and y at `responses_m`; forces at `forces_m`, and beside them at `loads_m` and where the
  /// shaft has unbalance, whose responses are compared among themselves.
  FullReference(const BeamShaft& shaft, const model::RotorKit& kit, std::vector<double> responses_m,
                std::vector<double> forces_m, std::vector<double> loads_m);

  /// Worst difference of a receptance up to kit.modes_up_to_hz, for each place of a force against its largest
  /// within a fifth of the frequency: at rest, turning with the force, and with supports at the lowest and
  /// highest speed of their tables; at even steps of log frequency, and by share_beside at the resonances of
  /// the reduced rotor and under unbalance and loads. A larger one than `enough` ends the look.
  double receptance_error(const Reduction& reduction, double enough) const;

  /// How vibrations that grow come out up to kit.modes_up_to_hz.
  struct Growth {
    double error = 0;  ///< worst difference of rate or frequency of one that grows in either
    bool mistaken =
        false;  ///< true: at some speed full matrices and reduced rotor disagree whether a vibration grows
  };
  Growth growth(const Reduction& reduction) const;

 private:
  /// Frequencies from low to high, and the shaft's speed at them.
  struct Line {
    bool with_the_force;  ///< else at `speed_rad_per_s`
    double speed_rad_per_s;
    std::optional<double> supports_rad_per_s;  ///< see matrices_at
  };
  /// A rotor and what it is looked at by.
  struct Rotor {
    FullSystem matrices;
    Eigen::MatrixXd responses, forces;
    std::vector<SpeedMatrices> at_lines;  ///< matrices without the force's speed
    Eigen::Index band = 0;                ///< largest distance from the diagonal that a number stands at
  };

  Rotor rotor_of(const PlaneBases& bases, FullSystem matrices) const;
  Rotor reduced_rotor(const Reduction& reduction) const;
  Eigen::MatrixXcd receptance(const Rotor& rotor, std::size_t line, double rad_per_s, double loss = 0) const;
  double rad_per_s(double step) const;
  /// Size of the responses to the forces at each of forces_m_, and last to all loads and unbalances.
  Eigen::VectorXd sizes(const Eigen::MatrixXcd& value) const;
  double line_error(const Rotor& reduced, std::size_t line, double enough) const;
  double peak_error(const Rotor& reduced, std::size_t line, double enough) const;

  const BeamShaft& shaft_;
  const model::RotorKit& kit_;
  std::vector<double> responses_m_, forces_m_, loads_m_;
  std::vector<Line> lines_;
  int points_ = 0, around_ = 0;
  Rotor full_;
  std::vector<std::vector<Eigen::MatrixXcd>> exact_;      ///< exact response of each line and point
  std::vector<std::pair<Line, Eigen::VectorXcd>> rates_;  ///< rates of free vibrations, where some may grow
};

/// Whether a vibration of a reduced rotor without its stops surely grows at a speed (which tables reach) and
/// none does by the full matrices of its kit, or one up to kit.modes_up_to_hz by these and none of the
/// reduced rotor. Stops must be nodes of the shaft.
bool growth_is_mistaken(const BeamShaft& shaft, const model::RotorKit& kit, const Assembly& reduced,
                        double speed_rad_per_s);

}  // namespace rubsweep::structure
