#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "rubsweep/core/model/length_text.hpp"
#include "rubsweep/maps/batch/progress.hpp"
#include "shared/figure.hpp"
#include "shared/recording_arguments.hpp"

namespace rubsweep::apps {

struct RubdiagnoseArguments : RecordingArguments {
  std::filesystem::path machine = {}, table = {};
  std::optional<std::filesystem::path> candidates = {};  ///< empty: the usual candidates
  std::uint64_t seed = 1;
  int motions = 600, rounds = 0, threads = 0;
  batch::ProgressMode progress = batch::ProgressMode::automatic;
  model::ShownLengths shown = {};
  std::optional<Figure> figure = {};
};

/// Reads the command line. Throws UsageError (program.hpp).
RubdiagnoseArguments parse_rubdiagnose_arguments(int argc, const char* const* argv);

/// Text that --help prints.
std::string rubdiagnose_help();

}  // namespace rubsweep::apps
