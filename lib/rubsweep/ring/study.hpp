#pragma once

#include <atomic>
#include <functional>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rubsweep/core/vocabulary.hpp"
#include "rubsweep/maps/batch/axis.hpp"
#include "rubsweep/ring/analysis.hpp"
#include "rubsweep/ring/system.hpp"

namespace rubsweep::ring {

/// Parameter that a stability chart varies beside the speed.
enum class Parameter {
  friction_coefficient,
  angle_deg,
  inclination_deg,
  radial_stiffness_n_per_m,
  tangential_stiffness_n_per_m
};
constexpr std::string_view to_string(Parameter parameter) { return enumerator_word(parameter); }

struct ChartAxis {
  Parameter parameter = Parameter::friction_coefficient;
  std::optional<std::size_t>
      load;  ///< index of the load; empty: all loads. Not used for the friction coefficient
  std::vector<double> values;
  std::optional<batch::Spacing> spacing{};  ///< spacing of a range of values; empty for a list of values
};

/// System with the parameter set to this value.
System with_parameter(System system, const ChartAxis& axis, double value);

/// Point of a chart, with the eigenvalue that grows fastest or decays slowest.
struct ChartPoint {
  Signature signature;
  double growth_per_s = 0;
  double frequency_rad_per_s = 0;
};

/// Line of a chart: all speeds at one value of the parameter.
struct ChartLine {
  double value = 0;
  std::vector<ChartPoint> points;  ///< empty when `status` is not ok
  std::vector<Onset>
      /// onsets between these speeds, without mode names; the couplings of modes are those without friction
      onsets;
  std::string status = "ok";  ///< singular_mass or not_converged
};

/// Computes every line on `threads` threads (0: all processors). Lines are in the order of the axis, and do
/// not depend on the number of threads. `on_line` gets each line when it is finished, one at a time. Once
/// `stop` is true no new line starts; lines that did not run stay empty.
std::vector<std::optional<ChartLine>> run_chart(const System& system, const ChartAxis& axis,
                                                const std::vector<double>& speeds_rad_per_s, int threads,
                                                const std::function<void(const ChartLine&)>& on_line,
                                                const std::atomic<bool>& stop);

/// One run of `ringstab`.
struct Study {
  System system;
  std::vector<double> speeds_rpm;  ///< ascending
  std::optional<ChartAxis> chart;
  std::optional<batch::Spacing> spacing{};  ///< spacing in which the speeds were written; empty for a list
};

/// One revolution per minute in rad/s.
inline constexpr double rad_per_s_of_rpm = std::numbers::pi / 30;

inline std::vector<double> speeds_rad_per_s(const Study& study) {
  std::vector<double> speeds;
  for (const double speed : study.speeds_rpm) speeds.push_back(speed * rad_per_s_of_rpm);
  return speeds;
}

}  // namespace rubsweep::ring
