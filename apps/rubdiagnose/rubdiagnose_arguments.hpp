#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "rubsweep/batch/progress_mode.hpp"
#include "rubsweep/model/length_text.hpp"
#include "shared/action.hpp"
#include "shared/figure.hpp"

namespace rubsweep::apps {

struct RubdiagnoseArguments {
  Action action = Action::run;
  bool quiet = false;
  std::filesystem::path recording = {}, instrument = {}, machine = {}, directory = {}, table = {};
  std::optional<std::filesystem::path> candidates = {};  ///< empty: the usual ones
  std::uint64_t seed = 1;
  int motions = 600, rounds = 3, threads = 0;
  batch::ProgressMode progress = batch::ProgressMode::automatic;
  model::ShownLengths shown = {};
  std::optional<Figure> figure = {};
};

/// Throws UsageError (program.hpp).
RubdiagnoseArguments parse_rubdiagnose_arguments(int argc, const char* const* argv);

/// Text of --help.
std::string rubdiagnose_help();

}  // namespace rubsweep::apps
