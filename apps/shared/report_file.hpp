#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string_view>

#include "rubsweep/batch/progress_mode.hpp"
#include "rubsweep/page/map_table.hpp"
#include "rubsweep/page/report_page.hpp"
#include "rubsweep/sweep/study.hpp"

namespace rubsweep::apps {

/// How report.html is made of a finished map.
struct ReportOptions {
  std::filesystem::path file;  ///< where it goes
  batch::Captions captions{};
  std::size_t most_orbits = page::usual_orbits;
  int threads = 0;
  batch::ProgressMode progress = batch::ProgressMode::automatic;
  bool quiet = false;
  /// Called before the process ends because cells still ran half a second after a signal.
  std::function<void()> before_leaving = [] {};
};

/// The map at `path`, for `program`, its rows in the order of the cells. Throws ConfigError where it is not
/// one of `study`, and IoError, also where it is not as it was written or not the whole map.
page::MapTable read_map_of(const sweep::Study& study, const std::filesystem::path& path,
                           std::string_view program);

/// Writes the report of the map in `directory`, of `study`, and returns an exit code: 128 + signal when a
/// signal came before it was written; then an older report is as it was. Throws ConfigError where the map is
/// of another study, IoError.
int write_report(const std::filesystem::path& directory, const sweep::Study& study, std::string_view program,
                 const ReportOptions& options);

}  // namespace rubsweep::apps
