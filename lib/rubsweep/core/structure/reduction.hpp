#pragma once

#include <array>
#include <optional>
#include <vector>

#include "rubsweep/core/structure/lateral_system.hpp"
#include "rubsweep/core/structure/tabled_support.hpp"

namespace rubsweep::structure {

/// Reduced basis of a beam shaft: the lowest modes that the motion needs (study_planes), and for each stop
/// the attachment mode, the static deflection under a force there less the share of the modes. Its mass is
/// that of the projected mass matrix. With it the static compliance between the stops is exact, however few
/// modes are kept (MacNeal, Computers & Structures 1, 1971; Craig, Structural Dynamics, 1981, section
/// 19.2).
struct Reduction {
  PlaneBases bases;  ///< columns: modes, then attachment modes; largest deflection 1
  std::array<Eigen::VectorXd, 2> frequency_hz;  ///< frequency of each column, undamped, at rest
  std::array<std::vector<int>, 2>
      mode_number;  ///< number of each kept mode, 1 is the lowest; gaps: the motion does not need these
  int modes = 0;    ///< asked for of each plane; with those that may grow beside there are more
  bool automatic = false;       ///< the number of modes was found here
  double receptance_error = 0;  ///< worst up to kit.modes_up_to_hz, see FullReference::receptance_error
  double growth_error = 0;      ///< the same of vibrations that grow, see FullReference::growth
};

/// A receptance counts as converged below this.
inline constexpr double receptance_tolerance = 0.01;

/// Reduces to kit.modes modes in each plane, or to the smallest number (at most RotorKit::most_modes) that
/// answers as the full matrices do: within the tolerance at the stops and sensors, under forces at the stops,
/// faulty bearings, unbalance, loads and the kick (at the first stop where none is given), and with the same
/// vibrations growing. Stations must be nodes, and there must be at least one stop. Throws ConfigError where
/// numbers are too far apart for any mode to be seen or computed, where no number of modes is enough, and
/// where kit.modes are so few that the rotor is stable or unstable by mistake.
Reduction reduce(const BeamShaft& shaft, const model::RotorKit& kit, const std::vector<double>& stops_m,
                 const std::vector<double>& sensors_m, std::optional<double> kick_m = {});

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

/// Modal mass of mode `j` of a plane for a force at a station: its kinetic energy is half this times the
/// square of the station's velocity. Infinite at a node of the mode.
double modal_mass_kg(const BeamShaft& shaft, const Reduction& reduction, std::size_t plane, Eigen::Index j,
                     double position_m);

/// Reduction of a kit that says how many modes it keeps, as by reduce() but without the receptance error,
/// whose comparison takes most of the time. One that leaves the number open is reduced by reduce().
Reduction reduce_to_modes(const BeamShaft& shaft, const model::RotorKit& kit,
                          const std::vector<double>& stops_m, const std::vector<double>& sensors_m,
                          std::optional<double> kick_m = {});

}  // namespace rubsweep::structure
