#include "rubsweep/map/cell_log.hpp"

#include <fmt/format.h>

#include <cstdio>

namespace rubsweep::map {

CellLog::CellLog(const MapDirectory& directory, batch::ProgressMode mode)
    : directory_(directory),
      journal_(directory.journal()),
      partial_(directory.partial()),
      progress_(directory.cells(), mode, stderr, directory.finished()) {}

void CellLog::add(std::size_t cell, const std::string& line) {
  journal_.append(cell, line);
  add_of_other_process(line);
}

void CellLog::add_of_other_process(const std::string& line) {
  partial_.append(directory_.in_map(line));
  ++finished_;
  progress_.advance();
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
