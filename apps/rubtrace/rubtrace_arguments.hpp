#pragma once

#include <optional>
#include <string>
#include <vector>

#include "probe_argument.hpp"
#include "rubsweep/core/model/length_text.hpp"
#include "shared/action.hpp"
#include "shared/figure.hpp"
#include "shared/place_arguments.hpp"
#include "speed_ranges.hpp"

namespace rubsweep::apps {

/// Arguments of a design check.
struct DesignCheckArguments {
  std::optional<design::SpeedRange> operating = {};  ///< empty: the speeds of the sweep
  std::string operating_option = {};                 ///< name of the option that gave the operating range
  int kick_speeds = 11;
  int threads = 0;
  std::vector<std::string> other_end = {};  ///< keys and values of the other end of the bearings' clearances
  std::optional<std::vector<design::Stage>> stages = {};  ///< see design::LateralQuestions
  std::optional<double> gas_density_kg_per_m3 = {};       ///< see design::LateralQuestions
  bool require_pass = false;  ///< every answer except "pass" ends with exit code 4
};

/// Arguments of a rotor report, whose directory is the one of the results.
struct RotorReportArguments {
  std::optional<Figure> page = {};                   ///< the page; empty where nothing is computed
  std::optional<design::SpeedRange> operating = {};  ///< empty: the speeds of the sweep
  std::string operating_option = {};
};

struct RubtraceArguments : StudyArguments {
  PlaceArguments place = {};   ///< place of a trace; unbalance of a run-up or design check; speed and
                               ///< unbalance of the deflected shape
  bool free_response = false;  ///< experiment in place of a trace: free vibration
  std::optional<ramp::SpeedRamp> run_up = {};   ///< experiment in place of a trace: a run-up
  bool with_stops = false;                      ///< the run-up includes the stops
  std::optional<CampbellSpeeds> campbell = {};  ///< experiment in place of a trace: a Campbell diagram
  std::optional<DesignCheckArguments> design_check = {};
  std::optional<RotorReportArguments> rotor_report = {};
  double duration_s = 2;   ///< duration of the free response
  double sample_s = 1e-3;  ///< sampling time of the sensors
  double noise_m = 0;
  bool probes = false;                    ///< the trace includes readings of sensors or probes
  std::vector<ProbeArgument> probe = {};  ///< probes in place of the machine's sensors
  std::optional<Figure> figure = {};      ///< figure of a trace, a Campbell diagram or a run-up with stops
  model::ShownLengths shown = {};         ///< unit of lengths in the printed text
  std::optional<long> revolutions = {};
  std::optional<long> last_revolutions = {};
};

/// Reads the command line. Throws UsageError (program.hpp).
RubtraceArguments parse_rubtrace_arguments(int argc, const char* const* argv);

}  // namespace rubsweep::apps
