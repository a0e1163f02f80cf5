#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "rubsweep/core/model/key.hpp"
#include "rubsweep/core/model/range.hpp"
#include "rubsweep/maps/config/yaml/diagnostics.hpp"
#include "rubsweep/maps/config/yaml/document.hpp"

namespace rubsweep::config::yaml {

/// One value of a configuration, its dotted path and the diagnostics for its problems. Refers to node and
/// diagnostics, and owns neither.
struct Value {
  const Node& node;
  std::string path;
  Diagnostics& diagnostics;

  /// Value number `index` of a list or a map.
  Value at(std::size_t index) const;
};

using model::IntegerRange;

/// Allowed values in words, as they follow "allowed: " in a message.
std::string describe(const IntegerRange& range);
std::string describe(std::span<const std::string_view> words);

/// Adds a problem at the value's place. `wrong` ends a sentence about the value. Returns an empty result.
std::nullopt_t refuse(const Value& value, std::string_view wrong, std::string_view allowed);

/// Description of a node that is not what was wanted: "has no value", "is a list", "is a map" or "'text'".
std::string describe(const Node& node);

/// Number in a scalar that is not quoted; empty for anything else.
std::optional<double> number_of(const Node& node);

/// Text of a problem, such as "'wrod' is unknown (did you mean 'word'?)".
std::string describe_unknown(std::string_view text, std::span<const std::string_view> names);

/// All readers below return an empty result after they added a problem.
std::optional<double> read_number(const Value& value, const model::Range& range);
std::optional<long> read_integer(const Value& value, const IntegerRange& range);

/// Reads a list of as many finite numbers as `target` has; false after it added a problem.
bool read_numbers(const Value& value, std::span<double> target);

/// Index of the given word in `words`. `allowed` describes all that may stand there, if that is more than
/// these words.
std::optional<std::size_t> read_word(const Value& value, std::span<const std::string_view> words);
std::optional<std::size_t> read_word(const Value& value, std::span<const std::string_view> words,
                                     std::string_view allowed);

/// Any scalar as it is written. It must not be empty or have a NUL, and is at most `max_text_bytes` long.
std::optional<std::string> read_text(const Value& value);
inline constexpr std::size_t max_text_bytes = 4096;

/// Items of a list of 1 to `longest` values; none after a problem.
std::vector<Value> read_list(const Value& value, std::size_t longest);

/// Numbers of a list of 1 to `longest` values, each within `range`, without those that added a problem.
std::vector<double> read_number_list(const Value& value, const model::Range& range, std::size_t longest);

}  // namespace rubsweep::config::yaml
