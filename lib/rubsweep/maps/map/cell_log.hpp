#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "rubsweep/maps/batch/journal.hpp"
#include "rubsweep/maps/batch/line_log.hpp"
#include "rubsweep/maps/batch/progress.hpp"
#include "rubsweep/maps/map/map_directory.hpp"

namespace rubsweep::map {

/// Finished cells on their way into the journal of this process, into the partial map and into the line of
/// progress on stderr. Not for several threads at once.
class CellLog {
 public:
  /// Opens both files; the directory must outlive it. Throws IoError.
  CellLog(const MapDirectory& directory, batch::ProgressMode mode);

  /// Writes down a cell with its line of the map, and the seconds that it took on its thread. Throws IoError.
  void add(std::size_t cell, const std::string& line, std::optional<double> seconds = {});

  /// Counts and shows a cell that the journal of another process holds.
  void add_of_other_process(std::size_t cell, const std::string& line);

  /// Number of added cells.
  std::size_t finished() const { return finished_; }

  batch::Progress& progress() { return progress_; }

  /// Redraws the progress and asks for the journal to be on the disk, each where it is due.
  void refresh();

  /// Asks for the journal to be on the disk and ends the line of progress: the process is about to end.
  void close();

 private:
  void show(std::size_t cell, const std::string& line, std::optional<double> seconds);

  const MapDirectory& directory_;
  batch::Journal journal_;
  batch::LineLog partial_;
  batch::Progress progress_;
  std::size_t finished_ = 0;
};

/// Message of `program` after a signal: how many cells are finished, `finished` of them by this run.
std::string interrupted_map(std::string_view program, const MapDirectory& directory, std::size_t finished);

}  // namespace rubsweep::map
