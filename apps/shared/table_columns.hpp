#pragma once

#include <string_view>

namespace rubsweep::apps {

/// Columns of the tables of all programs, and the words that may stand in them, as CSV
/// (shared/table_columns.csv). Of map.csv it lists only the columns with words;
/// `report::describe_map_columns` describes all its columns.
extern const std::string_view table_columns;

}  // namespace rubsweep::apps
