#pragma once

#include <optional>
#include <vector>

#include "rubsweep/core/structure/assembly.hpp"
#include "rubsweep/core/structure/lateral_system.hpp"
#include "rubsweep/core/structure/reduction.hpp"

namespace rubsweep::structure {

/// Weight of two kinds of difference: those at resonances, which shift with the last digits of a frequency,
/// and those under a load away from all attachment modes, where the response depends on the modes alone.
inline constexpr double share_beside = 0.2;

/// Reference for reductions of one kit: its full matrices with dampers, cross-coupling, gyroscopic moments
/// and rotating damping, solved directly once.
class FullReference {
 public:
  /// Responses are in x and y at `responses_m`, forces act at `forces_m`. Responses to forces at `loads_m`
  /// and to the shaft's unbalance are compared as a separate group.
  FullReference(const BeamShaft& shaft, const model::RotorKit& kit, std::vector<double> responses_m,
                std::vector<double> forces_m, std::vector<double> loads_m);

  /// Worst relative difference of a receptance up to kit.modes_up_to_hz. The reference for each force
  /// position is its largest receptance within a fifth of the frequency. Receptances are compared at
  /// standstill, turning with the force, and with supports at the lowest and highest speed of their tables,
  /// at even steps of log frequency. Differences at the resonances of the reduced rotor and under unbalance
  /// and loads are weighted by share_beside. The search ends once a difference exceeds `enough`.
  double receptance_error(const Reduction& reduction, double enough) const;

  /// Comparison of growing (unstable) vibrations up to kit.modes_up_to_hz.
  struct Growth {
    double error = 0;  ///< worst difference of rate or frequency of a vibration that grows in either model
    bool mistaken =
        false;  ///< true: at some speed a vibration grows in only one of the two models, full and reduced
  };
  Growth growth(const Reduction& reduction) const;

 private:
  /// Series of frequencies from low to high, with the shaft speed used for them.
  struct Line {
    bool with_the_force;  ///< true: shaft speed = frequency; false: `speed_rad_per_s`
    double speed_rad_per_s;
    std::optional<double> supports_rad_per_s;  ///< see matrices_at
  };
  /// Matrices of a rotor, full or reduced, with its responses and forces.
  struct Rotor {
    FullSystem matrices;
    Eigen::MatrixXd responses, forces;
    std::vector<SpeedMatrices> at_lines;  ///< matrices of each line without the terms of the force's speed
    Eigen::Index band = 0;                ///< largest distance of a non-zero entry from the diagonal
  };

  Rotor rotor_of(const PlaneBases& bases, FullSystem matrices) const;
  Rotor reduced_rotor(const Reduction& reduction) const;
  Eigen::MatrixXcd receptance(const Rotor& rotor, std::size_t line, double rad_per_s, double loss = 0) const;
  double rad_per_s(double step) const;
  /// Norms of the responses to the forces at each of forces_m_; the last one is for all loads and unbalances.
  Eigen::VectorXd sizes(const Eigen::MatrixXcd& value) const;
  double line_error(const Rotor& reduced, std::size_t line, double enough) const;
  double peak_error(const Rotor& reduced, std::size_t line, double enough) const;

  const BeamShaft& shaft_;
  const model::RotorKit& kit_;
  std::vector<double> responses_m_, forces_m_, loads_m_;
  std::vector<Line> lines_;
  int points_ = 0, around_ = 0;
  Rotor full_;
  std::vector<std::vector<Eigen::MatrixXcd>> exact_;      ///< exact receptance for each line and point
  std::vector<std::pair<Line, Eigen::VectorXcd>> rates_;  ///< rates of free vibrations, if some may grow
};

/// Whether the reduced rotor, without its stops, is unstable by mistake at a speed within the tables: a
/// vibration surely grows although none does in the full model. Also true in the opposite case: a vibration
/// up to kit.modes_up_to_hz grows in the full model, but none in the reduced rotor. Stops must be nodes of
/// the shaft.
bool growth_is_mistaken(const BeamShaft& shaft, const model::RotorKit& kit, const Assembly& reduced,
                        double speed_rad_per_s);

}  // namespace rubsweep::structure
