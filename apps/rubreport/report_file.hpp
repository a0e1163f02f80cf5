#pragma once

#include <cstddef>
#include <filesystem>
#include <string_view>

#include "html_report.hpp"
#include "rubsweep/maps/batch/progress.hpp"
#include "rubsweep/maps/sweep/study.hpp"

namespace rubsweep::apps {

/// Options for making report.html from a finished map.
struct ReportOptions {
  std::filesystem::path file;  ///< file that is written
  batch::Captions captions{};
  std::size_t most_orbits = usual_orbits;
  int threads = 0;
  batch::ProgressMode progress = batch::ProgressMode::automatic;
  bool quiet = false;
};

/// Writes the report of the map of `study` in `directory` and returns an exit code. If a signal came before
/// the report was written, the code is 128 + signal and an older report stays unchanged. Throws ConfigError
/// where the map belongs to another study, and IoError.
int write_report(const std::filesystem::path& directory, const sweep::Study& study, std::string_view program,
                 const ReportOptions& options);

}  // namespace rubsweep::apps
