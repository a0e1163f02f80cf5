#include "rubsweep/maps/config/study/key_axis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "rubsweep/maps/config/yaml/text.hpp"

namespace rubsweep::config::study {
namespace {

constexpr std::size_t most_keys = 100;
constexpr std::string_view key_axis_forms =
    "{key: PATH, from, to, count or step} or {keys: [PATH, ...], factors: [...], values: [...]}";

void read_keys(yaml::Section& section, sweep::KeyAxis& axis) {
  section.require_exactly_one({"key", "keys"});
  if (const auto key = section.find("key")) {
    if (auto text = read_text(*key)) axis.keys.push_back(*std::move(text));
  }
  if (const auto keys = section.find("keys")) {
    for (const yaml::Value& item : read_list(*keys, most_keys).value_or(std::vector<yaml::Value>{})) {
      if (auto text = read_text(item)) axis.keys.push_back(*std::move(text));
    }
  }
  axis.factors.assign(axis.keys.size(), 1);
  if (const auto factors = section.find("factors")) {
    read_numbers(*factors, axis.factors);
    if (std::ranges::all_of(axis.factors, [](double factor) { return factor == 0; }))
      refuse(*factors, "vary nothing", "a factor that is not 0");
  }
}

void refuse_repeated_keys_of_axis(const yaml::Section& section, const sweep::KeyAxis& axis) {
  std::set<std::string> taken;
  for (const std::string& key : axis.keys) {
    if (!taken.insert(key).second)
      section.refuse_together("keys", {"keys"}, fmt::format("'{}' is there twice", yaml::shown(key)),
                              "every key once");
  }
}

void refuse_keys_of_two_axes(const yaml::Value& value, const sweep::KeyAxis& axis,
                             std::set<std::string>& taken) {
  for (const std::string& key : axis.keys) {
    if (taken.contains(key))
      refuse(value, fmt::format("'{}' is swept twice", yaml::shown(key)), "every key on one axis only");
  }
  taken.insert(axis.keys.begin(), axis.keys.end());
}

}  // namespace

sweep::KeyAxis read_key_axis(yaml::Section& section) {
  sweep::KeyAxis axis;
  read_keys(section, axis);
  refuse_repeated_keys_of_axis(section, axis);
  AxisValues read = read_axis_values(section, model::any_finite);
  axis.values = std::move(read.values);
  axis.spacing = read.spacing;
  return axis;
}

std::vector<sweep::KeyAxis> read_key_axes(yaml::Section& sweep) {
  std::vector<sweep::KeyAxis> axes;
  std::set<std::string> taken;
  for (const std::string_view name : key_axis_names) {
    const auto value = sweep.find(name);
    if (!value) continue;
    yaml::Section section(*value, key_axis_forms);
    if (!section.is_map()) continue;
    sweep::KeyAxis axis = read_key_axis(section);
    section.refuse_unknown_keys();
    refuse_keys_of_two_axes(*value, axis, taken);
    axes.push_back(std::move(axis));
  }
  return axes;
}

std::vector<keys::Key> key_axis_keys() {
  using namespace keys;
  return newer({must("key", text(), "key of a number of the configuration, as --set names it"),
                must("keys", list_of(text(), 1, most_keys), "several keys that change together"),
                may("factors", list_of(number({}), 1, most_keys), "share of each key in the value, in order",
                    "(all 1)")});
}

std::vector<keys::Choice> key_axis_choices() {
  return {{{{{"key"}, {"factors"}}, {{"keys"}, {"factors"}}}}, spaced_ways()};
}

void print_key_axis(yaml::Printer& printer, const sweep::KeyAxis& axis, AxisPrint how) {
  const bool plain = std::ranges::all_of(axis.factors, [](double factor) { return factor == 1; });
  if (axis.keys.size() == 1 && plain) {
    printer.text("key", axis.keys.front());
  } else {
    printer.texts("keys", axis.keys);
    printer.numbers("factors", axis.factors);
  }
  print_axis_values(printer, axis.values, how == AxisPrint::as_written ? axis.spacing : std::nullopt);
}

void print_key_axes(yaml::Printer& printer, const std::vector<sweep::KeyAxis>& axes, AxisPrint how) {
  for (std::size_t i = 0; i < axes.size(); ++i) {
    printer.open(key_axis_names.at(i));
    print_key_axis(printer, axes[i], how);
    printer.close();
  }
}

}  // namespace rubsweep::config::study
