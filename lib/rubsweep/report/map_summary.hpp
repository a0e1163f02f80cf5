#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>

namespace rubsweep::report {

/// Counts the rows of a map, given as lines of map.csv, without keeping them.
class MapSummary {
 public:
  void add(std::string_view map_line);

  bool has_failed_cells() const;

  /// Table for a terminal: cells per class and order, largest share first, then every status that is not
  /// `ok`.
  std::string text() const;

 private:
  std::size_t total_ = 0;
  std::map<std::string, std::size_t> by_name_, by_status_;
};

}  // namespace rubsweep::report
