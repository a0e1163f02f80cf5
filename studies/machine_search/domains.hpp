#pragma once

#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "rubsweep/maps/sweep/row.hpp"

namespace rubsweep::machine_search {

using Rows = std::vector<sweep::Row>;
using Condition = std::function<bool(const sweep::Row&)>;

/// Ratio of the speed to the natural frequency, which is 30 Hz in all machines of the search.
double speed_of(const sweep::Row& row);

/// Domains of one map, measured like scripts/analysis/domain_measures.py: by areas with a linear whirl-ratio
/// axis, on which a row extends halfway to its neighbours.
class Domains {
 public:
  explicit Domains(const Rows& map);

  double area(const Condition& belongs) const;  ///< area of these cells, in columns x whirl ratio
  /// Area of `part` / area of `whole`, both in the map; empty where `whole` has no area.
  std::optional<double> share(const Condition& part, const Condition& whole) const;
  /// Shift from the lowest to the highest row along the least-squares line, in natural frequencies; empty for
  /// a single row.
  std::optional<double> lean(const Condition& belongs) const;
  std::optional<double> least_ratio(const Condition& belongs) const;
  std::optional<double> median_speed(const Condition& belongs) const;
  /// Mean width of the rows from `low` to below `high`, in natural frequencies; empty without such a row.
  std::optional<double> mean_width(const Condition& belongs, double low, double high) const;
  /// Share of the rows with 1/n and 1/(n + 1) in which at least a fifth of the cells between their medians is
  /// quiet, by height.
  std::optional<double> parted_share(int n) const;
  /// Highest speed in each row that has one.
  std::map<double, double> row_tops(const Condition& belongs) const;
  double lowest_speed() const;
  double column() const { return column_; }  ///< width of a column, in natural frequencies

 private:
  const Rows* map_;
  std::map<double, double> heights_;  ///< height of each row; the key is its whirl ratio
  double column_ = 0;
};

}  // namespace rubsweep::machine_search
