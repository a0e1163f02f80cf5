#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "rubsweep/maps/config/keys/form.hpp"
#include "rubsweep/maps/config/yaml/diagnostics.hpp"
#include "rubsweep/maps/config/yaml/document.hpp"

namespace rubsweep::config::yaml {

/// Keys of maps that exclude each other (stribeck and coefficient, values and from/to/count, ...), taken from
/// the form of a configuration. A value written over a map replaces the keys that it excludes.
class Alternatives {
 public:
  Alternatives() = default;  ///< Nothing excludes anything.
  explicit Alternatives(const keys::Form& root);

  /// Removes from a map the keys that the key `written` excludes, and the keys that were useful only with
  /// them: `static` is removed together with the rest of a friction curve. The kind of the map is the one
  /// that knows most of its keys.
  void drop(Node& map, std::string_view written) const;

 private:
  /// Keys of one kind of map, and its choices between them.
  struct Kind {
    std::vector<std::string> keys;
    std::vector<keys::Choice> choices;
  };

  void gather(const keys::Form& form);

  std::vector<Kind> kinds_;
};

void drop_entry(Node& map, std::size_t index);  ///< Removes one key of a map and its value.

/// Adds a problem for every repeated key of the map at `path`.
void refuse_repeated_keys(const Node& map, std::string_view path, Diagnostics& diagnostics);

/// Keeps only the first of equal keys in a map, after the repetition was reported.
void drop_repeated_keys(Node& map);

}  // namespace rubsweep::config::yaml
