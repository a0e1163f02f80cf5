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

/// A map in characters, for a terminal: one for each cell, or for the middle cell of each block where there
/// are more cells than room. Two bytes are kept of a cell.
class CharacterMap {
 public:
  /// The grid must outlive it.
  explicit CharacterMap(const sweep::Grid& grid) : grid_(grid) {}

  /// A line of map.csv; all of them in the order of the file.
  void add(std::string_view map_line);

  /// A cell that is not computed yet: a blank, which the legend leaves out.
  void add_unfinished();

  /// Map as text, at most `width` characters wide and 20 rows high, unbalance upward, with the ends of both
  /// axes and the meaning of each character. `coloured`: with 24-bit colours, those of the figures.
  std::string text(std::size_t width, bool coloured) const;

  /// Cell nearest to the middle of all those with the most frequent rub; empty where none rubs in a motion
  /// that has settled.
  std::optional<std::size_t> typical_rub() const;

  /// Name of the motion of a cell.
  const std::string& name(std::size_t cell) const { return names_[cells_[cell]]; }

 private:
  void add(const std::string& name, const response::motion::MotionKind& kind);

  const sweep::Grid& grid_;
  std::vector<std::string> names_;
  std::vector<const response::motion::MotionKind*> kinds_;  ///< kinds of the names
  std::vector<std::uint16_t> cells_;                        ///< number of its name
};

}  // namespace rubsweep::apps
