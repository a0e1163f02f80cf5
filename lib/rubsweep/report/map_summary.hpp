#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>

namespace rubsweep::report {

/// Class and order of a line of map.csv: equal for cells that a refined map takes for equal.
std::string label_of(std::string_view map_line);

/// Counts the rows of a map without keeping them. They come as lines of map.csv because that is all there is
/// of them: a row that was computed by another process or before a break lives on as text in a journal or a
/// map.
class MapSummary {
 public:
  void add(std::string_view map_line);

  bool has_failed_cells() const;

  /// Table for a terminal: cells per class and order, circles and ovals by the sense of their whirl, largest
  /// share first, then every status that is not `ok`, and why nothing rubs where no cell does.
  std::string text() const;

 private:
  std::string why_all_is_quiet() const;

  std::size_t total_ = 0, non_contact_ = 0, kicked_ = 0, touched_ = 0;
  std::map<std::string, std::size_t> by_name_, by_status_;
};

}  // namespace rubsweep::report
