#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rubsweep/core/response/motion/motion.hpp"
#include "rubsweep/core/response/motion/motion_class.hpp"
#include "rubsweep/core/response/survival.hpp"
#include "rubsweep/core/vocabulary.hpp"
#include "rubsweep/maps/sweep/basin_sampling.hpp"
#include "rubsweep/maps/sweep/threshold.hpp"

namespace rubsweep::sweep {

/// Start of the run of a cell.
enum class RunStart {
  kick,      ///< on the quiet whirl, with a kick
  quiet,     ///< on the quiet whirl, as there is no kick
  contact,   ///< at rest in the static position, without a kick: the quiet motion itself reaches a wall
  state,     ///< from a state in the configuration, without a kick
  handed_on  ///< on the motion of the cell before it on a line; never in a map
};

constexpr std::string_view to_string(RunStart start) { return enumerator_word(start); }

/// Secant of Hertz' line contacts with which a cell was finally computed.
struct HertzSecant {
  int iterations = 0;  ///< number of times that the secant was adapted
  /// Force for the secant at the stop with the smallest design force, of those with hertz. The secants of the
  /// other stops can be computed from it.
  double force_n = 0;
  double stiffness_n_per_m = 0;  ///< stiffness of that stop
};

/// Result of one cell, kept as one row of the map. Members that do not apply are empty.
struct Row {
  double speed_hz = 0;
  double whirl_ratio = 0;
  double eccentricity_m = 0;
  response::motion::MotionClass motion_class = response::motion::MotionClass::failed;
  std::optional<int> order;
  /// Measures of the settled window; empty where nothing settled can be measured.
  std::optional<response::motion::Measures> measures;
  std::optional<response::motion::Proof> proof;
  std::optional<bool> robust;                     ///< see is_robust; empty unless requested
  std::optional<double> floquet_modulus;          ///< largest multiplier of a proven orbit over its period
  std::optional<double> lyapunov_per_revolution;  ///< largest Lyapunov exponent, where no period was found
  std::optional<long> last_contact_revolution;
  long revolutions = 0;
  std::string status = "ok";                  ///< `ok` or one word per cause, joined by ';'
  std::optional<double> peak_over_clearance;  ///< peak_displacement_m over the clearance of the first stop
  std::optional<RunStart> start;              ///< empty: nothing was simulated
  std::optional<double> robust_share{};       ///< see the function robust_share; empty unless requested
  std::optional<int> refinement_level{};      ///< level in a refined map
  std::optional<Basins> basins{};  ///< basins, if the study requests them; empty where no kick was simulated
  std::vector<double> key_values{};              ///< values of the axes over keys, in the order of key_names
  std::optional<HertzSecant> hertz{};            ///< secants that may be adapted
  std::optional<response::Survival> survival{};  ///< survival of a chaotic motion
  std::optional<Threshold>
      threshold{};  ///< threshold, if the study requests it; empty where no kick was simulated
};

/// Class and order of a motion, such as "subharmonic 1/2" or "chaotic".
std::string class_and_order(const Row& row);

const response::motion::MotionKind& kind_of(const Row& row);

/// Adds a word to the status of a row unless the status already has it.
void add_status(Row& row, std::string_view word);

/// Numbers that identify the attractor of a row: class, order, peak_displacement_m and both amplitudes at 1X.
SampledMotion sampled_motion(const Row& row);

}  // namespace rubsweep::sweep
