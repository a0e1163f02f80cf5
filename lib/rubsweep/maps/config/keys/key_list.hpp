#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "rubsweep/maps/config/keys/form.hpp"

namespace rubsweep::config::keys {

/// One key as a person asks for it; `N` in a path stands for any number of a list.
struct KeyRow {
  std::string path;
  std::string unit, allowed, fallback, meaning,
      since;  ///< `fallback`: "required" or "one of several" where there is none
};

/// All keys of a configuration in the order of their sections, each path once.
std::vector<KeyRow> key_list(const Form& root);

/// Rows of this path and of all below it; numbers in it may be those of a list. Empty: all.
std::vector<KeyRow> below(const std::vector<KeyRow>& rows, std::string_view path);

/// Rows as a terminal shows them: the path on a line of its own, what is said of it indented below.
std::string text_of(const std::vector<KeyRow>& rows);

}  // namespace rubsweep::config::keys
