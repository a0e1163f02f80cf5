#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>

#include "rubsweep/core/response/motion/motion_class.hpp"
#include "rubsweep/maps/sweep/row.hpp"

namespace rubsweep::report {

/// Name of the motion of a row on a terminal: class and order, and the distinction between motions of one
/// class that are not alike: a whip that rolls backward on its own force from an oval that the unbalance
/// drives, a circle forward from one backward.
std::string motion_name(const sweep::Row& row);
/// The same of a line of map.csv.
std::string motion_name(std::string_view map_line);

/// Its kind; throws IoError where the line has none.
const response::motion::MotionKind& kind_in(std::string_view map_line);

/// Class and order of a line of map.csv: equal for cells that a refined map takes for equal.
std::string label_of(std::string_view map_line);

/// Counts the rows of a map without keeping them. They come as lines of map.csv because that is all there is
/// of them: a row that was computed by another process or before a break lives on as text in a journal or a
/// map.
class MapSummary {
 public:
  /// `warn_over_clearances`: cells whose rotor moves farther, in clearances of the first stop, are counted.
  explicit MapSummary(double warn_over_clearances = 10) : warn_over_clearances_(warn_over_clearances) {}

  void add(std::string_view map_line);

  bool has_failed_cells() const;

  std::size_t cells() const { return total_; }
  const std::map<std::string, std::size_t>& cells_by_name() const { return by_name_; }

  /// Table for a terminal: cells per class and order, circles and ovals by the sense of their whirl, largest
  /// share first, then every status that is not `ok`, how many cells move farther than the limit, and why
  /// nothing rubs where no cell does.
  std::string text() const;

  /// One line on the cells that move too far for a linear shaft to be believed, and another that asks for the
  /// unbalance where no rotor moves so far; empty where there are none.
  std::string warning() const;

 private:
  std::string why_all_is_quiet() const;
  std::string unbalance_question() const;

  double warn_over_clearances_;
  double largest_over_clearance_ = 0;
  std::size_t far_ = 0;

  std::size_t total_ = 0, non_contact_ = 0, kicked_ = 0, stated_ = 0, touched_ = 0;
  std::map<std::string, std::size_t> by_name_, by_status_;
};

}  // namespace rubsweep::report
