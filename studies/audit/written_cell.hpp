#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "audit/random_machine.hpp"

namespace rubsweep::audit {

/// Arguments of the audits' programs.
struct CellsAndSeed {
  std::size_t cells = 0;
  std::uint64_t seed = 0;
  std::vector<StopKind> kinds;
};

/// `program CELLS SEED [KIND ...]`, all kinds where none is named; empty when that is not what the arguments
/// are.
std::optional<CellsAndSeed> cells_and_seed(int argc, char** argv);

/// Kind of stops of cell `i`: they take turns.
StopKind kind_of(const CellsAndSeed& asked, std::size_t i);

/// Cell `i` of the audit.
RandomCell cell_of(const CellsAndSeed& asked, std::size_t i);

/// Writes a configuration of the cell to `file`, to be run by the programs. Throws IoError.
void write_cell(const RandomCell& cell, const std::string& file);

}  // namespace rubsweep::audit
