#include "rubsweep/maps/config/study/axis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "rubsweep/maps/batch/decimal_steps.hpp"

namespace rubsweep::config::study {
namespace {

std::vector<double> read_values(const yaml::Value& value, const model::Range& range, double units_per_si) {
  std::vector<double> values;
  const auto items = read_list(value, static_cast<std::size_t>(max_axis_values));
  if (!items) return values;
  std::set<double> seen;
  for (const yaml::Value& item : *items) {
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

/// The values of {from, to, step}.
AxisValues read_stepped(yaml::Section& section, const model::Range& range, double units_per_si) {
  batch::Spacing spacing{.from = model::required, .to = model::required, .step = model::required};
  section.field("from", spacing.from, range);
  section.field("to", spacing.to, range);
  section.field("step", spacing.step, model::positive);
  for (const std::string_view name : {"count", "scale"})
    if (section.find(name)) section.refuse_together(name, {name}, "given beside step", axis_forms);
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

}  // namespace

AxisValues read_axis_values(yaml::Section& section, const model::Range& range, double units_per_si) {
  AxisValues result;
  if (const auto values = section.find("values")) {
    for (const std::string_view name : {"from", "to", "count", "step", "scale"}) {
      if (section.find(name)) section.refuse_together(name, {name}, "given beside values", axis_forms);
    }
    result.values = read_values(*values, range, units_per_si);
  } else if (section.find("step")) {
    result = read_stepped(section, range, units_per_si);
  } else if (section.is_map()) {
    result = read_spaced(section, range, units_per_si);
  }
  return result;
}

AxisValues read_axis(const yaml::Value& value, const model::Range& range, double units_per_si) {
  if (value.node.kind == yaml::Node::Kind::scalar) {
    const auto number = read_number(value, range);
    if (!number) return {};
    return {std::vector<double>(1, *number / units_per_si), std::nullopt};
  }
  yaml::Section section(value, axis_forms);
  AxisValues result = read_axis_values(section, range, units_per_si);
  section.refuse_unknown_keys();
  return result;
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

keys::Choice spaced_ways() {
  return {{{{"values"}, {}}, {{"from", "count"}, {"to", "scale"}}, {{"from", "to", "step"}, {}}}};
}

keys::Form axis_form(const model::Range& range) {
  return keys::any_of({keys::number(range), keys::map_of(spaced_keys(range), {spaced_ways()})});
}

void print_axis_values(yaml::Printer& printer, const std::vector<double>& values,
                       const std::optional<batch::Spacing>& spacing, double units_per_si) {
  // Whoever changed the values since may not have changed how they were written.
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

}  // namespace rubsweep::config::study
