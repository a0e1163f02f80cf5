#include "rubsweep/maps/map/cell_log.hpp"

#include <fmt/format.h>

#include <cstdio>

namespace rubsweep::map {

CellLog::CellLog(const MapDirectory& directory, batch::ProgressMode mode)
    : directory_(directory),
      journal_(directory.journal()),
      partial_(directory.partial()),
      progress_(directory.cells(), mode, stderr, directory.finished()) {}

void CellLog::add(std::size_t cell, const std::string& line, std::optional<double> seconds) {
  journal_.append(cell, line);
  show(cell, line, seconds);
}

void CellLog::add_of_other_process(std::size_t cell, const std::string& line) { show(cell, line, {}); }

void CellLog::show(std::size_t cell, const std::string& line, std::optional<double> seconds) {
  partial_.append(directory_.in_map(line));
  ++finished_;
  progress_.finish_cell(cell, seconds);
}

void CellLog::refresh() {
  progress_.refresh();
  journal_.refresh();
}

void CellLog::close() {
  journal_.sync();
  progress_.finish();
}

std::string interrupted_map(std::string_view program, const MapDirectory& directory, std::size_t finished) {
  return fmt::format("{}: interrupted; {} of {} cells are finished, the same command computes the others\n",
                     program, directory.finished() + finished, directory.cells());
}

}  // namespace rubsweep::map
