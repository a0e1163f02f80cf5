#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "audit/random_machine.hpp"

namespace rubsweep::audit {

/// Arguments of the audit programs.
struct CellsAndSeed {
  std::size_t cells = 0;
  std::uint64_t seed = 0;
  std::vector<StopKind> kinds;
};

/// Reads `program CELLS SEED [KIND ...]`; all kinds if none is named. Empty for other arguments.
std::optional<CellsAndSeed> cells_and_seed(int argc, char** argv);

/// Kind of stops in cell `i`; the kinds take turns.
StopKind kind_of(const CellsAndSeed& asked, std::size_t i);

/// Random cell number `i` of the audit.
RandomCell cell_of(const CellsAndSeed& asked, std::size_t i);

/// Writes a configuration of the cell, which the programs can run, to `file`. Throws IoError.
void write_cell(const RandomCell& cell, const std::string& file);

}  // namespace rubsweep::audit
