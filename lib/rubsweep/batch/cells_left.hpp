#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace rubsweep::batch {

/// Predicts how long the cells of a map that are left will take. Quiet cells take milliseconds, rubbing ones
/// a hundred times as long, and chaotic ones ten times that, but neighbours on the map are alike: a cell that
/// is left counts as the mean of the finished ones near it, the nearer the more, and as the mean of all only
/// where none is near. Not for use by several threads at once.
class CellsLeft {
 public:
  /// A map of `rows` rows of `columns` cells, numbered along the rows; `cells` are those to be computed.
  CellsLeft(std::size_t columns, std::size_t rows, std::span<const std::size_t> cells);

  /// One of the cells is finished, after `seconds` on one thread; without them where nobody measured.
  void finish(std::size_t cell, std::optional<double> seconds);

  /// Seconds that all cells left take, one after the other; empty before any was measured.
  std::optional<double> one_by_one_s() const;

  std::size_t left() const { return left_; }

  /// Seconds that the finished cells took, one after the other; those that nobody measured count as the
  /// others do.
  double finished_s() const;

 private:
  /// Cells of a small rectangle of the map.
  struct Tile {
    double seconds = 0;
    std::size_t measured = 0, left = 0;
  };

  std::size_t tile_of(std::size_t cell) const;

  /// Sums over all tiles above and to the left of each corner of tiles.
  std::vector<Tile> corner_sums() const;

  std::size_t columns_, left_, finished_ = 0;
  std::size_t side_ = 1;                ///< of a tile, in cells
  std::size_t width_ = 1, height_ = 1;  ///< of the map, in tiles
  std::vector<Tile> tiles_;
};

}  // namespace rubsweep::batch
