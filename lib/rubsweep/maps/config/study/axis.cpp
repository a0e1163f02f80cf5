#include "rubsweep/maps/config/study/axis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "rubsweep/maps/config/yaml/text.hpp"

namespace rubsweep::config::study {
namespace {

std::vector<double> read_values(const yaml::Value& value, const model::Range& range, double units_per_si) {
  std::vector<double> values;
  std::set<double> seen;
  for (const yaml::Value& item : read_list(value, static_cast<std::size_t>(max_axis_values))) {
    const auto number = read_number(item, range);
    if (!number) continue;
    if (!seen.insert(*number / units_per_si).second) {
      refuse(item, fmt::format("{} is listed twice", *number), "different values");
    }
    values.push_back(*number / units_per_si);
  }
  return values;
}

bool all_different_and_allowed(const std::vector<double>& values, const model::Range& range) {
  const auto allowed = [&](double value) { return model::contains(range, value); };
  return std::all_of(values.begin(), values.end(), allowed) &&
         std::set<double>(values.begin(), values.end()).size() == values.size();
}

AxisValues read_spaced(yaml::Section& section, const model::Range& range, double units_per_si) {
  Scale scale = Scale::linear;
  section.field("scale", scale, scales);
  double from = model::required;
  section.field("from", from, range);
  std::optional<double> to;
  section.field("to", to, range);
  long count = 0;
  constexpr yaml::IntegerRange counts{1, max_axis_values};
  if (section.require("count", yaml::describe(counts))) section.field("count", count, counts);
  if (!section.is_sound()) return {};
  if (!to && count != 1) section.require("to", model::describe(range));
  if (!to) return {std::vector<double>(1, from / units_per_si), std::nullopt};
  if (count == 1 && *to != from) {
    section.refuse_together("count", {"count", "to"}, "1 value cannot be both from and to",
                            "a count of 2 or more, or no to");
  }
  if (scale == Scale::log && !(std::min(from, *to) > 0)) {
    section.refuse_together("scale", {"from", "to", "scale"},
                            "a logarithmic scale has no place for 0 or less", "from and to > 0");
    return {};
  }
  const batch::Spacing spacing{from, *to, static_cast<int>(count), scale == Scale::log};
  AxisValues axis{batch::spaced(spacing, units_per_si), spacing};
  if (!all_different_and_allowed(axis.values, range)) {
    section.refuse_together("count", {"from", "to", "count"},
                            fmt::format("from {} to {} there are no {} different values", from, *to, count),
                            "from and to far enough apart");
  }
  if (count == 1) axis.spacing.reset();
  return axis;
}

/// Reads the values of {from, to, step}.
AxisValues read_stepped(yaml::Section& section, const model::Range& range, double units_per_si) {
  batch::Spacing spacing{.from = model::required, .to = model::required, .step = model::required};
  section.field("from", spacing.from, range);
  section.field("to", spacing.to, range);
  section.field("step", spacing.step, model::positive);
  for (const std::string_view name : {"count", "scale"})
    if (section.find(name)) section.refuse(name, "given beside step", axis_forms);
  if (!section.is_sound()) return {};
  const auto steps = batch::whole_steps(spacing.from, spacing.to, spacing.step);
  if (!steps) {
    const auto beside = batch::steps_beside(spacing.from, spacing.to, spacing.step);
    section.refuse_together(
        "step", {"from", "to", "step"},
        fmt::format("no whole number of steps of {} leads from {} to {}{}", spacing.step, spacing.from,
                    spacing.to, beside ? fmt::format(" (to {} or {}?)", beside->first, beside->second) : ""),
        beside ? "a step that meets both ends" : "numbers that do not span more than 15 digits");
    return {};
  }
  if (*steps >= max_axis_values) {
    section.refuse_together("step", {"from", "to", "step"}, fmt::format("gives {} values", *steps + 1),
                            fmt::format("at most {} values", max_axis_values));
    return {};
  }
  spacing.count = static_cast<int>(*steps + 1);
  AxisValues axis{batch::spaced(spacing, units_per_si), spacing};
  if (spacing.count == 1) axis.spacing.reset();
  return axis;
}

constexpr std::size_t most_keys = 100;
constexpr std::string_view key_axis_forms =
    "{key: PATH, from, to, count or step} or {keys: [PATH, ...], factors: [...], values: [...]}";

void read_keys(yaml::Section& section, sweep::KeyAxis& axis) {
  section.require_exactly_one({"key", "keys"});
  if (const auto key = section.find("key")) {
    if (auto text = read_text(*key)) axis.keys.push_back(*std::move(text));
  }
  if (const auto keys = section.find("keys")) {
    for (const yaml::Value& item : read_list(*keys, most_keys)) {
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
      section.refuse("keys", fmt::format("'{}' is there twice", yaml::shown(key)), "every key once");
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

/// Reads the values of an axis (see read_axis) from a section that has other keys, too.
AxisValues read_axis_values(yaml::Section& section, const model::Range& range, double units_per_si) {
  AxisValues result;
  if (const auto values = section.find("values")) {
    for (const std::string_view name : {"from", "to", "count", "step", "scale"}) {
      if (section.find(name)) section.refuse(name, "given beside values", axis_forms);
    }
    result.values = read_values(*values, range, units_per_si);
  } else if (section.find("step")) {
    result = read_stepped(section, range, units_per_si);
  } else if (section.is_map()) {
    result = read_spaced(section, range, units_per_si);
  }
  return result;
}

keys::Choice spaced_ways() {
  return {{{{"values"}, {}}, {{"from", "count"}, {"to", "scale"}}, {{"from", "to", "step"}, {}}}};
}

}  // namespace

AxisValues read_axis(const yaml::Value& value, const model::Range& range, double units_per_si) {
  if (value.node.kind == yaml::Node::Kind::scalar) {
    const auto number = read_number(value, range);
    if (!number) return {};
    return {std::vector<double>(1, *number / units_per_si), std::nullopt};
  }
  yaml::Section section(value, axis_forms);
  return read_axis_values(section, range, units_per_si);
}

std::vector<keys::Key> spaced_keys(const model::Range& range) {
  using namespace keys;
  Form values = list_of(number(range), 1, max_axis_values);
  values.different = true;
  return {must("from", number(range), "first value"),
          may("to", number(range), "last value, included", "(from, of a count of 1)"),
          must("count", integer(1, max_axis_values), "how many values there are, both ends included"),
          newer_key(may("scale", one_of(scales.texts),
                        "spacing: equal differences, or equal ratios of values > 0", "linear")),
          newer_key(
              must("step", number(model::positive),
                   "distance between the values, in place of their count: each is the double nearest to its "
                   "decimal")),
          must("values", std::move(values), "the values themselves, all different")};
}

keys::Form axis_form(const model::Range& range) {
  return keys::any_of({keys::number(range), keys::map_of(spaced_keys(range), {spaced_ways()})});
}

void print_axis_values(yaml::Printer& printer, const std::vector<double>& values,
                       const std::optional<batch::Spacing>& spacing, double units_per_si) {
  // Values that were changed after reading no longer agree with their spacing. They are printed as a list.
  if (!spacing || batch::spaced(*spacing, units_per_si) != values) {
    printer.numbers("values", values);
    return;
  }
  printer.number("from", spacing->from);
  printer.number("to", spacing->to);
  if (spacing->step > 0) {
    printer.number("step", spacing->step);
    return;
  }
  printer.integer("count", spacing->count);
  if (spacing->logarithmic) printer.word("scale", "log");
}

sweep::KeyAxis read_key_axis(yaml::Section& section) {
  sweep::KeyAxis axis;
  read_keys(section, axis);
  refuse_repeated_keys_of_axis(section, axis);
  AxisValues read = read_axis_values(section, model::any_finite, 1);
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
