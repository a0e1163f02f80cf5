#include "rubsweep/maps/config/intervals.hpp"

#include <array>
#include <optional>
#include <utility>

#include "rubsweep/maps/config/file.hpp"

namespace rubsweep::config {
namespace {

void take(yaml::Node& node, const std::string& path, yaml::Diagnostics& diagnostics,
          std::vector<KeyInterval>& intervals) {
  if (yaml::entry(node, "value") == nullptr) {
    for (std::size_t i = 0; i < node.items.size(); ++i)
      take(node.items[i], path + "." + (node.keys.empty() ? std::to_string(i) : node.keys[i].text),
           diagnostics, intervals);
    return;
  }
  constexpr std::array names{"value", "from", "to"};
  std::array<double, 3> numbers{};
  bool sound = node.keys.size() == names.size();
  for (std::size_t i = 0; i < names.size(); ++i) {
    const yaml::Node* item = yaml::entry(node, names[i]);
    const std::optional<double> number = item == nullptr ? std::nullopt : yaml::number_of(*item);
    sound = sound && number;
    numbers[i] = number.value_or(0);
  }
  const auto [value, from, to] = numbers;
  if (!sound) {
    diagnostics.add(node.place, path, "is no interval", "{value: V, from: A, to: B} with three numbers");
  } else if (!(from <= value && value <= to && from < to)) {
    diagnostics.add(node.place, path, "does not hold its value", "from <= value <= to, from < to");
  }
  intervals.push_back({path, value, from, to});
  yaml::Node number = *yaml::entry(node, "value");
  node = std::move(number);
}

}  // namespace

std::vector<KeyInterval> take_intervals(yaml::Node& root, yaml::Diagnostics& diagnostics) {
  std::vector<KeyInterval> intervals;
  if (yaml::Node* rotor = yaml::entry(root, "rotor")) take(*rotor, "rotor", diagnostics, intervals);
  return intervals;
}

std::vector<KeyInterval> read_intervals(std::string_view text, const std::string& name) {
  yaml::Diagnostics diagnostics(name, {});
  std::vector<KeyInterval> intervals;
  parse_config(text, name, "a map", {}, diagnostics, run_alternatives(), &intervals);
  diagnostics.throw_if_any();
  return intervals;
}

}  // namespace rubsweep::config
