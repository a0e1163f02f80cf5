#include "rubsweep/maps/config/yaml/value.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "rubsweep/maps/config/yaml/text.hpp"

namespace rubsweep::config::yaml {
namespace {

/// "1.5" for "1,5"; empty where the result is no number.
std::optional<std::string> with_decimal_point(std::string text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string::npos) return std::nullopt;
  text[comma] = '.';
  if (parse_number(text).error != NumberError::none) return std::nullopt;
  return text;
}

std::optional<double> read_finite(const Value& value, std::string_view noun, std::string_view allowed) {
  const Node& node = value.node;
  if (node.kind != Node::Kind::scalar) return refuse(value, describe(node), allowed);
  if (node.quoted)
    return refuse(value, fmt::format("{} is text in quotes, not {}", describe(node), noun), allowed);
  const ParsedNumber number = parse_number(node.text);
  switch (number.error) {
    case NumberError::none: return number.value;
    case NumberError::not_a_number:
      if (const auto meant = with_decimal_point(node.text))
        return refuse(value, fmt::format("{} has a decimal comma", describe(node)),
                      fmt::format("{}, as in {}", allowed, *meant));
      return refuse(value, fmt::format("{} is not {}", describe(node), noun), allowed);
    case NumberError::not_finite:
      return refuse(value, fmt::format("{} is not finite", describe(node)), allowed);
    case NumberError::does_not_fit: break;
  }
  return refuse(value, fmt::format("{} does not fit a double", describe(node)), allowed);
}

/// Description of a node where a list was wanted.
std::string describe_no_list(const Node& node) {
  return node.kind == Node::Kind::scalar ? describe(node) + " is not a list" : describe(node);
}

}  // namespace

Value Value::at(std::size_t index) const {
  const bool map = node.kind == Node::Kind::map;
  return {node.items[index], child_path(path, map ? node.keys[index].text : std::to_string(index)),
          diagnostics};
}

std::string describe(const IntegerRange& range) {
  return fmt::format("{} from {} to {}", range.even ? "an even integer" : "an integer", range.low,
                     range.high);
}

std::string describe(std::span<const std::string_view> words) {
  return fmt::format("{}", fmt::join(words, ", "));
}

std::nullopt_t refuse(const Value& value, std::string_view wrong, std::string_view allowed) {
  const std::string subject = value.path.empty() ? "the configuration " : "";
  value.diagnostics.add(value.node.place, value.path, subject + std::string(wrong), allowed);
  return std::nullopt;
}

std::string describe(const Node& node) {
  switch (node.kind) {
    case Node::Kind::list: return "is a list";
    case Node::Kind::map: return "is a map";
    case Node::Kind::scalar:
      if (const auto blank = find_foreign_blank(node.text)) {
        return fmt::format("'{}' with {}", shown(node.text),
                           describe_character(std::string_view(node.text).substr(*blank)));
      }
      return fmt::format("'{}'", shown(node.text));
    case Node::Kind::null: break;
  }
  return "has no value";
}

std::optional<double> number_of(const Node& node) {
  const ParsedNumber number = parse_number(node.text);
  const bool found = node.kind == Node::Kind::scalar && !node.quoted && number.error == NumberError::none;
  return found ? std::optional(number.value) : std::nullopt;
}

std::string describe_unknown(std::string_view text, std::span<const std::string_view> names) {
  const auto meant = nearest(text, names);
  return fmt::format("'{}' is unknown{}", shown(text),
                     meant ? fmt::format(" (did you mean '{}'?)", *meant) : "");
}

std::optional<double> read_number(const Value& value, const model::Range& range) {
  const auto number = read_finite(value, "a number", model::describe(range));
  if (!number || model::contains(range, *number)) return number;
  return refuse(value, fmt::format("{} is out of range", shown(value.node.text)),
                model::describe(range, *number));
}

std::optional<long> read_integer(const Value& value, const IntegerRange& range) {
  const std::string allowed = describe(range);
  const auto number = read_finite(value, "an integer", allowed);
  if (!number) return std::nullopt;
  const std::string text = shown(value.node.text);
  if (std::trunc(*number) != *number)
    return refuse(value, fmt::format("{} is not an integer", text), allowed);
  if (*number < static_cast<double>(range.low) || *number > static_cast<double>(range.high))
    return refuse(value, fmt::format("{} is out of range", text), allowed);
  if (range.even && std::fmod(*number, 2) != 0) return refuse(value, fmt::format("{} is odd", text), allowed);
  return static_cast<long>(*number);
}

bool read_numbers(const Value& value, std::span<double> target) {
  const Node& node = value.node;
  if (node.kind != Node::Kind::list || node.items.size() != target.size()) {
    refuse(value,
           node.kind == Node::Kind::list ? fmt::format("holds {} values", node.items.size())
                                         : describe_no_list(node),
           fmt::format("a list of {} numbers", target.size()));
    return false;
  }
  bool good = true;
  for (std::size_t i = 0; i < target.size(); ++i) {
    const auto number = read_number(value.at(i), model::any_finite);
    if (number) target[i] = *number;
    good = good && number.has_value();
  }
  return good;
}

std::optional<std::size_t> read_word(const Value& value, std::span<const std::string_view> words) {
  return read_word(value, words, describe(words));
}

std::optional<std::size_t> read_word(const Value& value, std::span<const std::string_view> words,
                                     std::string_view allowed) {
  const Node& node = value.node;
  if (node.kind != Node::Kind::scalar) return refuse(value, describe(node), allowed);
  const auto found = std::find(words.begin(), words.end(), node.text);
  if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
  return refuse(value, describe_unknown(node.text, words), allowed);
}

std::optional<std::string> read_text(const Value& value) {
  const Node& node = value.node;
  const std::string allowed = fmt::format("a text of 1 to {} bytes", max_text_bytes);
  if (node.kind != Node::Kind::scalar) return refuse(value, describe(node), allowed);
  if (node.text.empty() || node.text.size() > max_text_bytes)
    return refuse(value, node.text.empty() ? "is empty" : "is too long", allowed);
  if (node.text.find('\0') != std::string::npos) return refuse(value, "holds a NUL byte", allowed);
  return node.text;
}

std::vector<Value> read_list(const Value& value, std::size_t longest) {
  const Node& node = value.node;
  const std::string allowed = fmt::format("a list of 1 to {} values", longest);
  std::vector<Value> items;
  if (node.kind != Node::Kind::list) {
    refuse(value, describe_no_list(node), allowed);
  } else if (node.items.empty() || node.items.size() > longest) {
    refuse(value, node.items.empty() ? "is empty" : fmt::format("holds {} values", node.items.size()),
           allowed);
  } else {
    for (std::size_t i = 0; i < node.items.size(); ++i) items.push_back(value.at(i));
  }
  return items;
}

std::vector<double> read_number_list(const Value& value, const model::Range& range, std::size_t longest) {
  std::vector<double> numbers;
  for (const Value& item : read_list(value, longest)) {
    if (const auto number = read_number(item, range)) numbers.push_back(*number);
  }
  return numbers;
}

}  // namespace rubsweep::config::yaml
