#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>

#include "rubsweep/core/response/motion/motion_class.hpp"
#include "rubsweep/maps/sweep/row.hpp"

namespace rubsweep::report {

/// Name of the motion of a row on a terminal: class, order, and kind where a class has several. A whip,
/// driven backward by its own friction, is distinguished from an oval, driven by the unbalance, and a forward
/// circle from a backward one.
std::string motion_name(const sweep::Row& row);
/// Name of the motion in a line of map.csv, as motion_name gives it for a row.
std::string motion_name(std::string_view map_line);

/// Kind of the motion in a line of map.csv. Throws IoError where the line has none.
const response::motion::MotionKind& kind_in(std::string_view map_line);

/// Class and order of a line of map.csv. A refined map treats cells as equal if these are equal.
std::string label_of(std::string_view map_line);

/// Counts the rows of a map without storing them. Takes lines of map.csv instead of rows, because a row that
/// another process or an earlier run computed exists only as text in a journal or a map.
class MapSummary {
 public:
  /// `warn_over_clearances`: cells with a larger deflection, in clearances of the first stop, are counted.
  explicit MapSummary(double warn_over_clearances = 10) : warn_over_clearances_(warn_over_clearances) {}

  void add(std::string_view map_line);

  bool has_failed_cells() const;

  std::size_t cells() const { return total_; }
  const std::map<std::string, std::size_t>& cells_by_name() const { return by_name_; }

  /// Table for a terminal: cells per class and order, with circles and ovals by their sense of whirl, the
  /// largest share first. Then every status other than `ok`, the number of cells that move farther than the
  /// limit, and, where no cell rubs, the reason.
  std::string text() const;

  /// One line on cells that move too far for a linear shaft. Above 100 clearances a second line asks whether
  /// the unbalance is right. Empty where there are no such cells.
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
