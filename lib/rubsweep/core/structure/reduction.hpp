#pragma once

#include <array>
#include <optional>
#include <vector>

#include "rubsweep/core/structure/lateral_system.hpp"
#include "rubsweep/core/structure/tabled_support.hpp"

namespace rubsweep::structure {

/// Reduced basis of a beam shaft: the lowest modes that the motion needs (study_planes), and one attachment
/// mode per stop, the static deflection under a force at the stop minus its components along the modes.
/// Attachment modes have their own part in the projected mass matrix. They make the static compliance between
/// the stops exact, however few modes are kept (MacNeal, Computers & Structures 1, 1971; Craig, Structural
/// Dynamics, 1981, section 19.2).
struct Reduction {
  PlaneBases bases;  ///< columns: modes, then attachment modes; largest deflection 1
  std::array<Eigen::VectorXd, 2> frequency_hz;  ///< frequency of each column, undamped, at rest
  std::array<std::vector<int>, 2>
      mode_number;  ///< number of each kept mode, 1 is the lowest; gaps: modes that the motion does not need
  int modes = 0;    ///< number chosen for each plane; further modes that may grow are added to it
  bool automatic = false;       ///< true: reduce() found the number of modes
  double receptance_error = 0;  ///< worst error up to kit.modes_up_to_hz, see FullReference::receptance_error
  double growth_error = 0;      ///< worst error of growing vibrations, see FullReference::growth
};

/// Largest receptance error of a converged reduction.
inline constexpr double receptance_tolerance = 0.01;

/// Reduces to kit.modes modes in each plane, or to the smallest number (at most RotorKit::most_modes) that
/// agrees with the full matrices. Agreement means: the same growing vibrations, and receptances within the
/// tolerance at the stops and sensors, under forces at the stops, faulty bearings, unbalance, loads and the
/// kick (by default at the first stop). Stations must be nodes, with at least one stop. Throws ConfigError
/// where numbers are too far apart for any mode to be seen or computed, where no number of modes is enough,
/// and where kit.modes is so small that the rotor is wrongly stable or unstable.
Reduction reduce(const BeamShaft& shaft, const model::RotorKit& kit, const std::vector<double>& stops_m,
                 const std::vector<double>& sensors_m, std::optional<double> kick_m = {});

/// The reduced rotor with its support damping and its structural damping, 2 ratio w m of each shape.
LateralSystem reduced_system(const BeamShaft& shaft, const model::RotorKit& kit, const Reduction& reduction);

/// Supports with tables in the coordinates of `system`, which are the first of `coordinates`.
std::vector<TabledSupport> tabled_supports(const BeamShaft& shaft, const model::RotorKit& kit,
                                           const PlaneBases& bases, const LateralSystem& system,
                                           Eigen::Index coordinates);

/// Contributions of rotating damping in the coordinates of `system`: to the damping and, multiplied by the
/// speed, to the stiffness.
struct RotatingDamping {
  Eigen::MatrixXd damping, circulatory;
};

/// A force -D (u' + w v) in the x plane and -D (v' - w u) in the y plane. D turns with the shaft and is
/// therefore the same in both planes; it gives the modes of the x plane the damping ratios of the kit.
RotatingDamping rotating_damping(const BeamShaft& shaft, const model::RotorKit& kit,
                                 const Reduction& reduction, const LateralSystem& system);

/// Modal mass of mode `j` of a plane, referred to a station: half of it times the square of the station's
/// velocity is the kinetic energy. Infinite at a node of the mode.
double modal_mass_kg(const BeamShaft& shaft, const Reduction& reduction, std::size_t plane, Eigen::Index j,
                     double position_m);

/// Reduction as by reduce(). If the kit gives its number of modes, the receptance error is omitted, whose
/// computation takes most of the time.
Reduction reduce_to_modes(const BeamShaft& shaft, const model::RotorKit& kit,
                          const std::vector<double>& stops_m, const std::vector<double>& sensors_m,
                          std::optional<double> kick_m = {});

}  // namespace rubsweep::structure
