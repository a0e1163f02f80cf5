#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rubsweep/core/response/motion/motion_class.hpp"
#include "rubsweep/maps/sweep/grid.hpp"

namespace rubsweep::apps {

/// A map made of characters, for a terminal: one character per cell or, where there is not enough room, one
/// per block of cells, taken from its middle cell. Memory: two bytes per cell.
class CharacterMap {
 public:
  /// The grid must outlive it.
  explicit CharacterMap(const sweep::Grid& grid) : grid_(grid) {}

  /// Adds a line of map.csv; lines must come in the order of the file.
  void add(std::string_view map_line);

  /// Adds a cell that is not computed yet: a blank, which the legend omits.
  void add_unfinished();

  /// Map as text, at most `width` characters wide and 20 rows high, unbalance upwards, with the ends of both
  /// axes and the meaning of each character. `coloured`: uses the colours of the figures in 24 bits.
  std::string text(std::size_t width, bool coloured) const;

  /// Cell closest to the centre of all cells with the most frequent kind of rub; empty where no cell has a
  /// settled rub.
  std::optional<std::size_t> typical_rub() const;

  /// Name of the motion in a cell.
  const std::string& name(std::size_t cell) const { return names_[cells_[cell]]; }

 private:
  void add(const std::string& name, const response::motion::MotionKind& kind);

  const sweep::Grid& grid_;
  std::vector<std::string> names_;
  std::vector<const response::motion::MotionKind*> kinds_;  ///< kind that each name belongs to
  std::vector<std::uint16_t> cells_;                        ///< for each cell, the index of its motion's name
};

}  // namespace rubsweep::apps
