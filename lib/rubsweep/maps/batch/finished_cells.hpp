#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "rubsweep/maps/batch/descriptor.hpp"

namespace rubsweep::batch {

/// Index of the cells of a grid that some journals hold. Takes eight bytes for each cell of the grid: the
/// texts stay in the files, which must not shrink meanwhile.
class FinishedCells {
 public:
  explicit FinishedCells(std::size_t cells) : places_(cells, nowhere) {}

  /// Adds the good records of a journal, of which the first one counts for a cell. Returns how many records
  /// were damaged. The journal must be one of this grid. Throws IoError.
  std::size_t add(const std::filesystem::path& journal);

  std::size_t count() const { return count_; }
  bool contains(std::size_t cell) const { return places_[cell] != nowhere; }

  /// Cells that no journal holds, ascending.
  std::vector<std::size_t> missing() const;

  /// Text in the journal of a cell that it contains. Throws IoError.
  std::string text(std::size_t cell) const;

 private:
  static constexpr std::uint64_t nowhere = ~std::uint64_t{0};

  struct File {
    std::filesystem::path path;
    Descriptor descriptor;
  };

  std::vector<File> files_;
  /// Place of each cell: the index of the file in the upper 16 bits, below it the offset of the text.
  std::vector<std::uint64_t> places_;
  std::size_t count_ = 0;
};

}  // namespace rubsweep::batch
