#pragma once

#include <array>
#include <vector>

#include "rubsweep/structure/lateral_system.hpp"
#include "rubsweep/structure/tabled_support.hpp"

namespace rubsweep::structure {

/// Reduced basis of a beam shaft: the lowest modes that a stop or sensor sees, and for each stop the
/// attachment mode, the static deflection under a force there less the share of the modes. Its mass is that
/// of the projected mass matrix. With it the static compliance between the stops is exact, however few
/// modes are kept (MacNeal, Computers & Structures 1, 1971; Craig, Structural Dynamics, 1981, section
/// 19.2).
struct Reduction {
  PlaneBases bases;  ///< columns: modes, then attachment modes; largest deflection 1
  std::array<Eigen::VectorXd, 2> frequency_hz;  ///< of each column, undamped, at rest
  std::array<std::vector<int>, 2>
      mode_number;              ///< of each kept mode, 1 is the lowest; gaps: no stop or sensor sees these
  bool automatic = false;       ///< the number of modes was found here
  double receptance_error = 0;  ///< worst up to kit.modes_up_to_hz, see receptance_error()
};

/// A receptance counts as converged below this.
inline constexpr double receptance_tolerance = 0.01;

/// Reduces to kit.modes modes in each plane, or to the smallest number whose receptance error at the stops
/// and sensors, under forces at the stops and faulty bearings, is within the tolerance (at most
/// RotorKit::most_modes). Stations must be nodes, and there must be at least one stop. Throws ConfigError
/// where numbers are too far apart for any mode to be seen or computed.
Reduction reduce(const BeamShaft& shaft, const model::RotorKit& kit, const std::vector<double>& stops_m,
                 const std::vector<double>& sensors_m);

/// The reduced rotor with its support damping and its structural damping, 2 ratio w m of each shape.
LateralSystem reduced_system(const BeamShaft& shaft, const model::RotorKit& kit, const Reduction& reduction);

/// Supports that follow the speed, in the coordinates of `system`, the first of `coordinates`.
std::vector<TabledSupport> tabled_supports(const BeamShaft& shaft, const model::RotorKit& kit,
                                           const PlaneBases& bases, const LateralSystem& system,
                                           Eigen::Index coordinates);

/// Contributions of damping that turns with the shaft in the coordinates of `system`: to the damping, and,
/// times the speed, to the stiffness.
struct RotatingDamping {
  Eigen::MatrixXd damping, circulatory;
};

/// A force -D (u' + w v) in the x plane and -D (v' - w u) in the y plane, with one operator D on the
/// deflected line because it turns: the modes of the x plane have the ratios asked for.
RotatingDamping rotating_damping(const BeamShaft& shaft, const model::RotorKit& kit,
                                 const Reduction& reduction, const LateralSystem& system);

/// Displacements (rows) of `responses_m` by harmonic unit forces (columns) at `forces_m`, both in x and y, x
/// first at each place: (stiffness + i w (damping + speed gyroscopic) - w^2 mass)^-1 between them, in m/N.
Eigen::MatrixXcd receptance(const BeamShaft& shaft, const PlaneBases& bases, const LateralSystem& system,
                            double rad_per_s, double speed_rad_per_s, const std::vector<double>& responses_m,
                            const std::vector<double>& forces_m);

/// Modal mass of mode `j` of a plane for a force at a station: its kinetic energy is half this times the
/// square of the station's velocity. Infinite at a node of the mode.
double modal_mass_kg(const BeamShaft& shaft, const Reduction& reduction, std::size_t plane, Eigen::Index j,
                     double position_m);

}  // namespace rubsweep::structure
