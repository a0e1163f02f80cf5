#pragma once

#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "rubsweep/maps/sweep/row.hpp"

namespace rubsweep::machine_search {

using Rows = std::vector<sweep::Row>;
using Condition = std::function<bool(const sweep::Row&)>;

/// Speed over the natural frequency of 30 Hz that all machines of the search have.
double speed_of(const sweep::Row& row);

/// Domains of one map as scripts/analysis/domain_measures.py measures them: by areas on a linear axis of the
/// whirl ratio, on which a row reaches half way to its neighbours.
class Domains {
 public:
  explicit Domains(const Rows& map);

  double area(const Condition& belongs) const;  ///< of the cells that belong, in columns times whirl ratio
  /// Share of `part` in the area of `whole`; empty where there is nothing.
  std::optional<double> share(const Condition& part, const Condition& whole) const;
  /// Natural frequencies from the lowest to the highest row, along the line of least squares; empty for one
  /// row.
  std::optional<double> lean(const Condition& belongs) const;
  std::optional<double> least_ratio(const Condition& belongs) const;
  std::optional<double> median_speed(const Condition& belongs) const;
  /// Natural frequencies taken up in the rows from `low` to below `high`, on the mean; empty without such a
  /// row.
  std::optional<double> mean_width(const Condition& belongs, double low, double high) const;
  /// Share of the height of rows with 1/n and 1/(n + 1) in which a fifth of the cells between their medians
  /// is quiet.
  std::optional<double> parted_share(int n) const;
  /// Highest speed in each row that has one, and the lowest speed of the map.
  std::map<double, double> row_tops(const Condition& belongs) const;
  double lowest_speed() const;
  double column() const { return column_; }  ///< natural frequencies

 private:
  const Rows* map_;
  std::map<double, double> heights_;  ///< by the whirl ratio
  double column_ = 0;
};

}  // namespace rubsweep::machine_search
