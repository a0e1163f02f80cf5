#include "rubsweep/maps/config/yaml/value.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "rubsweep/core/model/range.hpp"
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
  if (node.kind != Node::Kind::scalar) {
    refuse(value, describe(node), allowed);
    return std::nullopt;
  }
  if (node.quoted) {
    refuse(value, fmt::format("{} is text in quotes, not {}", describe(node), noun), allowed);
    return std::nullopt;
  }
  const ParsedNumber number = parse_number(node.text);
  switch (number.error) {
    case NumberError::none:
      return number.value;
    case NumberError::not_a_number:
      if (const auto meant = with_decimal_point(node.text)) {
        refuse(value, fmt::format("{} has a decimal comma", describe(node)),
               fmt::format("{}, as in {}", allowed, *meant));
        break;
      }
      refuse(value, fmt::format("{} is not {}", describe(node), noun), allowed);
      break;
    case NumberError::not_finite:
      refuse(value, fmt::format("{} is not finite", describe(node)), allowed);
      break;
    case NumberError::does_not_fit:
      refuse(value, fmt::format("{} does not fit a double", describe(node)), allowed);
      break;
  }
  return std::nullopt;
}

}  // namespace

std::string describe(const IntegerRange& range) {
  return fmt::format("{} from {} to {}", range.even ? "an even integer" : "an integer", range.low,
                     range.high);
}

std::string describe(std::span<const std::string_view> words) {
  return fmt::format("{}", fmt::join(words, ", "));
}

void refuse(const Value& value, std::string_view wrong, std::string_view allowed) {
  const std::string subject = value.path.empty() ? "the configuration " : "";
  value.diagnostics.add(value.node.place, value.path, subject + std::string(wrong), allowed);
}

std::string describe(const Node& node) {
  switch (node.kind) {
    case Node::Kind::list:
      return "is a list";
    case Node::Kind::map:
      return "is a map";
    case Node::Kind::scalar:
      if (const auto blank = find_foreign_blank(node.text)) {
        return fmt::format("'{}' with {}", shown(node.text),
                           describe_character(std::string_view(node.text).substr(*blank)));
      }
      return fmt::format("'{}'", shown(node.text));
    case Node::Kind::null:
      break;
  }
  return "has no value";
}

std::string describe_unknown(std::string_view text, std::span<const std::string_view> names) {
  const auto meant = nearest(text, names);
  return fmt::format("'{}' is unknown{}", shown(text),
                     meant ? fmt::format(" (did you mean '{}'?)", *meant) : "");
}

std::optional<double> read_number(const Value& value, const model::Range& range) {
  const auto number = read_finite(value, "a number", model::describe(range));
  if (number && !model::contains(range, *number)) {
    refuse(value, fmt::format("{} is out of range", shown(value.node.text)), model::describe(range, *number));
    return std::nullopt;
  }
  return number;
}

std::optional<long> read_integer(const Value& value, const IntegerRange& range) {
  const std::string allowed = describe(range);
  const auto number = read_finite(value, "an integer", allowed);
  if (!number) return std::nullopt;
  const std::string text = shown(value.node.text);
  if (std::trunc(*number) != *number) {
    refuse(value, fmt::format("{} is not an integer", text), allowed);
  } else if (*number < static_cast<double>(range.low) || *number > static_cast<double>(range.high)) {
    refuse(value, fmt::format("{} is out of range", text), allowed);
  } else if (range.even && std::fmod(*number, 2) != 0) {
    refuse(value, fmt::format("{} is odd", text), allowed);
  } else {
    return static_cast<long>(*number);
  }
  return std::nullopt;
}

bool read_numbers(const Value& value, std::span<double> target) {
  const Node& node = value.node;
  if (node.kind != Node::Kind::list || node.items.size() != target.size()) {
    const std::string wrong = node.kind == Node::Kind::list
                                  ? fmt::format("holds {} values", node.items.size())
                              : node.kind == Node::Kind::scalar ? describe(node) + " is not a list"
                                                                : describe(node);
    refuse(value, wrong, fmt::format("a list of {} numbers", target.size()));
    return false;
  }
  bool good = true;
  for (std::size_t i = 0; i < target.size(); ++i) {
    const Value item{node.items[i], fmt::format("{}.{}", value.path, i), value.diagnostics};
    const auto number = read_number(item, model::any_finite);
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
  if (node.kind != Node::Kind::scalar) {
    refuse(value, describe(node), allowed);
    return std::nullopt;
  }
  const auto found = std::find(words.begin(), words.end(), node.text);
  if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
  refuse(value, describe_unknown(node.text, words), allowed);
  return std::nullopt;
}

std::optional<std::string> read_text(const Value& value) {
  const Node& node = value.node;
  const std::string allowed = fmt::format("a text of 1 to {} bytes", max_text_bytes);
  if (node.kind != Node::Kind::scalar) {
    refuse(value, describe(node), allowed);
  } else if (node.text.empty() || node.text.size() > max_text_bytes) {
    refuse(value, node.text.empty() ? "is empty" : "is too long", allowed);
  } else if (node.text.find('\0') != std::string::npos) {
    refuse(value, "holds a NUL byte", allowed);
  } else {
    return node.text;
  }
  return std::nullopt;
}

std::optional<std::vector<Value>> read_list(const Value& value, std::size_t longest) {
  const Node& node = value.node;
  const std::string allowed = fmt::format("a list of 1 to {} values", longest);
  if (node.kind != Node::Kind::list) {
    refuse(value, node.kind == Node::Kind::scalar ? describe(node) + " is not a list" : describe(node),
           allowed);
    return std::nullopt;
  }
  if (node.items.empty() || node.items.size() > longest) {
    refuse(value, node.items.empty() ? "is empty" : fmt::format("holds {} values", node.items.size()),
           allowed);
    return std::nullopt;
  }
  std::vector<Value> items;
  for (std::size_t i = 0; i < node.items.size(); ++i) {
    items.push_back({node.items[i], fmt::format("{}.{}", value.path, i), value.diagnostics});
  }
  return items;
}

std::vector<double> read_number_list(const Value& value, const model::Range& range, std::size_t longest) {
  std::vector<double> numbers;
  const auto items = read_list(value, longest);
  if (!items) return numbers;
  for (const Value& item : *items) {
    if (const auto number = read_number(item, range)) numbers.push_back(*number);
  }
  return numbers;
}

}  // namespace rubsweep::config::yaml
