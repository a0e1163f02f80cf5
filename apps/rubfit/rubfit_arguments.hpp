#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "rubsweep/measurement/fit/measured_data.hpp"
#include "shared/action.hpp"
#include "shared/figure.hpp"

namespace rubsweep::apps {

/// A parameter to be fitted: KEY, KEY=LOW:HIGH or KEY=LOW:START:HIGH.
struct FittedKey {
  std::string name;
  std::optional<double> low = {}, start = {}, high = {};
};

struct RubfitArguments : StudyArguments {
  std::vector<FittedKey> keys = {};
  std::vector<std::filesystem::path> ring_downs = {}, run_ups = {}, steady = {}, ramped_speeds = {},
                                     rubs = {};
  std::optional<double> rate_hz_per_s = {};
  double window_turns = 0;
  double eccentricity_m = 0, mark_deg = 0, hit_s = 0, from_s = 0;
  std::optional<fit::PhaseConvention> phases{};  ///< convention of tables; empty: chosen by the residual
  bool run_out = false;
  int starts = 1;
  double robust_beyond = 0;
  std::vector<std::string> without = {};  ///< names that a second fit leaves out
  std::optional<Figure> figure = {};
};

/// Name of a convention as in --phase: sensor, mark or lag.
const char* name_of(fit::PhaseConvention convention);

/// Reads the command line. Throws UsageError (program.hpp).
RubfitArguments parse_rubfit_arguments(int argc, const char* const* argv);

/// Text that --help prints.
std::string rubfit_help();

}  // namespace rubsweep::apps
