#pragma once

#include <string>
#include <vector>

#include "rubsweep/page/map_table.hpp"

namespace rubsweep::page {

/// A column of a map as the page reads it.
struct EncodedColumn {
  std::vector<std::string> words;  ///< the different words in the order of their first row; empty: numbers
  std::string data;  ///< compressed byte planes: 8 bytes a number (IEEE 754, NaN where empty), or
                     ///< 4 bytes a word, its place in `words`
};

EncodedColumn encode_column(const MapColumn& column);

}  // namespace rubsweep::page
