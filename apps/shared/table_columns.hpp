#pragma once

#include <string_view>

namespace rubsweep::apps {

/// Columns of the tables of all programs, and the words that may stand in them, as CSV:
/// shared/table_columns.csv. Columns of map.csv are there only where they have words:
/// `report::describe_map_columns` describes all.
extern const std::string_view table_columns;

}  // namespace rubsweep::apps
