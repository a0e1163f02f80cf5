#include "rubsweep/maps/config/yaml/differing_keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "rubsweep/maps/config/yaml/diagnostics.hpp"
#include "rubsweep/maps/config/yaml/document.hpp"
#include "rubsweep/maps/config/yaml/text.hpp"

namespace rubsweep::config::yaml {
namespace {

using Values = std::map<std::string, std::string>;

bool is_list_of_scalars(const Node& node) {
  return node.kind == Node::Kind::list &&
         std::ranges::all_of(node.items, [](const Node& item) { return item.kind == Node::Kind::scalar; });
}

std::string joined(const Node& list) {
  std::string text = "[";
  for (const Node& item : list.items) text += (text.size() > 1 ? ", " : "") + item.text;
  return text + "]";
}

void collect(const Node& node, const std::string& path, Values& values) {
  if (is_list_of_scalars(node)) {
    values[path] = joined(node);
  } else if (node.kind == Node::Kind::map || node.kind == Node::Kind::list) {
    for (std::size_t i = 0; i < node.items.size(); ++i) {
      const std::string name = node.kind == Node::Kind::map ? node.keys[i].text : std::to_string(i);
      collect(node.items[i], child_path(path, name), values);
    }
  } else {
    values[path] = node.text;
  }
}

Values values_of(std::string_view yaml) {
  Diagnostics diagnostics("study", {});
  const auto root = parse_document(yaml, -1, "", diagnostics);
  diagnostics.throw_if_any();
  Values values;
  collect(*root, "", values);
  return values;
}

/// Part of a text around its first difference, since long lists may begin with equal numbers.
std::string excerpt(const std::string& text, std::size_t first_difference) {
  constexpr std::size_t lead = 20, longest = 50;
  const std::size_t begin = text.size() <= longest || first_difference <= lead ? 0 : first_difference - lead;
  return (begin > 0 ? "..." : "") + shown(std::string_view(text).substr(begin), longest);
}

/// Numbers of a list of more than 8 numbers; empty for anything else. Shorter lists are shown as they are.
std::vector<double> numbers_of_long_list(std::string_view text) {
  constexpr std::size_t short_list = 8;
  std::vector<double> numbers;
  if (!text.starts_with('[') || !text.ends_with(']')) return numbers;
  text.remove_prefix(1);
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of(",]"), text.size());
    const ParsedNumber number = parse_number(text.substr(0, end));
    if (number.error != NumberError::none) return {};
    numbers.push_back(number.value);
    text.remove_prefix(std::min(text.size(), text.find_first_not_of(", ]", end)));
  }
  if (numbers.size() <= short_list) numbers.clear();
  return numbers;
}

/// "2000 values from 50 to 150" for a long list of evenly spaced numbers; empty for any other text.
std::string spacing_of(const std::string& text) {
  const std::vector<double> numbers = numbers_of_long_list(text);
  if (numbers.empty()) return "";
  const double step = (numbers.back() - numbers.front()) / static_cast<double>(numbers.size() - 1);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const double even = numbers.front() + step * static_cast<double>(i);
    if (std::abs(numbers[i] - even) > 1e-9 * std::abs(step)) return "";
  }
  return fmt::format("{} values from {} to {}", numbers.size(), numbers.front(), numbers.back());
}

std::string difference(const std::string& key, const std::string& there, const std::string& here) {
  const std::string spacing_there = spacing_of(there), spacing_here = spacing_of(here);
  if (!spacing_there.empty() && !spacing_here.empty() && spacing_there != spacing_here)
    return fmt::format("{}: {} there, {} here", key, spacing_there, spacing_here);
  const auto first = static_cast<std::size_t>(std::ranges::mismatch(there, here).in1 - there.begin());
  return fmt::format("{}: {} there, {} here", key, excerpt(there, first), excerpt(here, first));
}

}  // namespace

std::vector<std::string> differing_keys(std::string_view there, std::string_view here) {
  Values a = values_of(there), b = values_of(here);
  for (const auto& [key, value] : a) b.try_emplace(key, "not set");
  for (const auto& [key, value] : b) a.try_emplace(key, "not set");
  std::vector<std::string> lines;
  for (const auto& [key, value] : a) {
    if (b.at(key) != value) lines.push_back(difference(key, value, b.at(key)));
  }
  return lines;
}

}  // namespace rubsweep::config::yaml
