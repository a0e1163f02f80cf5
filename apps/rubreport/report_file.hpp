#pragma once

#include <cstddef>
#include <filesystem>
#include <string_view>

#include "rubsweep/analysis/page/html_report.hpp"
#include "rubsweep/maps/batch/progress.hpp"
#include "rubsweep/maps/sweep/study.hpp"

namespace rubsweep::apps {

/// How report.html is made of a finished map.
struct ReportOptions {
  std::filesystem::path file;  ///< where it goes
  batch::Captions captions{};
  std::size_t most_orbits = page::usual_orbits;
  int threads = 0;
  batch::ProgressMode progress = batch::ProgressMode::automatic;
  bool quiet = false;
};

/// Writes the report of the map in `directory`, of `study`, and returns an exit code: 128 + signal when a
/// signal came before it was written; then an older report is as it was. Throws ConfigError where the map is
/// of another study, IoError.
int write_report(const std::filesystem::path& directory, const sweep::Study& study, std::string_view program,
                 const ReportOptions& options);

}  // namespace rubsweep::apps
