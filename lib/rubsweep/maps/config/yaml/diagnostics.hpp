#pragma once

#include <compare>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace rubsweep::config::yaml {

/// Place where something was written. Places are ordered by precedence: a base before the files that name it,
/// a file from top to bottom, then every --set. If two places contradict each other, the greater one
/// prevails.
struct SourcePosition {
  int override_index = -1;  ///< number of the --set, from 0; -1: written in a file
  int line = 1;             ///< line of the file, from 1
  int column = 1;           ///< byte within the line, from 1
  int file = 0;  ///< number of the file: 0 is the configuration itself, others are its bases (Diagnostics)

  bool operator==(const SourcePosition&) const = default;
  std::strong_ordering operator<=>(const SourcePosition& other) const;
};

/// Collects every problem of one configuration, so that the user meets all of them at once.
class Diagnostics {
 public:
  /// `file` and `overrides` are the names under which places are reported.
  Diagnostics(std::string file, std::vector<std::string> overrides);

  /// Adds another file, such as a base, and returns its number for SourcePosition::file. A base is added
  /// after the file that names it.
  int add_file(std::string name);

  /// Name of the file that contains `place`. Relative paths in this file start from its folder. For an
  /// override it is the configuration file.
  const std::string& file_of(const SourcePosition& place) const;

  /// Adds a problem. `path` may be empty (the whole configuration), and so may `allowed` (no advice).
  void add(const SourcePosition& place, std::string_view path, std::string_view wrong,
           std::string_view allowed);

  std::size_t count() const { return problems_.size(); }

  /// Place as text: `file:line:column`, or `--set key=value`.
  std::string describe(const SourcePosition& place) const;

  /// Throws ConfigError where there is a problem: one line for each, in the order of places,
  /// `file:line:column: path: what is wrong, allowed: what is allowed`, or `--set key=value: path: ...`.
  void throw_if_any() const;

 private:
  struct Problem {
    SourcePosition place;
    std::string text;
  };

  std::vector<std::string> files_;
  std::vector<std::string> overrides_;
  std::vector<Problem> problems_;
};

}  // namespace rubsweep::config::yaml
