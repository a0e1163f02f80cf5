#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "rubsweep/maps/config/keys/form.hpp"

namespace rubsweep::apps {

/// One key of a configuration, as shown to a person. `N` in a path stands for any index of a list.
struct KeyRow {
  std::string path;
  std::string unit, allowed, fallback, meaning,
      since;  ///< `fallback`: "required" or "one of several" where there is none
};

/// All keys of a configuration in the order of their sections, each path once.
std::vector<KeyRow> key_list(const config::keys::Form& root);

/// Rows of the key `path` and of all keys below it. Indices of a list in `path` match `N`. All rows for an
/// empty path.
std::vector<KeyRow> below(const std::vector<KeyRow>& rows, std::string_view path);

/// Rows as a terminal shows them: the path on a line of its own, and its description indented below.
std::string text_of(const std::vector<KeyRow>& rows);

}  // namespace rubsweep::apps
